#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "tests/motion/ahead/ahead_run.h"

using namespace rob::motion;
using rob::test::AheadRun;

// A leg that stands alone between two stops is run in the time of a third-order profile. Every axis
// has 1 m/s², 1 m/s; its jerk is 2·A over the window that the leg is given.

namespace {

constexpr double kPeriod = 0.001;

/// s from rest to rest over d, m, with speed v, acceleration a and jerk j: closed forms.
double third_order(double d, double v, double a, double j) {
  const double change = v >= a * a / j ? v / a + a / j : 2 * std::sqrt(v / j);
  if (d >= v * change) return d / v + change;
  if (d >= 2 * a * a * a / (j * j)) return a / j + std::sqrt(a * a / (j * j) + 4 * d / a);
  return std::cbrt(32 * d / j);
}

struct AloneRun : AheadRun {
  AloneRun(double speed, double most_jerk) : jerk(most_jerk) {
    bounds.speed = speed;
    bounds.miss = 1e-4;
    bounds.window = 2 / jerk;
  }
  double jerk;
};

void check_limits(const AloneRun& run) {
  for (int i = 0; i < 2; ++i) {
    CHECK(run.peak_acceleration(i) <= 1 + 1e-6);
    CHECK(run.peak_jerk(i) <= run.jerk * (1 + 1e-5));
  }
}

}  // namespace

TEST_CASE("a leg alone takes the time of a third-order profile, whatever bounds it") {
  for (const double jerk : {1.0, 3.0, 10.0, 30.0, 100.0}) {
    for (const double speed : {0.05, 0.3, 1.0}) {
      for (const double way : {0.0005, 0.01, 0.1, 0.9}) {
        CAPTURE(jerk);
        CAPTURE(speed);
        CAPTURE(way);
        AloneRun run(speed, jerk);
        run.line(way * 1000, 0);
        run.close();
        // The mean is one of samples, and takes one period less than its time in whole ones.
        const double time = third_order(way, speed, 1, jerk);
        const double taken = run.run();
        CHECK(taken >= time - kPeriod - 1e-9);
        CHECK(taken <= time + 3 * kPeriod);
        CHECK(run.references().back().q[0] == doctest::Approx(way).epsilon(1e-12));
        check_limits(run);
      }
    }
  }
}

TEST_CASE("stops one behind another, to and fro and straight on, keep the jerk") {
  AloneRun run(0.3, 20);
  run.line(30, 0);
  run.from_rest = true;
  for (const double x : {60., 20., 19., 18., 60., 60.01, 0.}) run.line(x, 0);
  run.close();
  CHECK(run.run() > 0);
  check_limits(run);
}

TEST_CASE("held, braked and with any override a leg alone keeps the jerk, and arrives") {
  std::mt19937 random(11);
  const auto between = [&](double least, double most) {
    return std::uniform_real_distribution<double>(least, most)(random);
  };
  for (int attempt = 0; attempt < 60; ++attempt) {
    CAPTURE(attempt);
    AloneRun run(between(0.05, 1), std::exp(between(0, 5)));
    run.line(between(-300, 300), between(-300, 300));
    run.close();
    for (int change = 0; change < 20 && !run.ended(); ++change) {
      if (between(0, 1) < 0.4) {
        run.guide().braking() ? run.guide().release() : run.guide().brake();
      } else {
        run.ring().share = between(0.05, 2);
      }
      for (int k = static_cast<int>(between(1, 200)); k > 0; --k) run.step();
    }
    run.guide().release();
    run.ring().share = 1;
    CHECK(run.run() > 0);
    check_limits(run);
    CHECK((run.references().back().q - run.end()).norm() < 1e-12);
  }
}

TEST_CASE("a leg alone that is held stands after a third-order change of speed, at any instant") {
  // From v, with a on it: a/j until it is gone, by which v + a²/2j is reached, and from there
  // v/A + A/j, or 2·√(v/j) where A is not reached. The guide is ahead by the mean's time.
  constexpr double kJerk = 20;
  for (int instant = 5; instant < 900; instant += 13) {
    CAPTURE(instant);
    AloneRun run(0.3, kJerk);
    run.line(200, 0);
    run.close();
    for (int i = 0; i < instant; ++i) run.step();
    run.guide().brake();
    int periods = 0;
    for (; !(run.guide().stands() && run.stands()); ++periods) run.step();
    constexpr double kRamp = 0.3 + 1 / kJerk;
    CHECK(periods * kPeriod <= kRamp + 1 / kJerk + 3 * kPeriod);
    check_limits(run);
  }
}
