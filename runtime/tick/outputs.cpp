#include "runtime/tick/outputs.h"

namespace rob::runtime {

using motion::Effect;

namespace {

std::uint64_t bit_of(int channel) noexcept { return std::uint64_t{1} << channel; }

}  // namespace

void Outputs::set(int channel, bool on) noexcept {
  pulses_.forget(channel);
  switch_to(channel, on);
}

void Outputs::set_analog(int channel, double volts) noexcept {
  analog_[static_cast<std::size_t>(channel)] = motion::within_analog_range(volts);
  channels_.analog_outputs.store(analog_);
}

void Outputs::begin_pulse(const Effect& pulse, double now) noexcept {
  pulses_.begin(pulse, now);
  switch_to(pulse.channel, true);
}

const Effect* Outputs::end_pulse(double now) noexcept {
  const Effect* const over = pulses_.take_over(now);
  if (over != nullptr) switch_to(over->channel, false);
  return over;
}

bool Outputs::locked(const Effect& effect) const noexcept {
  switch (effect.kind) {
    case Effect::Kind::Output:
    case Effect::Kind::Pulse:
      return (locked_ & bit_of(effect.channel)) != 0;
    case Effect::Kind::Analog:
      return (analog_locked_ & bit_of(effect.channel)) != 0;
    default:
      return false;
  }
}

void Outputs::lock(const Effect& effect) noexcept {
  (effect.kind == Effect::Kind::Analog ? analog_locked_ : locked_) |= bit_of(effect.channel);
}

void Outputs::switch_to(int channel, bool on) noexcept {
  digital_ = on ? digital_ | bit_of(channel) : digital_ & ~bit_of(channel);
  channels_.outputs.store(digital_, std::memory_order_relaxed);
}

}  // namespace rob::runtime
