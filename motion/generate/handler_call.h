#pragma once

#include <atomic>

#include "motion/plan/watched_action.h"

namespace rob::motion {

/// The WHEN whose handler runs, or will run once the axes stand; one at a time. Every call may be
/// used in the tick.
class HandlerCall {
 public:
  /// Whether a handler may begin.
  bool free() const noexcept { return action_ == nullptr && !barred_; }
  WatchedAction* action() const noexcept { return action_; }
  /// The axes are the handler's, or stop for it.
  bool has_axes() const noexcept {
    return action_ != nullptr && action_->kind == WatchedAction::Kind::Handle;
  }
  /// That it has come true is reported.
  bool reported() const noexcept { return reported_; }
  /// The handler does not begin yet.
  bool waits() const noexcept { return action_ != nullptr && !reported_; }

  void begin(WatchedAction& action) noexcept {
    action_ = &action;
    action.fired.store(true, std::memory_order_relaxed);
  }
  void set_reported() noexcept { reported_ = true; }
  void end() noexcept {
    action_ = nullptr;
    reported_ = false;
  }
  /// No handler may begin.
  void bar(bool barred) noexcept { barred_ = barred; }

 private:
  WatchedAction* action_ = nullptr;
  bool reported_ = false;
  bool barred_ = false;
};

}  // namespace rob::motion
