#include "runtime/command/axis_targets.h"

#include <algorithm>

#include "base/unit_factors.h"
#include "lang/machine/move_pose.h"
#include "motion/plan/reach.h"
#include "runtime/words/pose_values.h"

namespace rob::runtime {

namespace {

/// A whole pose must have the c that its place gives, where the axes leave that to it; straight up
/// and down it is refused, too, unless the axes make it as they stand.
std::optional<Words> words_against_c(const motion::RobotModel& robot, const lang::PoseValue& pose,
                                     const lang::MoveCommand& command,
                                     const lang::Setting& setting) {
  constexpr double kSame = 0.01 * kDegree;
  if (robot.kinematics->freedom() != motion::Freedom::C) return std::nullopt;
  if (command.means != lang::MoveCommand::Target::Pose || command.relative) return std::nullopt;
  const auto axes = static_cast<std::size_t>(robot.axis_count());
  const motion::JointVector q = joints_of(std::span(command.target).first(axes));
  const lang::PoseValue reached = tool_at(robot, q, setting);
  if (lang::pose_math::turn(reached, pose) <= kSame) return std::nullopt;
  return words_for_other_c(robot, pose, lang::pose_math::to_fixed(reached.rotation).c);
}

}  // namespace

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
  auto words = axes_for(robot, pose, setting, near, command.target);
  if (!words) words = words_against_c(robot, pose, command, setting);
  command.means = lang::MoveCommand::Target::Axes;
  command.relative = false;
  command.count = robot.axis_count();
  command.given = lang::given_all(command.count);
  return words;
}

}  // namespace rob::runtime
