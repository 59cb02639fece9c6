#include "lang/values/dimension.h"

#include <algorithm>
#include <limits>

namespace rob::lang {

namespace {

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

}  // namespace rob::lang
