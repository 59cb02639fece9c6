#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "tests/bench/busy.h"

namespace rob::bench {

/// Processor time of many cycles of one task, of the calling thread.
class Cost {
 public:
  Cost() { seconds_.reserve(1'000'000); }

  void measure(auto&& cycle) {
    const double begin = thread_time();
    cycle();
    seconds_.push_back(thread_time() - begin - asking());
  }

  std::string row(const char* name) {
    std::sort(seconds_.begin(), seconds_.end());
    double sum = 0;
    for (const double s : seconds_) sum += s;
    const auto count = static_cast<double>(seconds_.size());
    const auto at = static_cast<std::size_t>(std::ceil(0.999 * count)) - 1;
    return fmt::format("  {:<24} {:>9} {:>10.2f} us {:>10.2f} us\n", name, seconds_.size(),
                       1e6 * sum / count, 1e6 * seconds_[at]);
  }

  /// s that it takes to ask for the time itself: the least of many, measured once.
  static double asking() {
    static const double least = [] {
      double shortest = 1;
      for (int i = 0; i < 10'000; ++i) {
        const double begin = thread_time();
        shortest = std::min(shortest, thread_time() - begin);
      }
      return shortest;
    }();
    return least;
  }

 private:
  std::vector<double> seconds_;
};

}  // namespace rob::bench
