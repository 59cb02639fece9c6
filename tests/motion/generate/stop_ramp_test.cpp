#include "motion/generate/stop_ramp.h"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "tests/support/no_allocation.h"

using namespace rob::motion;

namespace {

constexpr TimeScaleLimits kLimits{4.0, 40.0};

}  // namespace

TEST_CASE("a stop from full speed takes 1/R + R/S and half of that in path time") {
  StopRamp ramp(kLimits);
  ramp.aim(0);
  CHECK(ramp.remaining() == doctest::Approx(1 / 4.0 + 4.0 / 40.0));
  CHECK(ramp.advance(0.35) == doctest::Approx(0.35 / 2));
  CHECK(ramp.rate() == doctest::Approx(0));
  ramp.advance(0.01);
  CHECK(ramp.rate() == 0);  // exactly
  CHECK(ramp.slope() == 0);
  CHECK(ramp.advance(5) == 0);
}

TEST_CASE("a small change never reaches the greatest slope") {
  StopRamp ramp(kLimits);
  ramp.aim(0.9);  // |r'| peaks at √(0.1·40) = 2, after 2/40 s
  CHECK(ramp.remaining() == doctest::Approx(0.1));
  ramp.advance(0.05);
  CHECK(ramp.slope() == doctest::Approx(-2));
  CHECK(ramp.rate() == doctest::Approx(0.95));
}

TEST_CASE("a ramp that is turned round keeps r, r' and their bounds") {
  std::mt19937 random(11);
  std::uniform_real_distribution<> share(0, 1);
  StopRamp ramp(kLimits);
  const double dt = 0.001;
  for (int i = 0; i < 20'000; ++i) {
    if (share(random) < 0.02) ramp.aim(share(random) < 0.3 ? 0 : share(random));
    const double rate = ramp.rate();
    const double slope = ramp.slope();
    const double gained = ramp.advance(dt);
    REQUIRE(ramp.rate() >= -1e-14);
    REQUIRE(ramp.rate() <= 1 + 1e-14);
    REQUIRE(std::abs(ramp.slope()) <= kLimits.slope * (1 + 1e-12));
    REQUIRE(std::abs(ramp.slope() - slope) <= kLimits.bend * dt * (1 + 1e-9));
    // Trapezium rule for r and for the gain: |r''| and |r'| changes bound the errors.
    REQUIRE(std::abs(ramp.rate() - rate - (slope + ramp.slope()) / 2 * dt) <=
            kLimits.bend * dt * dt / 4);
    REQUIRE(std::abs(gained - (rate + ramp.rate()) / 2 * dt) <= kLimits.bend * dt * dt * dt / 6);
  }
}

TEST_CASE("a ramp is the same in one long step and in many short ones") {
  StopRamp one(kLimits);
  StopRamp many(kLimits);
  one.aim(0.2);
  many.aim(0.2);
  double gained = 0;
  for (int i = 0; i < 170; ++i) gained += many.advance(0.001);
  CHECK(one.advance(0.17) == doctest::Approx(gained).epsilon(1e-12));
  CHECK(one.rate() == doctest::Approx(many.rate()).epsilon(1e-12));
}

TEST_CASE("the time at which a gain is reached is found") {
  StopRamp ramp(kLimits);
  ramp.aim(0);
  for (const double dt : {0.0, 0.003, 0.01}) {
    StopRamp ahead = ramp;
    CHECK(ramp.time_to_gain(ahead.advance(dt), 0.01) == doctest::Approx(dt).epsilon(1e-9));
  }
}

TEST_CASE("a stop ramp takes no memory") {
  rob::test::NoAllocation guard;
  StopRamp ramp(kLimits);
  ramp.aim(0);
  double gained = ramp.advance(0.1);
  ramp.aim(1);
  gained += ramp.time_to_gain(0.001, 0.01) + ramp.advance(1);
  CHECK(gained > 0);
  CHECK(guard.count() == 0);
}
