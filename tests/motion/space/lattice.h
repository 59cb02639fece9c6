#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace rob::test {

/// Motions of one axis whose jerk is −j, 0 or j for whole steps of h: all of them, by dynamic
/// programming over whole numbers. With a = n·jh, v = m·jh²/2, q = k·jh³/6 a step of jerk u·j is
///
///     n' = n + u        m' = m + 2n + u        k' = k + 3m + 3n + u
///
/// and as a has no change of sign inside a step, |n| <= n_max and |m| <= m_max at its ends hold
/// within it, too.
class Lattice {
 public:
  static constexpr int kNone = std::numeric_limits<int>::min() / 2;

  Lattice(int n_max, int m_max) : n_max_(n_max), m_max_(m_max) {
    farthest_.assign(1, std::vector<int>(states(), kNone));
    farthest_[0][index(0, 0)] = 0;
  }

  int n_max() const { return n_max_; }
  int m_max() const { return m_max_; }

  /// The greatest k from (n, m) to rest in exactly so many steps; kNone: rest is out of reach.
  int farthest(int n, int m, int steps) {
    while (static_cast<int>(farthest_.size()) <= steps) add_step();
    return farthest_[static_cast<std::size_t>(steps)][index(n, m)];
  }

 private:
  std::size_t states() const {
    return static_cast<std::size_t>((2 * n_max_ + 1) * (2 * m_max_ + 1));
  }
  std::size_t index(int n, int m) const {
    return static_cast<std::size_t>((n + n_max_) * (2 * m_max_ + 1) + m + m_max_);
  }

  void add_step() {
    const std::vector<int>& last = farthest_.back();
    std::vector<int> more(states(), kNone);
    for (int n = -n_max_; n <= n_max_; ++n) {
      for (int m = -m_max_; m <= m_max_; ++m) {
        int& best = more[index(n, m)];
        for (int u = -1; u <= 1; ++u) {
          const int speed = m + 2 * n + u;
          if (std::abs(n + u) > n_max_ || std::abs(speed) > m_max_) continue;
          const int rest = last[index(n + u, speed)];
          if (rest != kNone) best = std::max(best, rest + 3 * m + 3 * n + u);
        }
      }
    }
    farthest_.push_back(std::move(more));
  }

  int n_max_;
  int m_max_;
  std::vector<std::vector<int>> farthest_;  ///< by steps
};

}  // namespace rob::test
