#pragma once

#include <algorithm>
#include <cstdint>
#include <string>

namespace rob::bench {

/// How one run of the published program kept its time.
struct Outcome {
  double measured = 0;        ///< s from the start until its last reference was in force
  std::int64_t samples = 0;   ///< references that were due
  std::int64_t late = 0;      ///< of these, handed out after their instant, or never
  double worst_lateness = 0;  ///< s
  bool fixed_priority = false;
  std::string trouble;  ///< why the program did not come to its end; empty if it did
};

/// Counts late samples, alike for every organisation: reference k is meant for the instant k·T
/// after the start, and late if it is handed out after that, or left out because a later one was.
class SampleCount {
 public:
  SampleCount(double period, std::int64_t first) : period_(period), next_(first) {}

  /// `now`: s after the start. What lies between the sample before and this one is left out.
  void hand_out(std::int64_t number, double now) noexcept {
    for (; next_ <= number; ++next_) {
      const double lateness = now - static_cast<double>(next_) * period_;
      ++samples_;
      if (lateness > 0) ++late_;
      worst_ = std::max(worst_, lateness);
    }
  }

  Outcome outcome(double measured) const { return {measured, samples_, late_, worst_, false, ""}; }

 private:
  double period_;
  std::int64_t next_;
  std::int64_t samples_ = 0;
  std::int64_t late_ = 0;
  double worst_ = 0;
};

}  // namespace rob::bench
