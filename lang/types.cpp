#include "lang/types.h"

#include <algorithm>
#include <array>
#include <limits>
#include <string_view>

#include "lang/units.h"

namespace rob::lang {
namespace {

struct NamedDimension {
  Dimension dimension;
  std::string_view words;
};

constexpr std::array kNamedDimensions = std::to_array<NamedDimension>({
    {kNone, "a plain number"},
    {kLength, "a length"},
    {kAngle, "an angle"},
    {kTime, "a time"},
    {kSpeed, "a speed"},
    {kAngularSpeed, "an angular speed"},
    {kAcceleration, "an acceleration"},
    {kAngularAcceleration, "an angular acceleration"},
    {kJerk, "a jerk"},
    {kAngularJerk, "an angular jerk"},
    {kForce, "a force"},
    {kTorque, "a torque"},
    {kMass, "a mass"},
    {kFrequency, "a frequency"},
    {kVoltage, "a voltage"},
});

/// An exponent beyond the type's range sticks at its end; the checker refuses such quantities
/// long before that (kMostExponent).
std::int8_t saturated(int exponent) {
  using Limits = std::numeric_limits<std::int8_t>;
  return static_cast<std::int8_t>(std::clamp(exponent, int{Limits::min()}, int{Limits::max()}));
}

template <typename Combine>
Dimension combine(Dimension a, Dimension b, Combine exponent) {
  return {.length = saturated(exponent(a.length, b.length)),
          .mass = saturated(exponent(a.mass, b.mass)),
          .time = saturated(exponent(a.time, b.time)),
          .angle = saturated(exponent(a.angle, b.angle)),
          .voltage = saturated(exponent(a.voltage, b.voltage))};
}

}  // namespace

Dimension operator*(Dimension a, Dimension b) {
  return combine(a, b, [](int x, int y) { return x + y; });
}

Dimension operator/(Dimension a, Dimension b) {
  return combine(a, b, [](int x, int y) { return x - y; });
}

Dimension power(Dimension base, int exponent) {
  // More than the exponents' range cannot be kept apart anyway, and could overflow the product.
  const int bounded = std::clamp(exponent, -256, 256);
  return combine(base, {}, [bounded](int x, int) { return x * bounded; });
}

std::string in_words(Dimension dimension) {
  const auto* const named = std::find_if(
      kNamedDimensions.begin(), kNamedDimensions.end(),
      [dimension](const NamedDimension& entry) { return entry.dimension == dimension; });
  if (named != kNamedDimensions.end()) return std::string(named->words);
  return "a [" + unit_text(dimension) + "]";
}

std::string in_words(const Type& type) {
  switch (type.kind) {
    case Type::Kind::Unknown:
      return "something unknown";
    case Type::Kind::Bool:
      return "TRUE or FALSE";
    case Type::Kind::Int:
      return "a whole number";
    case Type::Kind::Real:
      return in_words(type.dimension);
    case Type::Kind::String:
      return "a text";
  }
  return {};
}

}  // namespace rob::lang
