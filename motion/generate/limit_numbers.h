#pragma once

#include <algorithm>
#include <cstdint>

/// The limit that holds the speed, as the trace numbers it (docs/cli.md).
namespace rob::motion::limit_number {

inline constexpr std::uint8_t kNone = 0;
inline constexpr std::uint8_t kPace = 1;           ///< AT or OVER
inline constexpr std::uint8_t kSpeed = 2;          ///< + axis
inline constexpr std::uint8_t kAcceleration = 10;  ///< + axis
inline constexpr std::uint8_t kEndOfBuffer = 20;
inline constexpr std::uint8_t kOverride = 21;
inline constexpr std::uint8_t kReach = 22;
inline constexpr std::uint8_t kBody = 23;       ///< a jog would come too near to one
inline constexpr std::uint8_t kEndOfAxis = 30;  ///< + axis

inline std::uint8_t of_axis(std::uint8_t first, int axis) noexcept {
  return static_cast<std::uint8_t>(first + std::max(axis, 0));
}

}  // namespace rob::motion::limit_number
