#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "motion/plan/segment_descriptor.h"

namespace rob::runtime {

/// Where motion holds by itself while a program runs at a prompt: where the motion of each next
/// line begins, for single steps, or that of chosen lines. It holds on the path, as the operator's
/// hold does, so that corners keep their form.
class HoldPoints {
 public:
  static constexpr std::size_t kMost = 32;  ///< breakpoints; [choice] more than anybody watches

  // The operator's side.
  void hold_at_each(bool on) { each_.store(on, std::memory_order_relaxed); }
  /// The `index`-th breakpoint, below kMost; 0: none.
  void hold_at(std::size_t index, motion::Tag tag) {
    chosen_.at(index).store(tag, std::memory_order_relaxed);
  }
  /// The line whose motion begins where it has held; 0: not since it was asked last.
  motion::Tag take_held() { return held_.exchange(0, std::memory_order_relaxed); }

  // The program's side: which motions are its own.
  void begin_behind(std::uint32_t number) {
    last_.store(kOpen, std::memory_order_relaxed);
    first_.store(number + 1, std::memory_order_release);
  }
  /// The first time counts.
  void end_with(std::uint32_t number) {
    auto open = kOpen;
    last_.compare_exchange_strong(open, number, std::memory_order_relaxed);
  }

  /// The tick: whether to hold now that this motion begins.
  bool holds(motion::Tag tag, std::uint32_t number) noexcept {
    const std::uint32_t first = first_.load(std::memory_order_acquire);
    if (first == 0 || number < first || number > last_.load(std::memory_order_relaxed))
      return false;
    const bool first_motion = first != begun_;
    const bool steps = each_.load(std::memory_order_relaxed) && !first_motion && tag != before_;
    begun_ = first;
    before_ = tag;
    if (!steps && !is_chosen(tag)) return false;
    held_.store(tag, std::memory_order_relaxed);
    return true;
  }

 private:
  static constexpr std::uint32_t kOpen = std::numeric_limits<std::uint32_t>::max();

  bool is_chosen(motion::Tag tag) const noexcept {
    for (const auto& one : chosen_) {
      if (one.load(std::memory_order_relaxed) == tag) return tag != 0;
    }
    return false;
  }

  std::atomic<bool> each_{false};
  std::array<std::atomic<motion::Tag>, kMost> chosen_{};
  std::atomic<motion::Tag> held_{0};
  std::atomic<std::uint32_t> first_{0};  ///< number of the program's first motion; 0: none yet
  std::atomic<std::uint32_t> last_{0};
  // Of the tick:
  std::uint32_t begun_ = 0;  ///< first_ of the program whose motions have been seen
  motion::Tag before_ = 0;
};

}  // namespace rob::runtime
