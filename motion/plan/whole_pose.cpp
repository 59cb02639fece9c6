#include "motion/plan/whole_pose.h"

#include <cmath>
#include <utility>

#include "motion/path/way_cost.h"
#include "motion/plan/reach.h"

namespace rob::motion {

namespace {

std::optional<RobotModel> leaving_open(const RobotModel& robot, Freedom freedom, const Pose& tip) {
  auto kinematics = robot.kinematics->leaving(freedom, tip);
  if (kinematics == nullptr) return std::nullopt;
  RobotModel other = robot;
  other.kinematics = std::move(kinematics);
  return other;
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
  const auto whole = leaving_open(robot, Freedom::None, {});
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
  return leaving_open(robot, Freedom::None, {});
}

std::optional<RobotModel> tip_as_flange(const RobotModel& robot, const Pose& tip) {
  const bool flange = tip.position.isZero(0) && tip.orientation.vec().isZero(0);
  return flange ? std::nullopt : leaving_open(robot, robot.kinematics->freedom(), tip);
}

}  // namespace rob::motion
