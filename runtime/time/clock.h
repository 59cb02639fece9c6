#pragma once

#include <ctime>

namespace rob::runtime {

/// Seconds since the start of a run. Both forms only ever go forward.
class Clock {
 public:
  virtual ~Clock() = default;

  virtual double now() const noexcept = 0;
  /// Returns when now() >= time; at once if that has passed.
  virtual void sleep_until(double time) noexcept = 0;
};

/// CLOCK_MONOTONIC, so that setting the date moves nothing. Time 0 is settled by the constructor:
/// `lead` seconds from now, so that every thread can be ready before the first deadline.
/// May be used from any thread.
class SystemClock final : public Clock {
 public:
  explicit SystemClock(double lead = 0);

  double now() const noexcept override;
  /// Sleeps until an absolute instant, so that time spent working is never added to the period.
  void sleep_until(double time) noexcept override;

 private:
  timespec zero_;
};

/// Time that passes only when somebody waits: one thread steps everything, as fast as it can, to
/// the same bits every time.
class VirtualClock final : public Clock {
 public:
  double now() const noexcept override { return now_; }
  void sleep_until(double time) noexcept override { now_ = time > now_ ? time : now_; }

 private:
  double now_ = 0;
};

}  // namespace rob::runtime
