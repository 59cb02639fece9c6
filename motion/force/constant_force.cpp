#include "motion/force/constant_force.h"

#include <algorithm>
#include <cmath>

#include "motion/generate/rate_change.h"

namespace rob::motion {

namespace {

/// Share of the set-point from which on there is contact. [choice] a newton of S4's 5 and 10 N, far
/// above the noise of a sensor.
constexpr double kContact = 0.2;

/// N that the first stretch of contact must rise by before its slope is taken, and by which it is
/// known well enough. [choice] five and fifteen times the noise of S4's sensor
constexpr double kSpan = 1;
constexpr double kWideSpan = 3;
/// [choice] fewer are no line; later what is pressed on may have moved
constexpr int kLeastSamples = 6;
constexpr int kMostSamples = 32;
/// Share of the greatest stiffness that is believed. [choice] beyond 20 … 150 N/mm
constexpr double kSoftest = 1.0 / 20;

// Settled: the mean error of 50 ms is below a tenth of the set-point for 0.1 s. [choice]
constexpr double kMeanTime = 0.05;
constexpr double kNearEnough = 0.1;
constexpr double kNearFor = 0.1;

}  // namespace

void ConstantForce::begin(double force, double most_speed) noexcept {
  force_ = force;
  most_ = most_speed;
  stiffness_ = contact_.stiffness;
  integral_ = way_ = rate_ = acceleration_ = near_ = 0;
  mean_error_ = force;
  steps_ = 0;
  lines_ = {};
  learned_ = settled_ = false;
}

void ConstantForce::step(double felt) noexcept {
  ways_[steps_++ % kKept] = way_;
  const double error = force_ - felt;
  const double late = contact_.late();
  judge(error);
  if (felt / force_ < kContact) {
    lines_ = {};
    const double speed = std::min(most_, contact_.seek_speed(force_));
    return go(std::copysign(speed, -force_));
  }
  if (!learned_) learn(felt);
  const double kp = 0.3 / (stiffness_ * late);
  const double ki = kp / (8 * late);
  const double rate = -(kp * error + ki * integral_);
  if (std::abs(rate) < most_) integral_ += error * contact_.period;
  go(std::clamp(rate, -most_, most_));
}

void ConstantForce::brake() noexcept {
  ways_[steps_++ % kKept] = way_;
  go(0);
}

void ConstantForce::Line::add(double way, double felt) noexcept {
  if (count++ == 0) x0 = way, y0 = felt;
  const double dx = way - x0;
  const double dy = felt - y0;
  x += dx;
  y += dy;
  xx += dx * dx;
  xy += dx * dy;
  yy += dy * dy;
}

double ConstantForce::Line::slope() const noexcept {
  const double width = xx - x * x / count;
  return width > 0 ? (xy - x * y / count) / width : 0;
}

double ConstantForce::Line::misfit() const noexcept {
  return (yy - y * y / count - slope() * (xy - x * y / count)) / count;
}

/// The force that is felt belongs to where the axis was a delay ago, and that is at most the known
/// one.
void ConstantForce::learn(double felt) noexcept {
  const auto most = static_cast<std::size_t>(std::lround(contact_.delay / contact_.period)) + 1;
  if (most >= std::min(steps_, kKept)) return;
  for (std::size_t back = 0; back <= most; ++back)
    lines_[back].add(ways_[(steps_ - 1 - back) % kKept], felt);
  const Line& newest = lines_[0];
  const double span = std::abs(felt - newest.y0);
  learned_ = (newest.count >= kLeastSamples && span >= kWideSpan) || newest.count >= kMostSamples;
  if (newest.count < kLeastSamples || span < kSpan) return;
  const Line* best = nullptr;
  for (std::size_t back = 0; back <= most; ++back) {
    const Line& line = lines_[back];
    if (!(line.slope() < 0)) continue;  // the reaction grows against the way
    if (best == nullptr || line.misfit() < best->misfit()) best = &line;
  }
  if (best == nullptr) return;
  stiffness_ = std::clamp(-best->slope(), contact_.stiffness * kSoftest, contact_.stiffness);
}

void ConstantForce::judge(double error) noexcept {
  mean_error_ += (error - mean_error_) * std::min(1.0, contact_.period / kMeanTime);
  near_ = std::abs(mean_error_) < kNearEnough * std::abs(force_) ? near_ + contact_.period : 0;
  settled_ = settled_ || near_ >= kNearFor;
}

void ConstantForce::go(double rate) noexcept {
  constexpr double kNothing = 1e-12;  // m/s: what rounding leaves of a standstill
  const auto one = [](double value) noexcept { return JointVector::Constant(1, value); };
  const double period = contact_.period;
  const double missing = rate - rate_;
  const RateChange change = rate_change(one(missing), one(acceleration_),
                                        one(contact_.acceleration), one(contact_.jerk), period);
  const double next = missing * change.of_missing + acceleration_ * change.of_acceleration;
  way_ += rate_ * period + (2 * acceleration_ + next) * (period * period / 6);
  rate_ += (acceleration_ + next) * (period / 2);
  acceleration_ = next;
  const bool stands = std::abs(rate_) < kNothing && std::abs(acceleration_) * period < kNothing;
  if (rate == 0 && stands) rate_ = acceleration_ = 0;
}

}  // namespace rob::motion
