#include "motion/generate/stop_ramp.h"

#include <algorithm>
#include <cmath>

namespace rob::motion {

// The time-optimal motion of a double integrator from (r, r') to (target, 0). It never leaves the
// interval between the aims it was given: r' can be brought to 0 before the last of them.
void StopRamp::aim(double target) noexcept {
  const auto [slope_max, bend] = limits_;
  target_ = target;
  // Where r would end if r' were taken back now tells which way to push.
  const double level = rate_ + slope_ * std::abs(slope_) / (2 * bend);
  const double sign = target >= level ? 1 : -1;
  const double distance = sign * (target - rate_);
  const double start = sign * slope_;

  const double square = std::max(0.0, bend * distance + start * start / 2);
  const double peak = std::min(std::sqrt(square), slope_max);
  const double cruise = peak > 0 ? std::max(0.0, square - peak * peak) / (bend * peak) : 0;
  phases_[0] = {std::max(0.0, (peak - start) / bend), sign * bend};
  phases_[1] = {cruise, 0};
  phases_[2] = {peak / bend, -sign * bend};
}

void StopRamp::jump(double target) noexcept {
  rate_ = target_ = target;
  slope_ = 0;
  phases_ = {};
}

double StopRamp::advance(double dt) noexcept {
  if (remaining() == 0) return rate_ * dt;
  double gained = 0;
  for (Phase& phase : phases_) {
    const double d = std::min(dt, phase.duration);
    gained += ((phase.bend * d / 3 + slope_) * d / 2 + rate_) * d;
    rate_ += (phase.bend * d / 2 + slope_) * d;
    slope_ += phase.bend * d;
    phase.duration -= d;
    dt -= d;
  }
  if (remaining() > 0) return gained;
  rate_ = target_;  // and not nearly so
  slope_ = 0;
  return gained + rate_ * dt;
}

double StopRamp::time_to_gain(double gain, double within) const noexcept {
  // Bisection: r >= 0, so the gain only grows. 60 halvings bring any period below 1e-18 s.
  double low = 0;
  double high = within;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    StopRamp ahead = *this;
    (ahead.advance(middle) < gain ? low : high) = middle;
  }
  return high;
}

double StopRamp::remaining() const noexcept {
  return phases_[0].duration + phases_[1].duration + phases_[2].duration;
}

}  // namespace rob::motion
