#pragma once

#include <algorithm>
#include <array>

namespace rob::motion {

/// Analog channels a robot can have each way. [choice] two common modules of eight.
inline constexpr int kMostAnalog = 16;

/// The most that an analog channel carries, V; at least 0. [choice] the range of nearly all
/// modules.
inline constexpr double kAnalogRange = 10;

/// The volts of all analog channels of one direction, by channel number from 0.
using AnalogValues = std::array<double, kMostAnalog>;

/// The voltage that the channel carries when it is asked for `volts`. May be used in the tick.
inline double within_analog_range(double volts) noexcept {
  return std::clamp(volts, 0.0, kAnalogRange);
}

}  // namespace rob::motion
