#include "runtime/command/axis_targets.h"

#include <algorithm>

#include "lang/machine/move_pose.h"
#include "motion/plan/reach.h"
#include "motion/plan/whole_pose.h"
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
                              std::span<double> joints,
                              const std::optional<motion::FreeTurn>& free) {
  const motion::Pose flange = to_motion(lang::flange_for(pose, setting));
  const auto tipped = motion::tip_as_flange(robot, to_motion(setting.tool.tip));
  const auto q =
      free ? motion::reach_freely(robot, to_motion(pose), to_motion(setting.tool.tip), *free, near)
      : tipped ? motion::reach(*tipped, to_motion(pose), near)
               : motion::reach(robot, flange, near);
  if (!q && free) return words_for_unreachable(robot, pose, free->kind);
  if (!q) {
    std::optional<lang::PoseValue> nearest;
    if (const auto closest = robot.kinematics->closest(flange, near))
      nearest = tool_at(robot, *closest, setting);
    return words_for_unreachable(robot, pose, robot.kinematics->shortfall(flange), nearest);
  }
  std::ranges::transform(*q, joints.begin(), [](double axis) { return axis + 0.0; });
  return std::nullopt;
}

std::optional<motion::FreeTurn> free_turn_of(const lang::MoveCommand& command,
                                             const motion::Pose& frame) {
  using lang::FreeTurn;
  if (command.free == FreeTurn::None) return std::nullopt;
  if (command.free == FreeTurn::Spin) return motion::FreeTurn{motion::Freedom::Spin};
  motion::FreeTurn free{motion::Freedom::C, frame.orientation * Eigen::Vector3d::UnitZ()};
  if (const auto& own = command.free_axis) free.axis = {own->x, own->y, own->z};
  return free;
}

bool says_whole(const lang::MoveCommand& command) {
  return command.means == lang::MoveCommand::Target::Pose && !command.relative &&
         command.free == lang::FreeTurn::None;
}

std::optional<Words> words_against_c(const motion::RobotModel& robot, const lang::PoseValue& pose,
                                     const lang::PoseValue& reached) {
  if (!motion::leaves_open(robot)) return std::nullopt;
  if (lang::pose_math::turn(reached, pose) <= motion::kOtherTurn) return std::nullopt;
  return words_for_other_c(robot, pose, lang::pose_math::to_fixed(reached.rotation).c);
}

std::optional<Words> settle_on_axes(const motion::RobotModel& robot, const lang::PoseValue& pose,
                                    const motion::JointVector& near, lang::MoveCommand& command,
                                    const lang::Setting& setting,
                                    const std::optional<motion::FreeTurn>& free) {
  const bool whole = says_whole(command) && motion::leaves_open(robot);
  const motion::Pose flange = to_motion(lang::flange_for(pose, setting));
  std::optional<Words> words;
  if (const auto q = whole ? motion::reach_whole(robot, flange, near) : std::nullopt) {
    std::ranges::copy(*q, command.target.begin());
  } else {
    words = axes_for(robot, pose, setting, near, command.target, free);
    const auto axes = static_cast<std::size_t>(robot.axis_count());
    const motion::JointVector reached = joints_of(std::span(command.target).first(axes));
    if (whole && !words) words = words_against_c(robot, pose, tool_at(robot, reached, setting));
  }
  command.means = lang::MoveCommand::Target::Axes;
  command.relative = false;
  command.count = robot.axis_count();
  command.given = lang::given_all(command.count);
  return words;
}

}  // namespace rob::runtime
