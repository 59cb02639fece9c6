#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "motion/generate/rate_change.h"

using namespace rob::motion;

namespace {

JointVector vector(double a, double b) {
  JointVector v(2);
  v << a, b;
  return v;
}

/// Rates that are changed period by period, as their user does it.
struct Rates {
  JointVector rate;
  JointVector acceleration;
  JointVector a_max;
  JointVector j_max;
  double period;

  /// One period towards `target`; the greatest share of a_max and j_max that it takes.
  double step(const JointVector& target) {
    const JointVector missing = target - rate;
    const RateChange change = rate_change(missing, acceleration, a_max, j_max, period);
    const JointVector next = missing * change.of_missing + acceleration * change.of_acceleration;
    const JointVector jerk = (next - acceleration) / period;
    const double most = std::max(jerk.cwiseQuotient(j_max).cwiseAbs().maxCoeff(),
                                 next.cwiseQuotient(a_max).cwiseAbs().maxCoeff());
    rate += (acceleration + next) * (period / 2);
    acceleration = next;
    return most;
  }
};

Rates at_rest(double period) {
  return {vector(0, 0), vector(0, 0), vector(2, 3), vector(40, 30), period};
}

}  // namespace

TEST_CASE("a rate that needs full acceleration is reached after v/a + a/j, give or take periods") {
  // The shortest with |a| <= 2 and |j| <= 40: 1/2 + 2/40 s (motion.md; by hand from the trapezoid)
  Rates rates = at_rest(0.001);
  int periods = 0;
  do {
    CHECK(rates.step(vector(1, 0)) <= 1 + 1e-9);
    ++periods;
  } while ((rates.rate - vector(1, 0)).norm() + rates.acceleration.norm() > 1e-12);
  CHECK(periods * 0.001 >= 0.55);
  CHECK(periods * 0.001 <= 0.553);
}

TEST_CASE("a small change takes 2·sqrt(v/j)") {
  Rates rates = at_rest(0.001);
  int periods = 0;
  do {
    CHECK(rates.step(vector(0.05, 0)) <= 1 + 1e-9);
    ++periods;
  } while ((rates.rate - vector(0.05, 0)).norm() + rates.acceleration.norm() > 1e-12);
  CHECK(periods * 0.001 >= 2 * std::sqrt(0.05 / 40));
  CHECK(periods * 0.001 <= 2 * std::sqrt(0.05 / 40) + 0.003);
}

TEST_CASE("from rest all rates keep their ratio, and none overshoots") {
  Rates rates = at_rest(0.01);
  const JointVector target = vector(0.7, -0.4);
  for (int i = 0; i < 200; ++i) {
    rates.step(target);
    CHECK(std::abs(rates.rate[0] * target[1] - rates.rate[1] * target[0]) < 1e-15);
    CHECK(rates.rate[0] >= -1e-15);
    CHECK(rates.rate[0] <= target[0] + 1e-15);
  }
  CHECK((rates.rate - target).norm() < 1e-14);
  CHECK(rates.acceleration.norm() < 1e-12);
}

TEST_CASE("whatever is asked for, and whenever, acceleration and jerk hold, and it is reached") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(-1, 1);
  for (const double period : {0.001, 0.004, 0.01, 0.04}) {
    CAPTURE(period);
    Rates rates = at_rest(period);
    double most = 0;
    for (int change = 0; change < 300; ++change) {
      const JointVector target = vector(3 * share(random), 2 * share(random));
      const int periods = static_cast<int>((1 + share(random)) / period);
      for (int i = 0; i < periods; ++i) most = std::max(most, rates.step(target));
      if (change % 10 != 0) continue;
      for (int i = 0; i * period < 5; ++i) most = std::max(most, rates.step(target));
      REQUIRE((rates.rate - target).norm() < 1e-12);
      REQUIRE(rates.acceleration.norm() < 1e-9);
    }
    CHECK(most <= 1 + 1e-8);
    CHECK(most > 0.99);
  }
}
