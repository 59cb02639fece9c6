#pragma once

#include <cmath>
#include <cstdint>

#include "lang/values/arithmetic.h"

namespace rob::lang {

/// The numbers of RANDOM: SplitMix64 (Steele, Lea and Flood 2014), the same everywhere for the same
/// seed. Its whole state is one number, so that an expression that has to start anew draws the same
/// numbers again. Not for secrets.
class Random {
 public:
  /// [choice] what a run without --seed begins with: such runs are alike too.
  static constexpr std::uint64_t kDefaultSeed = 1;

  explicit Random(std::uint64_t seed) : state_(seed) {}

  /// In [0, 1), a multiple of 2^-53.
  double share() { return static_cast<double>(next() >> 11) * 0x1p-53; }

  /// From `low` to `high`, both among them.
  ArithmeticError between(std::int64_t low, std::int64_t high, std::int64_t& result) {
    if (low > high) return ArithmeticError::RangeReversed;
    const std::uint64_t count =
        static_cast<std::uint64_t>(high) - static_cast<std::uint64_t>(low) + 1;
    std::uint64_t drawn = next();
    if (count != 0) {  // 0: all of INT
      // Numbers above the last whole multiple of count would make some more likely.
      const std::uint64_t leftover = (0 - count) % count;
      while (drawn < leftover) drawn = next();
      drawn %= count;
    }
    result = static_cast<std::int64_t>(static_cast<std::uint64_t>(low) + drawn);
    return ArithmeticError::None;
  }

  /// In [low, high); `low` where both are equal.
  ArithmeticError between(double low, double high, double& result) {
    if (low > high) return ArithmeticError::RangeReversed;
    if (!std::isfinite(high - low)) return ArithmeticError::NotFinite;
    result = low + share() * (high - low) + 0.0;
    if (result >= high && low < high) result = std::nextafter(high, low) + 0.0;
    return ArithmeticError::None;
  }

 private:
  std::uint64_t next() {
    state_ += 0x9E3779B97F4A7C15U;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9U;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBU;
    return z ^ (z >> 31);
  }

  std::uint64_t state_;
};

}  // namespace rob::lang
