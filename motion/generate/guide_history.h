#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "motion/ahead/guide.h"

namespace rob::motion {

/// When `sigma` is passed on a part that ends at `end`.
double passing_time(const Guide::Part& part, double sigma, double end) noexcept;

/// Where the guide has been: its last parts, in order, read from the time on that is looked at.
/// The constructor alone takes memory.
class GuideHistory {
 public:
  /// [choice] 2000 periods, half of the longest mean, of eight parts each. Where that is not enough
  /// the oldest are lost, and what has been passed in them is reported late.
  static constexpr std::size_t kMost = 16384;

  GuideHistory() : parts_(kMost) {}

  /// The guide stands at `sigma` from `time` on; what was before is forgotten.
  void begin(double time, double sigma) noexcept;
  void keep(const Guide::Part& part) noexcept;
  /// Parts that end before `time` are not asked for any more.
  void forget(double time) noexcept;

  /// σ at a time that is kept, or after it.
  double sigma(double time) const noexcept;
  /// When `sigma` was reached, not after `until`; none if it was not.
  std::optional<double> when(double sigma, double until) const noexcept;
  /// Since when the guide stands; only while it does.
  double stands_since() const noexcept { return standing_; }

 private:
  const Guide::Part& part(std::size_t i) const noexcept { return parts_[(first_ + i) % kMost]; }

  std::vector<Guide::Part> parts_;
  std::size_t first_ = 0;
  std::size_t count_ = 0;
  double standing_ = 0;
};

}  // namespace rob::motion
