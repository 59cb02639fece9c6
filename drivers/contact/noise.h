#pragma once

#include <cstdint>

#include "base/split_mix.h"

namespace rob::drivers {

/// Noise that is the same everywhere for the same seed: numbers of SplitMix, and sums of twelve of
/// them (Irwin and Hall), which take no function of a library. May be used in the tick.
class Noise {
 public:
  explicit Noise(std::uint64_t seed) noexcept : random_(seed) {}

  double between(double low, double high) noexcept { return low + random_.share() * (high - low); }
  /// Mean 0, standard deviation 1, nearly normal; within ±6.
  double normal() noexcept {
    double sum = -6;
    for (int i = 0; i < 12; ++i) sum += random_.share();
    return sum;
  }

 private:
  SplitMix random_;
};

}  // namespace rob::drivers
