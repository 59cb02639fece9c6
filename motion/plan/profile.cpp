#include "motion/plan/profile.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace rob::motion {

namespace {

constexpr double kPi = std::numbers::pi;

/// The peak of a pulse over its mean.
double peak_over_mean(Profile shape) noexcept {
  switch (shape) {
    case Profile::Trapezoidal:
      return 4.0 / 3;
    case Profile::Parabolic:
      return 1.5;
    case Profile::Cosine:
      return 2;
    default:
      return 1;
  }
}

/// The steepest slope of a pulse of peak 1 over 0 … 1.
double steepest(Profile shape) noexcept {
  switch (shape) {
    case Profile::Trapezoidal:
    case Profile::Parabolic:
      return 4;
    case Profile::Cosine:
      return kPi;
    default:
      return std::numeric_limits<double>::infinity();
  }
}

/// A pulse of peak 1 over 0 … 1 and its two integrals.
struct Pulse {
  double height = 1;
  double once = 0;
  double twice = 0;
};

Pulse trapezoidal(double x) noexcept {
  if (x < 0.25) return {4 * x, 2 * x * x, 2 * x * x * x / 3};
  if (x < 0.75) {
    const double level = x - 0.25;
    return {1, 1.0 / 8 + level, 1.0 / 96 + level / 8 + level * level / 2};
  }
  const double left = 1 - x;
  return {4 * left, 0.75 - 2 * left * left, 0.375 - 0.75 * left + 2 * left * left * left / 3};
}

Pulse pulse_at(Profile shape, double x) noexcept {
  switch (shape) {
    case Profile::Trapezoidal:
      return trapezoidal(x);
    case Profile::Parabolic:
      return {4 * x * (1 - x), (2 - 4 * x / 3) * x * x, (2 - x) * x * x * x / 3};
    case Profile::Cosine: {
      const double turn = 2 * kPi * x;
      return {(1 - std::cos(turn)) / 2, x / 2 - std::sin(turn) / (4 * kPi),
              x * x / 4 - (1 - std::cos(turn)) / (8 * kPi * kPi)};
    }
    default:
      return {1, x, x * x / 2};
  }
}

}  // namespace

// d = 1. Without a cruise 1 = v·t_a(v); for a time T the smaller root of 1 = v·(T − t_a(v)).
ProfileLaw::ProfileLaw(Profile shape, double rate, double acceleration, double at_least) noexcept
    : shape_(shape) {
  const double k = peak_over_mean(shape) / acceleration;
  rate_ = std::min(rate, 1 / std::sqrt(k));
  if (at_least > 1 / rate_ + k * rate_) {
    rate_ = 2 / (at_least + std::sqrt(std::max(0.0, at_least * at_least - 4 * k)));
  }
  pulse_ = k * rate_;
  duration_ = 1 / rate_ + pulse_;
}

ProfileLaw ProfileLaw::within_jerk(Profile shape, double rate, double acceleration, double jerk,
                                   double at_least) noexcept {
  const ProfileLaw fastest(shape, rate, acceleration, at_least);
  if (shape == Profile::Rectangular || fastest.jerk() <= jerk) return fastest;
  constexpr int kHalvings = 60;
  double low = 0;
  double high = 1;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = (low + high) / 2;
    const bool keeps = ProfileLaw(shape, rate, middle * acceleration, at_least).jerk() <= jerk;
    (keeps ? low : high) = middle;
  }
  return {shape, rate, low * acceleration, at_least};
}

double ProfileLaw::jerk() const noexcept {
  return steepest(shape_) * peak_over_mean(shape_) * rate_ / (pulse_ * pulse_);
}

ProfileLaw ProfileLaw::slowed(double share) const noexcept {
  ProfileLaw slower = *this;
  slower.rate_ *= share;
  slower.pulse_ /= share;
  slower.duration_ /= share;
  return slower;
}

ProfileLaw::Point ProfileLaw::rising(double t) const noexcept {
  if (t >= pulse_) return {rate_ * (t - pulse_ / 2), rate_, 0};
  const double k = peak_over_mean(shape_);
  const Pulse pulse = pulse_at(shape_, std::max(t, 0.0) / pulse_);
  return {rate_ * pulse_ * k * pulse.twice, rate_ * k * pulse.once,
          rate_ / pulse_ * k * pulse.height};
}

ProfileLaw::Point ProfileLaw::at(double t) const noexcept {
  const double left = duration_ - t;
  if (t <= left) return rising(t);
  const Point mirrored = rising(left);
  return {1 - mirrored.share, mirrored.rate, -mirrored.acceleration};
}

double ProfileLaw::time_at(double share) const noexcept {
  double low = 0;
  double high = duration_;
  for (int i = 0; i < 60; ++i) {  // halvings: below any clock
    const double middle = (low + high) / 2;
    (at(middle).share < share ? low : high) = middle;
  }
  return high;
}

}  // namespace rob::motion
