#pragma once

#include <string>
#include <string_view>

namespace rob::motion {

/// The quantity that a number in a robot file measures; each has its own units.
enum class Quantity {
  Length,
  Angle,
  Time,
  Speed,
  AngularSpeed,
  Acceleration,
  AngularAcceleration,
  Jerk,
  AngularJerk,
  Mass,
  Inertia,
  Force,
  Torque,
  LinearFriction,
  RotaryFriction,
  Bandwidth,
  Stiffness,
  TorsionStiffness
};

/// "20 mm/s" as SI: a decimal number, spaces, a unit of that quantity. The result is the double
/// nearest to the written value, except for degrees. Throws std::invalid_argument with one line
/// that says what is wrong and which units there are.
double parse_quantity(std::string_view text, Quantity quantity);

/// The SI unit, for messages.
std::string_view si_unit(Quantity quantity);

}  // namespace rob::motion
