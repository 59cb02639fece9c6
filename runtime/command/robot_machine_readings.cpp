#include <algorithm>
#include <optional>

#include "lang/machine/move_pose.h"
#include "lang/values/pose_slots.h"
#include "motion/plan/reach.h"
#include "motion/space/cycle_instant.h"
#include "runtime/command/robot_machine.h"
#include "runtime/words/force_words.h"
#include "runtime/words/messages.h"
#include "runtime/words/pose_values.h"

/// Member functions of RobotMachine that tell where the robot is, and where it would be.
namespace rob::runtime {

using lang::Reading;
using lang::Reply;

namespace {

motion::JointVector joints_of(std::span<const double> joints) {
  motion::JointVector q(static_cast<Eigen::Index>(joints.size()));
  std::ranges::copy(joints, q.begin());
  return q;
}

/// Axis values for a pose, or why there are none.
std::optional<Words> axes_for(const motion::RobotModel& robot, const lang::PoseValue& pose,
                              const lang::Setting& setting, const motion::JointVector& near,
                              std::span<double> joints) {
  const motion::Pose flange = to_motion(lang::flange_for(pose, setting));
  const auto q = motion::reach(robot, flange, near);
  if (!q) return words_for_unreachable(robot, pose, robot.kinematics->shortfall(flange));
  std::ranges::transform(*q, joints.begin(), [](double axis) { return axis + 0.0; });
  return std::nullopt;
}

}  // namespace

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

/// Behind an exact motion no blend is lost by waiting until the axes stand, and only then are they
/// where the program sent them.
bool RobotMachine::place_can_be_read() const { return observable() && (!exact_ || stands()); }

Reply RobotMachine::read(int /*line*/, Reading what, lang::Slot* value) {
  if (is_observation(what) && !place_can_be_read()) return Reply::Later;
  if (what == Reading::Target && !rested()) return Reply::Later;
  return present(what, value);
}

Reply RobotMachine::present(Reading what, lang::Slot* value) {
  if (needs_sensor(what)) return felt(what, value);
  const motion::JointVector q = is_observation(what)       ? channels_.joints.load()
                                : what == Reading::HitPose ? hit_
                                                           : planner_.commanded();
  switch (what) {
    case Reading::Clock: {
      const std::int64_t cycle = channels_.cycle.load(std::memory_order_relaxed);
      value->real = motion::cycle_instant(cycle, robot_.reference_period);
      return Reply::Done;
    }
    case Reading::Joints:
      for (const double axis : q) (value++)->real = axis + 0.0;
      return Reply::Done;
    default:
      break;
  }
  lang::store(tool_at(q), value);
  return Reply::Done;
}

/// A sensor tells something with the first servo cycle.
Reply RobotMachine::felt(Reading what, lang::Slot* value) {
  constexpr std::int64_t kFirstCycles = 3;
  const motion::JointVector wrench = channels_.wrench.load();
  if (wrench.size() > 0) {
    store_wrench(what, wrench.head<3>(), wrench.tail<3>(), value);
    return Reply::Done;
  }
  if (channels_.cycle.load(std::memory_order_relaxed) < kFirstCycles) return Reply::Later;
  return refuse(words_for_no_sensor(robot_));
}

lang::PoseValue RobotMachine::tool_at(const motion::JointVector& q) const {
  return lang::tip_of(to_lang(robot_.kinematics->forward(q)), setting_);
}

/// HERE was read just before, at rest: the axes are still told to stand where it was.
Reply RobotMachine::teach(int /*line*/, const lang::TaughtPoint& point) {
  if (keeper_ == nullptr) return Reply::Done;
  const motion::JointVector q = channels_.joints.load();
  const auto refusal = keeper_->keep(point, {q.data(), static_cast<std::size_t>(q.size())});
  if (!refusal) return Reply::Done;
  refuse(*refusal);
  return Reply::Refused;
}

Reply RobotMachine::forward(int /*line*/, std::span<const double> joints, lang::PoseValue& pose) {
  pose = tool_at(joints_of(joints));
  return Reply::Done;
}

Reply RobotMachine::inverse(int /*line*/, const lang::PoseValue& pose, std::span<const double> near,
                            std::span<double> joints) {
  if (near.empty() && !rested()) return Reply::Later;
  const motion::JointVector from = near.empty() ? planner_.commanded() : joints_of(near);
  if (const auto words = axes_for(robot_, pose, setting_, from, joints)) {
    refuse(*words);
    return Reply::Refused;
  }
  return Reply::Done;
}

/// A pose becomes the axis values that bring the tip there; and so does a tuple where it is not
/// the axis values themselves.
Reply RobotMachine::settle_target(lang::MoveCommand& command) {
  using Target = lang::MoveCommand::Target;
  if (command.means == Target::Axes) return Reply::Done;
  const bool of_axes = command.means == Target::Coordinates && !robot_.tool_coordinates;
  if (of_axes && lang::is_plain(setting_)) return Reply::Done;
  const lang::PoseValue last = tool_at(planner_.commanded());
  lang::PoseValue pose = lang::target_pose(command, last, setting_, signature_.coordinates);
  if (pressing_ != Pressing::No) pose = to_lang(across_press(to_motion(pose), command));
  if (const auto words = settle_on_axes(robot_, pose, near(command), command, setting_)) {
    refuse(*words);
    return Reply::Refused;
  }
  return Reply::Done;
}

/// Of all axis values that bring the tip to a target, a tuple means those that turn as far as it
/// says: MOVE BY (0, 0, 270) does not become 90 degrees the other way.
motion::JointVector RobotMachine::near(const lang::MoveCommand& command) const {
  motion::JointVector q = planner_.commanded();
  if (command.means != lang::MoveCommand::Target::Coordinates || robot_.tool_coordinates) return q;
  const double turned = lang::pose_math::to_fixed(setting_.frame.rotation).c -
                        lang::pose_math::to_fixed(setting_.tool.tip.rotation).c;
  for (int i = 0; i < robot_.axis_count(); ++i) {
    const auto index = static_cast<std::size_t>(i);
    const bool same = index < signature_.coordinates.size() &&
                      signature_.coordinates[index].name == robot_.axes[index].name;
    if (!same || !command.has(i) || robot_.axes[index].kind != motion::AxisKind::Rotary) continue;
    const bool from_last = command.relative || setting_.in_tool;
    q[i] = command.target[index] + (from_last ? q[i] : turned);
  }
  return q;
}

}  // namespace rob::runtime
