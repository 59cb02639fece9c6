#include "motion/plan/reach.h"

#include "motion/plan/feasibility.h"

namespace rob::motion {
namespace {

bool within_limits(const RobotModel& robot, const JointVector& q) noexcept {
  std::array<double, kMaxJoints> target{};
  for (int i = 0; i < robot.axis_count(); ++i) target[static_cast<std::size_t>(i)] = q[i];
  return !check_target(robot, 0xff, target);
}

}  // namespace

JointVector middle(const RobotModel& robot) noexcept {
  JointVector q(robot.axis_count());
  for (int i = 0; i < robot.axis_count(); ++i) {
    const Axis& axis = robot.axes[static_cast<std::size_t>(i)];
    q[i] = (axis.min + axis.max) / 2;
  }
  return q;
}

std::optional<JointVector> reach(const RobotModel& robot, const Pose& pose,
                                 const JointVector& near) noexcept {
  const auto nearest = robot.kinematics->inverse(pose, near);
  if (!nearest || within_limits(robot, *nearest)) return nearest;
  const auto other = robot.kinematics->inverse(pose, middle(robot));
  return other && within_limits(robot, *other) ? other : nearest;
}

}  // namespace rob::motion
