#include "motion/generate/watch_list.h"

#include <algorithm>

namespace rob::motion {

void WatchList::arm(WatchedAction& action) noexcept {
  if (count_ < kMost) entries_[count_++] = {&action, WatchAnswer::No};
}

void WatchList::disarm(WatchedAction& action) noexcept {
  const auto end = entries_.begin() + static_cast<std::ptrdiff_t>(count_);
  const auto left = std::remove_if(entries_.begin(), end,
                                   [&](const Entry& entry) { return entry.action == &action; });
  count_ = static_cast<std::size_t>(left - entries_.begin());
  action.armed.store(false, std::memory_order_release);
}

void WatchList::renew(const WatchedAction& action) noexcept {
  for (std::size_t i = 0; i < count_; ++i) {
    if (entries_[i].action == &action) entries_[i].last = WatchAnswer::No;
  }
}

}  // namespace rob::motion
