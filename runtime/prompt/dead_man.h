#pragma once

#include <atomic>
#include <limits>

#include "motion/plan/watch.h"

namespace rob::runtime {

/// The dead-man of a jog: it goes on until an instant of the run's time, which whoever holds a key
/// puts off again and again. Asked in the tick: so the robot stops also where nobody renews it
/// because the terminal, or what reads it, hangs.
class DeadMan {
 public:
  void hold_until(double time) noexcept { until_.store(time, std::memory_order_relaxed); }
  void hold() noexcept { hold_until(std::numeric_limits<double>::infinity()); }
  void release() noexcept { hold_until(-std::numeric_limits<double>::infinity()); }

  /// Yes once it is over. It must outlive what is watched.
  motion::Watch watch() const noexcept {
    return {[](const void* self, const motion::CycleView& view) noexcept {
              const auto* const one = static_cast<const DeadMan*>(self);
              return view.time >= one->until_.load(std::memory_order_relaxed)
                         ? motion::WatchAnswer::Yes
                         : motion::WatchAnswer::No;
            },
            this};
  }

 private:
  std::atomic<double> until_{-std::numeric_limits<double>::infinity()};
};

}  // namespace rob::runtime
