#pragma once

#include <cstdint>

#include "lang/machine/robot_signature.h"
#include "motion/plan/segment_descriptor.h"
#include "runtime/tick/channels.h"

namespace rob::runtime {

/// An effect on an output; the caller adds the value.
inline motion::Effect effect_on(const lang::RobotSignature::Signal& signal, int line) {
  motion::Effect effect;
  effect.tag = static_cast<motion::Tag>(line);
  effect.channel = static_cast<std::uint8_t>(signal.channel - 1);
  return effect;
}

/// The value of a digital signal in the current cycle, or of an analog one, V.
inline bool digital_value(const Channels& channels, const lang::RobotSignature::Signal& signal) {
  const std::uint64_t bits = signal.output ? channels.outputs.load(std::memory_order_relaxed)
                                           : channels.inputs.load(std::memory_order_relaxed);
  return (bits >> (signal.channel - 1) & 1U) != 0;
}
/// The values of `count` channels from `first` on, in one look; the first is the lowest bit.
inline std::int64_t group_value(const Channels& channels, const lang::RobotSignature::Signal& first,
                                int count) {
  const std::uint64_t bits = first.output ? channels.outputs.load(std::memory_order_relaxed)
                                          : channels.inputs.load(std::memory_order_relaxed);
  const std::uint64_t mask = (std::uint64_t{1} << count) - 1;
  return static_cast<std::int64_t>(bits >> (first.channel - 1) & mask);
}
inline double analog_value(const Channels& channels, const lang::RobotSignature::Signal& signal) {
  const AnalogCells& cells = signal.output ? channels.analog_outputs : channels.analog_inputs;
  return cells.at(signal.channel - 1);
}

}  // namespace rob::runtime
