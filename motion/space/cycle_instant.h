#pragma once

#include <cmath>
#include <cstdint>

namespace rob::motion {

/// s. Instants that differ by less are one: rounding of sums of times, days long.
inline constexpr double kSameInstant = 1e-9;

/// The instant k·T at which cycle k begins, s since the start of the run. Where T is a whole number
/// of nanoseconds, as in 10 ms, this is the double nearest to the decimal: 15.28 for k = 1528,
/// where the product 1528 · 0.01 is 15.280000000000001. Exact up to 2^53 ns, 104 days.
inline double cycle_instant(std::int64_t cycle, double period) noexcept {
  constexpr double kNanoseconds = 1e9;  // in a second
  const double whole = std::round(period * kNanoseconds);
  const auto k = static_cast<double>(cycle);
  return whole / kNanoseconds == period ? k * whole / kNanoseconds : k * period;
}

}  // namespace rob::motion
