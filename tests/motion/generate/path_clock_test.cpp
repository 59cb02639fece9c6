#include "motion/generate/path_clock.h"

#include <doctest/doctest.h>

using namespace rob::motion;

namespace {

constexpr TimeScaleLimits kLimits{4.0, 40.0};
constexpr double kClockPeriod = 0.01;

void run_to(PathClock& clock, int from, int to) {
  for (int k = from; k <= to; ++k) clock.advance(k * kClockPeriod, false);
}

}  // namespace

TEST_CASE("while nothing slows the motion, path time is the stamp to the last bit") {
  PathClock clock(kLimits, kClockPeriod);
  for (int k = 0; k < 1000; ++k) {
    clock.advance(k * kClockPeriod, false);
    CHECK(clock.path_time() == k * kClockPeriod);
    CHECK(clock.run_time(k * kClockPeriod - 0.003) == k * kClockPeriod - 0.003);
  }
}

TEST_CASE("a hold and a resume cost the standing time and half of both ramps") {
  PathClock clock(kLimits, kClockPeriod);
  run_to(clock, 0, 100);
  clock.hold();
  run_to(clock, 101, 200);
  CHECK(clock.held());
  // A ramp lasts 1/4 + 4/40 = 0.35 s and gains half of that.
  CHECK(clock.path_time() == doctest::Approx(1.0 + 0.175));
  clock.resume();
  run_to(clock, 201, 300);
  CHECK(clock.rate() == 1);
  // It begins at the stamp 2.01 s: 0.64 s at full speed are left after 2.36 s.
  CHECK(clock.path_time() == doctest::Approx(1.175 + 0.175 + 0.64));
}

TEST_CASE("what the path time will be is announced and kept") {
  PathClock clock(kLimits, kClockPeriod);
  run_to(clock, 0, 10);
  for (int k = 11; k < 400; ++k) {
    const double announced = clock.next();
    if (k % 50 == 20) clock.hold();
    if (k % 50 == 40) clock.resume();
    if (k == 333) clock.set_override(0.3);
    clock.advance(k * kClockPeriod, false);
    CHECK(clock.path_time() <= announced + 1e-15);
  }
}

TEST_CASE("the run's time is found for instants inside a ramp") {
  PathClock clock(kLimits, kClockPeriod);
  run_to(clock, 0, 100);
  clock.hold();
  for (int k = 101; k <= 130; ++k) {
    const double before = clock.path_time();
    clock.advance(k * kClockPeriod, false);
    CHECK(clock.run_time(before) == doctest::Approx((k - 1) * kClockPeriod));
    CHECK(clock.run_time(clock.path_time()) == doctest::Approx(k * kClockPeriod));
  }
}

TEST_CASE("with the axes at rest the time scale changes at once") {
  PathClock clock(kLimits, kClockPeriod);
  clock.advance(0, true);
  clock.hold();
  clock.advance(0.01, true);
  CHECK(clock.held());
  CHECK(clock.path_time() == 0);
  clock.resume();
  clock.set_override(0.5);
  clock.advance(0.02, true);
  CHECK(clock.rate() == 0.5);
  CHECK(clock.path_time() == doctest::Approx(0.005));
}

TEST_CASE("a skipped gap is not run") {
  PathClock clock(kLimits, kClockPeriod);
  run_to(clock, 0, 100);
  clock.skip(1.0);
  clock.advance(2.01, false);
  CHECK(clock.path_time() == doctest::Approx(1.01));
}
