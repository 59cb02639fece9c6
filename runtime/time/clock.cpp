#include "runtime/time/clock.h"

#include <cerrno>
#include <cmath>

namespace rob::runtime {

namespace {

constexpr long kNanosecondsPerSecond = 1'000'000'000;

timespec later(timespec from, double seconds) {
  const double whole = std::floor(seconds);
  from.tv_sec += static_cast<time_t>(whole);
  from.tv_nsec += static_cast<long>((seconds - whole) * 1e9);
  if (from.tv_nsec >= kNanosecondsPerSecond) {
    from.tv_nsec -= kNanosecondsPerSecond;
    ++from.tv_sec;
  }
  return from;
}

}  // namespace

SystemClock::SystemClock(double lead) {
  clock_gettime(CLOCK_MONOTONIC, &zero_);
  zero_ = later(zero_, lead);
}

double SystemClock::now() const noexcept {
  timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return static_cast<double>(t.tv_sec - zero_.tv_sec) +
         1e-9 * static_cast<double>(t.tv_nsec - zero_.tv_nsec);
}

void SystemClock::sleep_until(double time) noexcept {
  const timespec deadline = later(zero_, time);
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &deadline, nullptr) == EINTR) {
  }
}

}  // namespace rob::runtime
