#include "motion/robots/quantity.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <system_error>

#include "base/unit_factors.h"
#include "motion/robots/quoted.h"

namespace rob::motion {

namespace {

/// SI = value · times / over. Powers of ten stand in `over`, because a division by an exact
/// number is rounded once: 9/1000 is the double nearest to 0.009, 9·0.001 need not be.
struct Unit {
  Quantity quantity;
  std::string_view name;
  double times;
  double over;
};

/// The first of each quantity is its SI unit.
constexpr Unit kUnits[] = {
    {Quantity::Length, "m", 1, 1},
    {Quantity::Length, "mm", 1, 1e3},
    {Quantity::Length, "um", 1, 1e6},
    {Quantity::Angle, "rad", 1, 1},
    {Quantity::Angle, "deg", kDegree, 1},
    {Quantity::Time, "s", 1, 1},
    {Quantity::Time, "ms", 1, 1e3},
    {Quantity::Time, "us", 1, 1e6},
    {Quantity::Speed, "m/s", 1, 1},
    {Quantity::Speed, "mm/s", 1, 1e3},
    {Quantity::AngularSpeed, "rad/s", 1, 1},
    {Quantity::AngularSpeed, "deg/s", kDegree, 1},
    {Quantity::Acceleration, "m/s^2", 1, 1},
    {Quantity::Acceleration, "mm/s^2", 1, 1e3},
    {Quantity::AngularAcceleration, "rad/s^2", 1, 1},
    {Quantity::AngularAcceleration, "deg/s^2", kDegree, 1},
    {Quantity::Jerk, "m/s^3", 1, 1},
    {Quantity::Jerk, "mm/s^3", 1, 1e3},
    {Quantity::AngularJerk, "rad/s^3", 1, 1},
    {Quantity::AngularJerk, "deg/s^3", kDegree, 1},
    {Quantity::Mass, "kg", 1, 1},
    {Quantity::Inertia, "kg*m^2", 1, 1},
    {Quantity::Force, "N", 1, 1},
    {Quantity::Torque, "Nm", 1, 1},
    {Quantity::LinearFriction, "N*s/m", 1, 1},
    {Quantity::RotaryFriction, "Nm*s/rad", 1, 1},
    {Quantity::Bandwidth, "rad/s", 1, 1},
    {Quantity::Stiffness, "N/m", 1, 1},
    {Quantity::Stiffness, "N/mm", 1e3, 1},
    {Quantity::TorsionStiffness, "Nm/rad", 1, 1},
};

std::string units_of(Quantity quantity) {
  std::string list;
  for (const Unit& unit : kUnits) {
    if (unit.quantity != quantity) continue;
    if (!list.empty()) list += ", ";
    list += unit.name;
  }
  return list;
}

[[noreturn]] void refuse(std::string_view text, const std::string& why, Quantity quantity) {
  throw std::invalid_argument(quoted(text) + " " + why + "; write a number and one of the units " +
                              units_of(quantity));
}

}  // namespace

double parse_quantity(std::string_view text, Quantity quantity) {
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  const std::size_t first = text.starts_with('-') ? 1 : 0;
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  // from_chars also reads "inf" and "nan".
  if (text.size() <= first || !is_digit(text[first]) || error == std::errc::invalid_argument)
    refuse(text, "does not begin with a number", quantity);
  if (error != std::errc{}) refuse(text, "is beyond what a number can be", quantity);

  std::string_view name = text.substr(static_cast<std::size_t>(end - text.data()));
  name.remove_prefix(std::min(name.find_first_not_of(' '), name.size()));
  if (name.empty()) refuse(text, "has no unit", quantity);
  bool known = false;
  for (const Unit& unit : kUnits) {
    if (unit.name != name) continue;
    if (unit.quantity == quantity) return value * unit.times / unit.over;
    known = true;
  }
  refuse(text, known ? "has a unit of something else" : "has an unknown unit", quantity);
}

std::string_view si_unit(Quantity quantity) {
  return std::find_if(std::begin(kUnits), std::end(kUnits),
                      [&](const Unit& unit) { return unit.quantity == quantity; })
      ->name;
}

}  // namespace rob::motion
