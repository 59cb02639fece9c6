#include "runtime/tick/effects.h"

namespace rob::runtime {

using motion::Effect;
using motion::MotionEvent;

void Effects::take_immediate(double now, bool dropped) noexcept {
  Effect effect;
  while (channels_.immediate.take(effect)) {
    if (dropped || locked(effect)) continue;
    act(effect, now);
    channels_.tell(
        {.kind = MotionEvent::Kind::EffectDue, .time = now, .tag = effect.tag, .effect = effect});
  }
}

void Effects::take_safe_values(double now) noexcept {
  for (const Effect& effect : channels_.safe) {
    if (locked(effect)) continue;  // a failed program has taken it already
    act(effect, now);
    channels_.tell(
        {.kind = MotionEvent::Kind::ActionDue, .time = now, .tag = effect.tag, .effect = effect});
  }
}

void Effects::end_pulses(double until, double now) noexcept {
  while (const Effect* const over = outputs_.end_pulse(until))
    channels_.tell(
        {.kind = MotionEvent::Kind::PulseOver, .time = now, .tag = over->tag, .effect = *over});
}

void Effects::act(const Effect& effect, double now) noexcept {
  if (effect.safe) outputs_.lock(effect);
  switch (effect.kind) {
    case Effect::Kind::Output:
      return outputs_.set(effect.channel, effect.value);
    case Effect::Kind::Pulse:
      return outputs_.begin_pulse(effect, now);
    case Effect::Kind::Analog:
      return outputs_.set_analog(effect.channel, effect.volts);
    case Effect::Kind::Simulate:
    case Effect::Kind::SimulateAnalog:
    case Effect::Kind::SimulateForce:
    case Effect::Kind::SimulateGo:
    case Effect::Kind::SimulateAnswer:
      return simulate(effect, now);
    case Effect::Kind::ZeroForce:
      return inputs_.zero_force(now);
    case Effect::Kind::Override:
      return speed_.set_override(effect.share);
    case Effect::Kind::Load:
      return channels_.carried.store(effect.carried, std::memory_order_release);
    case Effect::Kind::Report:
      channels_.reports.push({effect.id, false});  // there is room: RobotMachine has counted
      return;
    case Effect::Kind::Note:
    case Effect::Kind::Arm:
    case Effect::Kind::Disarm:
      return;
  }
}

void Effects::simulate(const Effect& effect, double now) noexcept {
  const auto set = [&](WorldSignal place, double value, std::uint32_t answer = 0) {
    inputs_.simulate({place, value, answer}, now + effect.seconds, now);
  };
  switch (effect.kind) {
    case Effect::Kind::SimulateAnalog:
      return set({WorldSignal::Kind::AnalogInput, effect.channel}, effect.volts);
    case Effect::Kind::SimulateForce:
      return set({WorldSignal::Kind::Force, effect.channel}, effect.volts);
    case Effect::Kind::SimulateGo:
      return set({WorldSignal::Kind::Go, 0}, 1);
    case Effect::Kind::SimulateAnswer:
      return set({WorldSignal::Kind::Answer, 0}, 0, effect.id);
    default:
      return set({WorldSignal::Kind::Input, effect.channel}, effect.value ? 1 : 0);
  }
}

}  // namespace rob::runtime
