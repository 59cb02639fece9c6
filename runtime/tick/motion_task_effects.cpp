#include "runtime/tick/motion_task.h"

/// Member functions of MotionTask that carry out effects: outputs, pulses, what is simulated.
namespace rob::runtime {

using motion::Effect;
using motion::MotionEvent;

/// A signal script in the place of somebody who watches the run.
void MotionTask::take_interventions() noexcept {
  using Kind = Intervention::Kind;
  ScriptedOperator& scripted = simulated_.scripted_operator();
  const ScriptedOperator::Request asked = scripted.take();
  if (safe_) return;  // it has come to rest for good, or is about to
  const auto tell_of = [&](Kind kind, double share = 1) {
    channels_.interventions.push({now_, kind, share});
  };
  if (asked.share > 0) {
    set_override(asked.share);
    tell_of(Kind::Override, asked.share);
  }
  if (asked.hold) {
    channels_.pause.set(*asked.hold);
    tell_of(*asked.hold ? Kind::Hold : Kind::GoOn);
  }
  const bool forgotten = asked.hold && scripted.holds_for_ever();
  if (!asked.stop && !forgotten) return;
  tell_of(asked.stop ? Kind::Stop : Kind::Forgotten);
  channels_.stop.hold.store(true, std::memory_order_relaxed);
}

/// What TASKs have done in the cycle before.
void MotionTask::take_immediate() noexcept {
  Effect effect;
  while (channels_.immediate.take(effect)) {
    if (faulted_ || locked(effect)) continue;
    act(effect, now_);
    tell({.kind = MotionEvent::Kind::EffectDue, .time = now_, .tag = effect.tag, .effect = effect});
  }
}

bool MotionTask::locked(const Effect& effect) const noexcept {
  const std::uint64_t bit = std::uint64_t{1} << effect.channel;
  switch (effect.kind) {
    case Effect::Kind::Output:
    case Effect::Kind::Pulse:
      return (locked_ & bit) != 0;
    case Effect::Kind::Analog:
      return (analog_locked_ & bit) != 0;
    default:
      return false;
  }
}

void MotionTask::lock(const Effect& effect) noexcept {
  const std::uint64_t bit = std::uint64_t{1} << effect.channel;
  (effect.kind == Effect::Kind::Analog ? analog_locked_ : locked_) |= bit;
}

void MotionTask::take_safe_values() noexcept {
  if (safe_) return;
  safe_ = true;
  for (const Effect& effect : channels_.safe) {
    if (locked(effect)) continue;  // a failed program has taken it already
    act(effect, now_);
    tell({.kind = MotionEvent::Kind::ActionDue, .time = now_, .tag = effect.tag, .effect = effect});
  }
}

void MotionTask::act(const Effect& effect, double now) noexcept {
  if (effect.safe) lock(effect);
  switch (effect.kind) {
    case Effect::Kind::Output:
      pulses_.forget(effect.channel);
      return switch_output(effect.channel, effect.value);
    case Effect::Kind::Pulse:
      pulses_.begin(effect, now);
      return switch_output(effect.channel, true);
    case Effect::Kind::Analog:
      analog_outputs_[effect.channel] = motion::within_analog_range(effect.volts);
      return channels_.analog_outputs.store(analog_outputs_);
    case Effect::Kind::Simulate:
      return simulate({WorldSignal::Kind::Input, effect.channel}, effect.value ? 1 : 0,
                      now + effect.seconds);
    case Effect::Kind::SimulateAnalog:
      return simulate({WorldSignal::Kind::AnalogInput, effect.channel}, effect.volts,
                      now + effect.seconds);
    case Effect::Kind::SimulateForce:
      return simulate({WorldSignal::Kind::Force, effect.channel}, effect.volts,
                      now + effect.seconds);
    case Effect::Kind::ZeroForce:
      gauge_.zero();
      return latch_inputs(now_);
    case Effect::Kind::Override:
      return set_override(effect.share);
    case Effect::Kind::Load:
      return channels_.carried.store(effect.carried, std::memory_order_release);
    case Effect::Kind::SimulateGo:
      return simulate({WorldSignal::Kind::Go, 0}, 1, now + effect.seconds);
    case Effect::Kind::SimulateAnswer:
      return simulate({WorldSignal::Kind::Answer, 0}, 0, now + effect.seconds, effect.id);
    case Effect::Kind::Report:
      channels_.reports.push({effect.id, false});  // there is room: RobotMachine has counted
      return;
    case Effect::Kind::Note:
    case Effect::Kind::Arm:
    case Effect::Kind::Disarm:
      return;
  }
}

/// What holds from now on is seen in this cycle already.
void MotionTask::simulate(WorldSignal place, double value, double time,
                          std::uint32_t answer) noexcept {
  simulated_.schedule({place, value, answer}, time);  // RobotMachine has counted: there is room
  latch_inputs(now_);
}

void MotionTask::switch_output(int channel, bool on) noexcept {
  const std::uint64_t bit = std::uint64_t{1} << channel;
  outputs_ = on ? outputs_ | bit : outputs_ & ~bit;
  channels_.outputs.store(outputs_, std::memory_order_relaxed);
}

void MotionTask::end_pulses(double now) noexcept {
  while (const Effect* over = pulses_.take_over(now)) {
    switch_output(over->channel, false);
    tell({.kind = MotionEvent::Kind::PulseOver, .time = now_, .tag = over->tag, .effect = *over});
  }
}

}  // namespace rob::runtime
