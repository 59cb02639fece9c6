#include "motion/plan/whole_pose.h"

#include <cmath>
#include <utility>

#include "motion/path/way_cost.h"
#include "motion/plan/reach.h"

namespace rob::motion {

namespace {

std::optional<RobotModel> with_nothing_open(const RobotModel& robot) {
  auto kinematics = robot.kinematics->leaving(Freedom::None, {});
  if (kinematics == nullptr) return std::nullopt;
  RobotModel whole = robot;
  whole.kinematics = std::move(kinematics);
  return whole;
}

bool is_upright(const Pose& pose) {
  constexpr double kUpright = 1.5e-8;  // 1 − cos 0.01°
  return std::abs((pose.orientation * Eigen::Vector3d::UnitZ()).z()) >= 1 - kUpright;
}

}  // namespace

bool leaves_open(const RobotModel& robot) noexcept {
  return robot.kinematics->freedom() != Freedom::None;
}

std::optional<JointVector> reach_whole(const RobotModel& robot, const Pose& pose,
                                       const JointVector& near) {
  const auto whole = with_nothing_open(robot);
  if (!whole) return std::nullopt;
  const auto q = reach(*whole, pose, near);
  return q && axes_within(robot, *q) ? q : std::nullopt;
}

std::optional<RobotModel> upright_along(const RobotModel& robot, const ToolPath& path) {
  constexpr int kPlaces = 64;
  if (!leaves_open(robot)) return std::nullopt;
  for (int k = 0; k <= kPlaces; ++k) {
    const double s = path.begin() + (path.end() - path.begin()) * k / kPlaces;
    if (!is_upright(path.at(s))) return std::nullopt;
  }
  return with_nothing_open(robot);
}

}  // namespace rob::motion
