#include "lang/vm/scripted_robot.h"

#include <algorithm>
#include <utility>

#include "lang/machine/cartesian_axes.h"
#include "lang/machine/move_pose.h"
#include "lang/values/pose_slots.h"

namespace rob::lang {

void ScriptedRobot::script(int signal, std::vector<double> values) {
  scripts_[signal] = {.values = std::move(values)};
}

double ScriptedRobot::value_of(int signal) {
  Script& script = scripts_[signal];
  if (script.values.empty()) return written_[signal];
  const double value = script.values[script.next];
  if (script.next + 1 < script.values.size()) ++script.next;
  return value;
}

/// A spiral ends at its centre and a JOG somewhere: neither is followed.
std::optional<ScriptedRobot::Coordinates> ScriptedRobot::target_of(
    const MoveCommand& command) const {
  Coordinates target = at_;
  if (command.kind == MotionKind::Spiral || command.kind == MotionKind::Jog) return target;
  const bool tuple = command.means == MoveCommand::Target::Coordinates;
  if (command.means == MoveCommand::Target::Pose || (tuple && !is_plain(setting_))) {
    const PoseValue pose = target_pose(command, forward(at_), setting_, robot_.coordinates);
    return inverse(pose, target) ? std::optional(target) : std::nullopt;
  }
  for (std::size_t i = 0; i < static_cast<std::size_t>(command.count); ++i) {
    if (!command.has(static_cast<int>(i))) continue;
    target[i] = command.target[i] + (command.relative ? at_[i] : 0);
  }
  return target;
}

PoseValue ScriptedRobot::forward(std::span<const double> joints) const {
  return tip_of(tool_of(robot_.coordinates, joints), setting_);
}

bool ScriptedRobot::inverse(const PoseValue& pose, std::span<double> joints) const {
  return coordinates_of(robot_.coordinates, flange_for(pose, setting_), joints);
}

void ScriptedRobot::read(Reading what, const Setting& setting, Slot* value) {
  if (what == Reading::Clock) {
    value->real = now();
  } else if (what == Reading::Unix || what == Reading::Now) {
    value[0].real = kVirtualStart + now();
    if (what == Reading::Now) value[1].real = 0;
  } else if (what == Reading::Joints) {
    for (std::size_t i = 0; i < robot_.axes.size(); ++i) value[i].real = at_[i];
  } else if (needs_sensor(what)) {
    const int first = what == Reading::Torque ? 3 : 0;
    const int count = slots_of(what, 0);
    for (int i = 0; i < count; ++i) (value++)->real = value_of(force_part(first + i));
  } else {
    const PoseValue tool = tool_of(robot_.coordinates, what == Reading::HitPose ? hit_ : at_);
    store(tip_of(tool, setting), value);
  }
}

WatchResult ScriptedRobot::watch(const Watch& condition) {
  struct World final : WatchedWorld {
    ScriptedRobot& robot;
    explicit World(ScriptedRobot& r) : robot(r) {}
    bool signal(int signal) const noexcept override { return robot.value_of(signal) != 0; }
    double analog(int signal) const noexcept override { return robot.value_of(signal); }
    void read(Reading what, Slot* value) const noexcept override { robot.read(what, {}, value); }
  };
  std::size_t looks = 1;
  for (const auto& [signal, script] : scripts_) looks = std::max(looks, script.values.size());
  WatchResult result;
  for (std::size_t look = 0; look < looks && result.value.integer == 0; ++look) {
    result = evaluate(condition, World(*this));
    if (result.error != ArithmeticError::None) return result;
  }
  hit_ = at_;
  return result;
}

double ScriptedRobot::stand() {
  if (standing_) ++cycle_;
  standing_ = true;
  return now();
}

double ScriptedRobot::now() const {
  constexpr double kPeriod = 0.01;  // s
  return kPeriod * cycle_;
}

}  // namespace rob::lang
