#include "motion/force/constant_force.h"

#include <algorithm>
#include <cmath>

#include "motion/generate/rate_change.h"

namespace rob::motion {

namespace {

/// Share of the set-point from which on there is contact. [choice] a newton of S4's 5 and 10 N, far
/// above the noise of a sensor.
constexpr double kContact = 0.2;

/// N that the first stretch of contact must rise by before its slope is taken. [choice] five times
/// the noise of S4's sensor
constexpr double kSpan = 1;
/// [choice] fewer are no line
constexpr int kLeastSamples = 6;
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
  line_ = {};
  learned_ = settled_ = false;
}

void ConstantForce::step(double felt) noexcept {
  ways_[steps_++ % kKept] = way_;
  const double error = force_ - felt;
  const double late = contact_.late();
  judge(error);
  if (felt / force_ < kContact) {
    line_ = {};
    const double speed = std::min(most_, std::abs(force_) / (contact_.stiffness * late));
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

/// What is felt belongs to where the axis was a delay ago.
void ConstantForce::learn(double felt) noexcept {
  const auto back = static_cast<std::size_t>(std::lround(contact_.delay / contact_.period)) + 1;
  if (back >= std::min(steps_, kKept)) return;
  const double way = ways_[(steps_ - 1 - back) % kKept];
  if (line_.count == 0) line_.first = felt;
  line_.last = felt;
  ++line_.count;
  line_.x += way;
  line_.y += felt;
  line_.xx += way * way;
  line_.xy += way * felt;
  if (line_.count < kLeastSamples || std::abs(line_.last - line_.first) < kSpan) return;
  const double width = line_.xx - line_.x * line_.x / line_.count;
  const double slope = (line_.xy - line_.x * line_.y / line_.count) / width;
  if (!(width > 0) || !(slope < 0)) return;  // the reaction grows against the way
  stiffness_ = std::clamp(-slope, contact_.stiffness * kSoftest, contact_.stiffness);
  learned_ = true;
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
