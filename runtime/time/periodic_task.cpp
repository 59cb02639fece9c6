#include "runtime/time/periodic_task.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "runtime/time/real_time.h"

namespace rob::runtime {

std::int64_t PeriodicSchedule::wait(Clock& clock) noexcept {
  clock.sleep_until(deadline(next_));
  const double now = clock.now();
  const auto latest = static_cast<std::int64_t>(std::floor(now / period_));
  const std::int64_t cycle = std::max(next_, latest);
  punctuality_.missed += cycle - next_;
  ++punctuality_.cycles;
  // Lateness is counted from the first deadline that was waited for: what was skipped was late.
  punctuality_.worst_lateness = std::max(punctuality_.worst_lateness, now - deadline(next_));
  lateness_ = now - deadline(cycle);
  next_ = cycle + 1;
  return cycle;
}

PeriodicTask::PeriodicTask(Clock& clock, double period, int priority, Cycle cycle, StartLine* line)
    : clock_(clock), schedule_(period), cycle_(std::move(cycle)), line_(line) {
  thread_ = std::thread([this, priority] { run(priority); });
}

PeriodicTask::~PeriodicTask() {
  stop();
  join();
}

void PeriodicTask::stop() noexcept {
  stopping_.store(true, std::memory_order_relaxed);
  if (line_ != nullptr) line_->go();  // it may still be waiting there
}

void PeriodicTask::join() {
  if (thread_.joinable()) thread_.join();
}

void PeriodicTask::run(int priority) noexcept {
  enter_real_time(priority);
  if (line_ != nullptr) line_->arrive();
  while (!stopping_.load(std::memory_order_relaxed)) {
    const std::int64_t number = schedule_.wait(clock_);
    if (!cycle_(number, clock_.now(), schedule_.lateness())) return;
  }
}

}  // namespace rob::runtime
