#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include "motion/plan/segment_descriptor.h"
#include "motion/space/cycle_instant.h"

namespace rob::runtime {

/// The PULSEs that are under way, at most one an output channel. A further one of the same output
/// prolongs it; an assignment in between takes its place. Every call may be used in the tick.
class Pulses {
 public:
  void begin(const motion::Effect& pulse, double now) noexcept {
    Pulse& entry = pulses_[pulse.channel];
    const double end = now + pulse.seconds;
    if (!under_way(pulse.channel) || end > entry.end) entry = {pulse, end};
    under_way_ |= bit(pulse.channel);
  }
  void forget(int channel) noexcept { under_way_ &= ~bit(channel); }
  bool any() const noexcept { return under_way_ != 0; }

  /// Takes one that is over at `now`, the lowest channel first; null if there is none. The pointer
  /// is valid until the next call.
  const motion::Effect* take_over(double now) noexcept {
    for (std::uint64_t left = under_way_; left != 0; left &= left - 1) {
      const int channel = std::countr_zero(left);
      Pulse& entry = pulses_[static_cast<std::size_t>(channel)];
      if (entry.end > now + motion::kSameInstant) continue;
      forget(channel);
      return &entry.effect;
    }
    return nullptr;
  }

 private:
  struct Pulse {
    motion::Effect effect;
    double end = 0;  ///< s of the run
  };
  static std::uint64_t bit(int channel) noexcept { return std::uint64_t{1} << channel; }
  bool under_way(int channel) const noexcept { return (under_way_ & bit(channel)) != 0; }

  std::array<Pulse, 64> pulses_{};
  std::uint64_t under_way_ = 0;  ///< bit i: channel i
};

}  // namespace rob::runtime
