#include "motion/generate/stop_ramp.h"

#include <algorithm>
#include <cmath>

namespace rob::motion {

// r is the speed of a path's time. It never leaves the interval between the aims it was given: r'
// can be brought to 0 before the last of them.
void StopRamp::aim(double target) noexcept {
  target_ = target;
  ahead_ = speed_change({0, rate_, slope_}, target, {0, limits_.slope, limits_.bend});
}

void StopRamp::jump(double target) noexcept {
  rate_ = target_ = target;
  slope_ = 0;
  ahead_ = {};
}

double StopRamp::advance(double dt) noexcept {
  if (remaining() == 0) return rate_ * dt;
  AxisState state{0, rate_, slope_};
  for (JerkPhase& phase : ahead_.phases) {
    const double d = std::min(dt, phase.duration);
    state = phase.after(state, d);
    phase.acceleration = state.a;
    phase.duration -= d;
    dt -= d;
    if (phase.duration > 0) break;
  }
  rate_ = state.v;
  slope_ = state.a;
  if (remaining() > 0) return state.q;
  rate_ = target_;  // and not nearly so
  slope_ = 0;
  return state.q + rate_ * dt;
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

}  // namespace rob::motion
