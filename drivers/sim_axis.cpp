#include "drivers/sim_axis.h"

#include <algorithm>
#include <cmath>

namespace rob::drivers {
namespace {

// φ1 = (1 − e^−x)/x and φ2 = (1 − φ1)/x: what viscous friction makes of t and t²/2. Their closed
// forms cancel at small x; there three terms of the series are exact to x³/24 < 1e-16.
constexpr double kSeriesBelow = 1e-5;

double phi1(double x) noexcept {
  return x < kSeriesBelow ? 1 - x / 2 + x * x / 6 : -std::expm1(-x) / x;
}

double phi2(double x) noexcept {
  // Here the series costs one more power of x to cancellation.
  constexpr double kSeriesBelow2 = 1e-2;
  if (x >= kSeriesBelow2) return (1 - phi1(x)) / x;
  return 1.0 / 2 - x * (1.0 / 6 - x * (1.0 / 24 - x * (1.0 / 120 - x * (1.0 / 720 - x / 5040))));
}

// How long v takes to reach 0 when it begins to change by a and k·v slows the change; infinite if
// it never does.
double time_to_rest(double v, double a, double k) noexcept {
  if (v * a >= 0) return INFINITY;
  const double x = k * v / a;
  if (x <= -1) return INFINITY;
  return x > -kSeriesBelow ? -v / a * (1 - x / 2 + x * x / 3) : -std::log1p(x) / k;
}

}  // namespace

SimAxis::SimAxis(const motion::DriveData& drive)
    : drive_(drive), encoder_(drive.encoder_resolution) {}

void SimAxis::place(double q) noexcept {
  q_ = q;
  v_ = 0;
  release();
  encoder_.settle(q, 0);
}

void SimAxis::push(double force) noexcept {
  holding_ = false;
  u_ = std::isfinite(force) ? std::clamp(force, -drive_.force_max, drive_.force_max) : 0;
}

void SimAxis::hold() noexcept {
  holding_ = true;
  u_ = 0;
}

double SimAxis::resistance() const noexcept {
  return drive_.coulomb_friction + (holding_ ? drive_.force_max : 0);
}

// Steps are mostly of one length, but for rounding: what friction makes of it is computed once.
void SimAxis::note_step(double dt) noexcept {
  constexpr double kSame = 1e-9;  // relative; it changes a step by less than q can hold
  if (std::abs(dt - step_) <= kSame * dt) return;
  step_ = dt;
  const double x = drive_.viscous_friction / drive_.inertia * dt;
  step_phi1_ = phi1(x);
  step_phi2_ = phi2(x);
}

// At most two legs: until friction has stopped the axis, and from there on if the force suffices to
// move it the other way. Under a constant force the speed changes one way only, so it passes 0
// within a step just where its sign differs at the end.
void SimAxis::advance(double dt) noexcept {
  const double m = drive_.inertia;
  const double k = drive_.viscous_friction / m;
  note_step(dt);
  double left = dt;
  while (left > 0) {
    const double s = v_ != 0 ? std::copysign(1.0, v_) : std::copysign(1.0, u_);
    if (v_ == 0 && std::abs(u_) <= resistance()) return;
    const double a = (u_ - s * resistance()) / m - k * v_;
    const double end = left == dt ? v_ + a * dt * step_phi1_ : 0;
    if (end * s > 0) {
      q_ += (v_ + a * dt * step_phi2_) * dt;
      v_ = end;
      return;
    }
    const double rest = time_to_rest(v_, a, k);
    const double t = std::min(left, rest);
    q_ += (v_ + a * t * phi2(k * t)) * t;
    v_ = rest <= left ? 0 : v_ + a * t * phi1(k * t);
    left -= t;
  }
}

}  // namespace rob::drivers
