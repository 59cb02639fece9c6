#pragma once

#include <compare>
#include <cstdint>

namespace rob::lang {

/// The dimension of a quantity: the exponents of length, mass, time, angle and voltage.
/// Angle is a dimension of its own (rad is not 1), so that a bare number is never taken for one.
struct Dimension {
  std::int8_t length = 0;
  std::int8_t mass = 0;
  std::int8_t time = 0;
  std::int8_t angle = 0;
  std::int8_t voltage = 0;

  auto operator<=>(const Dimension&) const = default;
  bool none() const { return *this == Dimension{}; }
};

Dimension operator*(Dimension a, Dimension b);
Dimension operator/(Dimension a, Dimension b);
Dimension power(Dimension base, int exponent);

inline constexpr Dimension kNone{};
inline constexpr Dimension kLength{.length = 1};
inline constexpr Dimension kMass{.mass = 1};
inline constexpr Dimension kTime{.time = 1};
inline constexpr Dimension kAngle{.angle = 1};
inline constexpr Dimension kVoltage{.voltage = 1};
inline constexpr Dimension kSpeed{.length = 1, .time = -1};
inline constexpr Dimension kAngularSpeed{.time = -1, .angle = 1};
inline constexpr Dimension kAcceleration{.length = 1, .time = -2};
inline constexpr Dimension kAngularAcceleration{.time = -2, .angle = 1};
inline constexpr Dimension kJerk{.length = 1, .time = -3};
inline constexpr Dimension kAngularJerk{.time = -3, .angle = 1};
inline constexpr Dimension kForce{.length = 1, .mass = 1, .time = -2};
inline constexpr Dimension kTorque{.length = 2, .mass = 1, .time = -2};
inline constexpr Dimension kFrequency{.time = -1};

}  // namespace rob::lang
