#include "motion/space/speed_change.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <random>

#include "tests/support/relative.h"

namespace rob::motion {

TEST_CASE("a change of speed takes v/a + a/j, or 2·√(v/j) where it is small") {
  CHECK(speed_change({0, 0, 0}, 1, {0, 2, 40}).duration() == test::relative(0.55, 1e-15));
  CHECK(speed_change({0, 1, 0}, 0, {0, 2, 40}).duration() == test::relative(0.55, 1e-15));
  CHECK(speed_change({0, 0, 0}, 0.025, {0, 2, 40}).duration() == test::relative(0.05, 1e-15));
  CHECK(speed_change({0, 0, 0}, 1, {0, 2, std::numeric_limits<double>::infinity()}).duration() ==
        test::relative(0.5, 1e-15));
  CHECK(speed_change({0, 1, 0}, 1, {0, 2, 40}).duration() == 0);
}

TEST_CASE("acceleration that would lead too far is taken back and more") {
  // a = 2 leads from 1 to 1 + 2²/80 = 1.05 by itself, then down by 0.05: peak √(40·0.05) = √2
  const SpeedChange change = speed_change({0, 1, 2}, 1, {0, 2, 40});
  CHECK(change.duration() == test::relative((2 + 2 * std::sqrt(2.0)) / 40, 1e-14));
  CHECK(change.phases[1].acceleration == test::relative(-std::sqrt(2.0), 1e-14));
}

TEST_CASE("an acceleration beyond its limit is first brought back, not held") {
  // from 6 to 2 in 0.1 s, which gains 0.4; 2 to 0 gains 0.05; 0.55 at 2 between
  const SpeedChange change = speed_change({0, 0, 6}, 1, {0, 2, 40});
  CHECK(change.phases[0].duration == test::relative(0.1, 1e-14));
  CHECK(change.phases[1].duration == test::relative(0.275, 1e-14));
  CHECK(change.phases[2].duration == test::relative(0.05, 1e-14));
}

TEST_CASE("from any state a change of speed ends at it, without acceleration") {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> share(-1, 1);
  for (int i = 0; i < 2000; ++i) {
    const AxisLimits limits{1, std::pow(10, share(random)), std::pow(10, 1 + share(random))};
    const double a = 2 * limits.a * share(random);
    const double target = 2 * share(random);
    const SpeedChange change = speed_change({0, 2 * share(random), a}, target, limits);
    AxisState state{0, 0, a};
    for (const JerkPhase& phase : change.phases) {
      if (phase.duration == 0) continue;
      REQUIRE(phase.duration > 0);
      REQUIRE(std::abs(phase.acceleration - state.a) < 1e-12 * limits.a);
      state = phase.after(state, phase.duration);
    }
    REQUIRE(std::abs(state.a) < 1e-12 * limits.a);
    const AxisState from{0, share(random), a};
    REQUIRE(std::abs(speed_change(from, target, limits).end(from).v - target) < 1e-12);
  }
}

}  // namespace rob::motion
