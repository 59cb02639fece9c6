#pragma once

#include <array>
#include <atomic>
#include <cstddef>

#include "motion/plan/segment_descriptor.h"

namespace rob::runtime {

/// The values of outputs when a run goes wrong: program → motion. For one output the later of two
/// holds. At a prompt more are declared while the robot moves.
class SafeValues {
 public:
  /// [choice] every output of a robot, declared anew once
  static constexpr std::size_t kMost = 256;

  /// False where there is no more room.
  bool add(const motion::Effect& effect) noexcept {
    const std::size_t size = count_.load(std::memory_order_relaxed);
    if (size == kMost) return false;
    effects_[size] = effect;
    count_.store(size + 1, std::memory_order_release);
    return true;
  }
  /// While nothing reads them.
  void clear() noexcept { count_.store(0, std::memory_order_release); }

  std::size_t size() const noexcept { return count_.load(std::memory_order_acquire); }
  bool empty() const noexcept { return size() == 0; }
  const motion::Effect& operator[](std::size_t i) const noexcept { return effects_[i]; }
  const motion::Effect* begin() const noexcept { return effects_.data(); }
  const motion::Effect* end() const noexcept { return effects_.data() + size(); }

 private:
  std::array<motion::Effect, kMost> effects_;
  std::atomic<std::size_t> count_{0};
};

}  // namespace rob::runtime
