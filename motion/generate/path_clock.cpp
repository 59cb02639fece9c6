#include "motion/generate/path_clock.h"

#include <algorithm>

namespace rob::motion {

PathClock::PathClock(const TimeScaleLimits& limits, double period) noexcept
    : period_(period),
      ramp_(limits),
      ramp_before_(limits),
      stamp_(-period),
      stamp_before_(-period),
      path_(-period),
      path_before_(-period) {}

void PathClock::set_override(double share) noexcept {
  if (share > 0) override_ = std::min(share, 1.0);
}

void PathClock::advance(double stamp, bool at_rest) noexcept {
  if (at_rest) {
    jump();
  } else if (goal() < ramp_.target()) {
    ramp_.aim(goal());
  }
  ramp_before_ = ramp_;
  stamp_before_ = stamp_;
  path_before_ = path_;
  stamp_ = stamp;
  if (as_planned(ramp_)) {
    path_ = stamp - lag_;
  } else {
    path_ += ramp_.advance(stamp - stamp_before_);
    lag_ = stamp - path_;
  }
  if (goal() > ramp_.target()) ramp_.aim(goal());
}

void PathClock::skip(double gap) noexcept {
  stamp_ += gap;
  lag_ += gap;
}

double PathClock::steady_since() const noexcept {
  return std::min(stamp_, stamp_before_ + ramp_before_.remaining());
}

double PathClock::next() const noexcept {
  StopRamp ahead = ramp_;
  return path_ + ahead.advance(period_);
}

double PathClock::run_time(double path_time) const noexcept {
  if (as_planned(ramp_before_)) return path_time + lag_;
  const double gain = path_time - path_before_;
  return stamp_before_ + ramp_before_.time_to_gain(gain, stamp_ - stamp_before_);
}

double PathClock::path_time_at(double run_time) const noexcept {
  if (as_planned(ramp_before_)) return run_time - lag_;
  StopRamp ramp = ramp_before_;
  return path_before_ + ramp.advance(run_time - stamp_before_);
}

bool PathClock::as_planned(const StopRamp& ramp) noexcept {
  return ramp.rate() == 1 && ramp.remaining() == 0;
}

}  // namespace rob::motion
