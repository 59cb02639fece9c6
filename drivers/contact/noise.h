#pragma once

#include <cstdint>

namespace rob::drivers {

/// Noise that is the same everywhere for the same seed: SplitMix64 (Steele, Lea and Flood 2014),
/// and of its numbers sums of twelve (Irwin and Hall), which take no function of a library. May be
/// used in the tick.
class Noise {
 public:
  explicit Noise(std::uint64_t seed) noexcept : state_(seed) {}

  /// In [0, 1), a multiple of 2^-53.
  double share() noexcept { return static_cast<double>(next() >> 11) * 0x1p-53; }
  double between(double low, double high) noexcept { return low + share() * (high - low); }
  /// Mean 0, standard deviation 1, nearly normal; within ±6.
  double normal() noexcept {
    double sum = -6;
    for (int i = 0; i < 12; ++i) sum += share();
    return sum;
  }

 private:
  std::uint64_t next() noexcept {
    state_ += 0x9E3779B97F4A7C15U;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9U;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBU;
    return z ^ (z >> 31);
  }

  std::uint64_t state_;
};

}  // namespace rob::drivers
