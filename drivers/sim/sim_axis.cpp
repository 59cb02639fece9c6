#include "drivers/sim/sim_axis.h"

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
    : drive_(drive),
      encoder_(drive.encoder_resolution),
      times_(Encoder::kBlock),
      ways_(Encoder::kBlock),
      gains_(Encoder::kBlock) {
  const double k = drive.viscous_friction / drive.inertia;
  for (int i = 0; i < Encoder::kBlock; ++i) {
    const double t = (i + 1) * Encoder::kPeriod;
    times_[i] = t;
    ways_[i] = t * t * phi2(k * t);
    gains_[i] = t * phi1(k * t);
  }
}

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
    const double s = direction();
    if (stands()) return;
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

void SimAxis::advance_sampled(std::int64_t count) noexcept {
  while (count > 0) {
    if (stands() && encoder_.rests_at(q_)) return;
    const int block = static_cast<int>(std::min<std::int64_t>(count, Encoder::kBlock));
    if (!pass_samples(block)) {
      for (int i = 0; i < block; ++i) {
        advance(Encoder::kPeriod);
        sample();
      }
    }
    count -= block;
  }
}

/// False, and nothing done, if the axis stands or comes to rest meanwhile.
bool SimAxis::pass_samples(int count) noexcept {
  if (stands()) return false;
  const double m = drive_.inertia;
  const double s = direction();
  const double a = (u_ - s * resistance() - drive_.viscous_friction * v_) / m;
  const double end = v_ + a * gains_[count - 1];
  if (end * s <= 0) return false;
  const Encoder::Block q = q_ + v_ * times_.head(count) + a * ways_.head(count);
  q_ = q[count - 1];
  v_ = end;
  encoder_.sample(q);
  return true;
}

}  // namespace rob::drivers
