#pragma once

#include <cstdint>

namespace rob {

/// SplitMix64 (Steele, Lea and Flood 2014): numbers that are the same everywhere for the same seed.
/// Its whole state is one number, so that a copy draws the same numbers again. Not for secrets. May
/// be used in the tick.
class SplitMix {
 public:
  explicit SplitMix(std::uint64_t seed) noexcept : state_(seed) {}

  std::uint64_t next() noexcept {
    state_ += 0x9E3779B97F4A7C15U;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9U;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBU;
    return z ^ (z >> 31);
  }
  /// In [0, 1), a multiple of 2^-53.
  double share() noexcept { return static_cast<double>(next() >> 11) * 0x1p-53; }

 private:
  std::uint64_t state_;
};

}  // namespace rob
