#include "runtime/command/axis_targets.h"

#include <algorithm>

#include "lang/machine/move_pose.h"
#include "motion/plan/reach.h"
#include "runtime/words/pose_values.h"

namespace rob::runtime {

motion::JointVector joints_of(std::span<const double> axes) {
  motion::JointVector q(static_cast<Eigen::Index>(axes.size()));
  std::ranges::copy(axes, q.begin());
  return q;
}

lang::PoseValue tool_at(const motion::RobotModel& robot, const motion::JointVector& q,
                        const lang::Setting& setting) {
  return lang::tip_of(to_lang(robot.kinematics->forward(q)), setting);
}

std::optional<Words> axes_for(const motion::RobotModel& robot, const lang::PoseValue& pose,
                              const lang::Setting& setting, const motion::JointVector& near,
                              std::span<double> joints) {
  const motion::Pose flange = to_motion(lang::flange_for(pose, setting));
  const auto q = motion::reach(robot, flange, near);
  if (!q) {
    std::optional<lang::PoseValue> nearest;
    if (const auto closest = robot.kinematics->closest(flange, near))
      nearest = tool_at(robot, *closest, setting);
    return words_for_unreachable(robot, pose, robot.kinematics->shortfall(flange), nearest);
  }
  std::ranges::transform(*q, joints.begin(), [](double axis) { return axis + 0.0; });
  return std::nullopt;
}

std::optional<Words> settle_on_axes(const motion::RobotModel& robot, const lang::PoseValue& pose,
                                    const motion::JointVector& near, lang::MoveCommand& command,
                                    const lang::Setting& setting) {
  const auto words = axes_for(robot, pose, setting, near, command.target);
  command.means = lang::MoveCommand::Target::Axes;
  command.relative = false;
  command.count = robot.axis_count();
  command.given = lang::given_all(command.count);
  return words;
}

}  // namespace rob::runtime
