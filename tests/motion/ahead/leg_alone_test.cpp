#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "tests/motion/ahead/ahead_run.h"

using namespace rob::motion;
using rob::test::AheadRun;
using rob::test::fast_table;

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
  AloneRun(double speed, double most_jerk, std::size_t ahead = 4096)
      : AheadRun(fast_table(), ahead), jerk(most_jerk) {
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

/// Holds and overrides at random instants, `most` periods apart at most; then it must arrive.
template <typename Between>
void disturb(AloneRun& run, Between&& between, double most) {
  for (int change = 0; change < 20 && !run.ended(); ++change) {
    if (between(0, 1) < 0.4) {
      run.guide().braking() ? run.guide().release() : run.guide().brake();
    } else {
      run.ring().share = between(0.05, 2);
    }
    for (int k = static_cast<int>(between(1, most)); k > 0; --k) run.step();
  }
  run.guide().release();
  run.ring().share = 1;
  CHECK(run.run() > 0);
  check_limits(run);
  CHECK((run.references().back().q - run.end()).norm() < 1e-12);
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
    disturb(run, between, 200);
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

// The second leg begins δ before the first has come to rest. With a mean over T, and so J·T, a leg
// takes T + 2·√(T²/4 + d/(J·T)), and the mean lies J·|e₂ − e₁|·δ³/48 beside the point.
TEST_CASE("legs with a stop between them overlap as far as the zone lets them") {
  constexpr double kJerk = 10;
  constexpr double kWay = 0.005;
  const double settles = std::cbrt(kWay / (2 * kJerk));  // of a leg alone
  for (const bool back : {false, true}) {
    for (const double zone_mm : {0.001, 0.02, 0.05, 0.1, 1.0}) {
      CAPTURE(back);
      CAPTURE(zone_mm);
      AloneRun run(1, kJerk);
      run.bounds.miss = zone_mm / 1000;
      run.line(5, 0);
      back ? run.line(0, 0) : run.line(5, 5);
      run.close();
      const double turn = back ? 2 : std::sqrt(2);
      const double widest = std::cbrt(48 * zone_mm / 1000 / (kJerk * turn));
      double best = 1;
      for (double mean = settles; mean < 2 * settles; mean *= 1.001) {
        const double leg = mean + 2 * std::sqrt(mean * mean / 4 + kWay / (kJerk * mean));
        best = std::min(best, 2 * leg - std::min(mean, widest));
      }
      const double taken = run.run();
      CHECK(taken >= best - 2 * kPeriod);
      CHECK(taken <= best + 3 * kPeriod);
      CHECK(run.miss(5, 0) * 1000 <= 1.001 * zone_mm);
      if (widest < settles) CHECK(run.miss(5, 0) * 1000 == doctest::Approx(zone_mm).epsilon(0.05));
      check_limits(run);
    }
  }
}

TEST_CASE("at a turn of any angle two legs take no longer than with a stop, and keep the jerk") {
  for (const double way : {2., 20.}) {
    for (double angle = 5; angle < 180; angle += 12.5) {
      CAPTURE(way);
      CAPTURE(angle);
      const auto taken = [&](bool stop) {
        AloneRun run(0.1, 10);
        run.line(way, 0);
        run.from_rest = stop;
        const double turn = angle * std::acos(-1.0) / 180;
        run.line(way + way * std::cos(turn), way * std::sin(turn));
        run.close();
        const double time = run.run();
        CHECK(run.miss(way, 0) <= 1.01 * run.bounds.miss);
        check_limits(run);
        return time;
      };
      CHECK(taken(false) <= taken(true) + kPeriod / 2);
    }
  }
}

TEST_CASE("held, braked and with any override legs that overlap keep the jerk, and arrive") {
  std::mt19937 random(12);
  const auto between = [&](double least, double most) {
    return std::uniform_real_distribution<double>(least, most)(random);
  };
  for (int attempt = 0; attempt < 40; ++attempt) {
    CAPTURE(attempt);
    AloneRun run(between(0.05, 1), std::exp(between(1, 5)));
    run.bounds.miss = std::exp(between(-12, -6));
    const double way = std::exp(between(0, 4));
    for (int k = 0; k < 6; ++k) run.line(k % 2 == 0 ? way : 0, between(-way, way));
    run.close();
    disturb(run, between, 100);
  }
}

TEST_CASE("legs overlap however few of them may be ahead") {
  const auto taken = [](std::size_t ahead) {
    AloneRun run(1, 10, ahead);
    for (int k = 1; k <= 60; ++k) {
      while (run.buffer().room() == 0) run.step();
      run.line(k % 2 == 1 ? 5 : 0, 0);
    }
    run.close();
    const double time = run.run();
    CHECK((run.references().back().q - run.end()).norm() < 1e-12);
    check_limits(run);
    return time;
  };
  const double all = taken(4096);
  const double stops = 60 * 4 * std::cbrt(0.005 / 20);
  CHECK(all < 0.9 * stops);
  CHECK(taken(16) <= 1.03 * all);  // where there is no room in time, one stops
}
