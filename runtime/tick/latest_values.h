#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

#include "motion/space/joint_vector.h"

namespace rob::runtime {

/// Values of one instant, of every axis or of a wrench, written by one thread every cycle and read
/// by others whenever they want: a reader never gets half of one and half of another. store() never
/// waits and may be used in the tick; load() repeats itself when it was disturbed.
class LatestValues {
 public:
  void store(const motion::JointVector& q) noexcept {
    const std::uint32_t turn = turn_.load(std::memory_order_relaxed);
    turn_.store(turn + 1, std::memory_order_relaxed);  // odd: being written
    count_.store(static_cast<std::size_t>(q.size()), std::memory_order_release);
    for (std::size_t i = 0; i < static_cast<std::size_t>(q.size()); ++i) {
      values_[i].store(q[static_cast<Eigen::Index>(i)], std::memory_order_release);
    }
    turn_.store(turn + 2, std::memory_order_release);
  }

  motion::JointVector load() const noexcept {
    motion::JointVector q;
    std::uint32_t before = 0;
    do {
      before = turn_.load(std::memory_order_acquire);
      const std::size_t count = count_.load(std::memory_order_acquire);
      q.resize(static_cast<Eigen::Index>(count));
      for (std::size_t i = 0; i < count; ++i) {
        q[static_cast<Eigen::Index>(i)] = values_[i].load(std::memory_order_acquire);
      }
    } while ((before & 1U) != 0 || turn_.load(std::memory_order_relaxed) != before);
    return q;
  }

 private:
  std::atomic<std::uint32_t> turn_{0};
  std::atomic<std::size_t> count_{0};
  std::array<std::atomic<double>, motion::kMaxJoints> values_{};
};

}  // namespace rob::runtime
