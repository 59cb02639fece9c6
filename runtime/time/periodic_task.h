#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <latch>
#include <thread>

#include "motion/space/cycle_instant.h"
#include "runtime/time/clock.h"

namespace rob::runtime {

/// How punctual a periodic task was.
struct Punctuality {
  std::int64_t cycles = 0;    ///< cycles carried out
  std::int64_t missed = 0;    ///< periods that passed without one
  double worst_lateness = 0;  ///< s from a deadline to the start of its cycle
};

/// The deadlines k·period of a cycle, k = 0, 1, 2 …: absolute, so that they cover the work, and
/// never made up: a period that has passed is skipped (S1). Takes no memory.
class PeriodicSchedule {
 public:
  explicit PeriodicSchedule(double period) : period_(period) {}

  /// Waits for the next deadline; returns its number. Deadlines that have passed altogether are
  /// skipped and counted as missed.
  std::int64_t wait(Clock& clock) noexcept;

  double deadline(std::int64_t cycle) const noexcept {
    return motion::cycle_instant(cycle, period_);
  }
  /// The lateness of the cycle that wait() returned last, s.
  double lateness() const noexcept { return lateness_; }
  const Punctuality& punctuality() const noexcept { return punctuality_; }

 private:
  double period_;
  std::int64_t next_ = 0;
  double lateness_ = 0;
  Punctuality punctuality_;
};

/// Where tasks wait, ready, until their clock has started: a thread that is only being made would
/// be late at once (with locked memory it takes its whole stack first).
class StartLine {
 public:
  explicit StartLine(std::ptrdiff_t tasks) : ready_(tasks) {}

  /// A task is ready; returns after go().
  void arrive() noexcept {
    ready_.count_down();
    gone_.wait(false);
  }
  /// Returns when all tasks have arrived.
  void wait_until_ready() const noexcept { ready_.wait(); }
  void go() noexcept {
    gone_ = true;
    gone_.notify_all();
  }

 private:
  std::latch ready_;
  std::atomic<bool> gone_{false};
};

/// A thread that calls `cycle(number, now, lateness)` at every deadline of its schedule until it
/// returns false or stop() is called. The destructor stops and joins.
class PeriodicTask {
 public:
  using Cycle = std::function<bool(std::int64_t number, double now, double lateness)>;

  /// `priority`: SCHED_FIFO priority, used where the system permits it. `line`: where the thread
  /// waits before it looks at the clock for the first time; none: it does so at once.
  PeriodicTask(Clock& clock, double period, int priority, Cycle cycle, StartLine* line = nullptr);
  ~PeriodicTask();
  PeriodicTask(const PeriodicTask&) = delete;
  PeriodicTask& operator=(const PeriodicTask&) = delete;

  void stop() noexcept;
  /// Waits until the thread has ended; its punctuality is complete then.
  void join();
  const Punctuality& punctuality() const noexcept { return schedule_.punctuality(); }

 private:
  void run(int priority) noexcept;

  Clock& clock_;
  PeriodicSchedule schedule_;
  Cycle cycle_;
  StartLine* line_;
  std::atomic<bool> stopping_{false};
  std::thread thread_;
};

}  // namespace rob::runtime
