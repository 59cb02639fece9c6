#pragma once

#include <array>
#include <cstddef>

#include "motion/plan/watched_action.h"

namespace rob::motion {

/// The WHENs that are armed, in the order of their arming. Each fires when its condition comes
/// true, and at first also if it is true already. Every call may be used in the tick.
class WatchList {
 public:
  /// [choice] more conditions at once than a person keeps in mind; with 256 instructions each they
  /// take some 10 µs a cycle.
  static constexpr std::size_t kMost = 16;

  /// Beyond kMost nothing is armed; the asker keeps count.
  void arm(WatchedAction& action) noexcept;
  void disarm(WatchedAction& action) noexcept;

  /// As though it had not come true yet.
  void renew(const WatchedAction& action) noexcept;

  /// Calls fire(action, answer) for each that comes true or cannot be computed, in order, until one
  /// of the calls returns false: what stands after it is not asked in this cycle. Those for which
  /// waits(action) holds are left out, as though nothing had changed for them.
  template <typename Waits, typename Fire>
  void ask(const CycleView& view, Waits&& waits, Fire&& fire) noexcept {
    for (std::size_t i = 0; i < count_; ++i) {
      Entry& entry = entries_[i];
      if (waits(*entry.action)) continue;
      const WatchAnswer answer = entry.action->condition.ask(view);
      const bool rises = answer != WatchAnswer::No && answer != entry.last;
      entry.last = answer;
      if (rises && !fire(*entry.action, answer)) return;
    }
  }

 private:
  struct Entry {
    WatchedAction* action = nullptr;
    WatchAnswer last = WatchAnswer::No;
  };

  std::array<Entry, kMost> entries_;
  std::size_t count_ = 0;
};

}  // namespace rob::motion
