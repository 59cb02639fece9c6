#pragma once

#include <cstdint>

#include "motion/plan/segment_descriptor.h"
#include "motion/space/analog_channels.h"
#include "runtime/tick/channels.h"
#include "runtime/tick/pulses.h"

namespace rob::runtime {

/// The outputs of the robot. One that has taken its SAFE value for good is locked. Every call may
/// be used in the tick.
class Outputs {
 public:
  explicit Outputs(Channels& channels) noexcept : channels_(channels) {}

  /// Bit i is output channel i.
  std::uint64_t digital() const noexcept { return digital_; }
  /// V.
  const motion::AnalogValues& analog() const noexcept { return analog_; }

  /// Takes the place of a PULSE that is under way.
  void set(int channel, bool on) noexcept;
  /// V; it is set to what the channel carries.
  void set_analog(int channel, double volts) noexcept;
  void begin_pulse(const motion::Effect& pulse, double now) noexcept;
  bool pulsing() const noexcept { return pulses_.any(); }
  /// Switches off the next output whose PULSE is over at `now`; null if there is none. The pointer
  /// is valid until the next call.
  const motion::Effect* end_pulse(double now) noexcept;

  /// Whether the effect is on an output that is locked.
  bool locked(const motion::Effect& effect) const noexcept;
  void lock(const motion::Effect& effect) noexcept;

 private:
  void switch_to(int channel, bool on) noexcept;

  Channels& channels_;
  std::uint64_t digital_ = 0;
  motion::AnalogValues analog_{};
  std::uint64_t locked_ = 0;  ///< bit i: channel i
  std::uint64_t analog_locked_ = 0;
  Pulses pulses_;
};

}  // namespace rob::runtime
