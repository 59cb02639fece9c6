#include "drivers/sim/sim_axis.h"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "tests/support/relative.h"

namespace rob::drivers {
namespace {

// 12 kg, 4 N/(m/s), 60 N.
motion::DriveData drive(double coulomb) {
  motion::DriveData d;
  d.inertia = 12;
  d.viscous_friction = 4;
  d.coulomb_friction = coulomb;
  d.force_max = 60;
  d.encoder_resolution = 1e-6;
  return d;
}

SimAxis at_rest(const motion::DriveData& d) {
  SimAxis axis(d);
  axis.place(0);
  return axis;
}

}  // namespace

TEST_CASE("a constant force brings the axis to u/b as 1 − exp(−b·t/m)") {
  SimAxis axis = at_rest(drive(0));
  axis.push(2);
  for (int k = 1; k <= 2000; ++k) {
    axis.advance(0.01);
    const double t = 0.01 * k;
    const double expected = 0.5 * (1 - std::exp(-t / 3));
    REQUIRE(axis.v() == test::relative(expected, 1e-10));
    REQUIRE(axis.q() == test::relative(0.5 * t - 3 * expected, 1e-10));
  }
}

TEST_CASE("a step is exact on both sides of where the series takes over from the closed form") {
  for (const double x : {0.0031, 0.0099, 0.0101, 0.4, 5.0}) {  // b·t/m
    SimAxis axis = at_rest(drive(0));
    axis.push(2);
    axis.advance(3 * x);
    const long double fade = -std::expm1(-static_cast<long double>(x));
    const long double q = 0.5L * 3 * x - 3 * 0.5L * fade;
    // Below 0.01 the series; above, the closed form loses 1/x to cancellation.
    CHECK(axis.q() == test::relative(static_cast<double>(q), x < 0.01 ? 1e-14 : 1e-12));
    CHECK(axis.v() == test::relative(static_cast<double>(0.5L * fade), 1e-14));
  }
}

TEST_CASE("one long step and many short ones lead to the same place") {
  for (const double viscous : {0.0, 1e-6, 4.0, 400.0}) {
    motion::DriveData d = drive(0.3);
    d.viscous_friction = viscous;
    SimAxis one = at_rest(d);
    SimAxis many = at_rest(d);
    for (const double force : {10.0, -0.2, -25.0, 0.1}) {
      one.push(force);
      many.push(force);
      one.advance(0.7);
      for (int k = 0; k < 2800; ++k) many.advance(0.7 / 2800);
      CHECK(one.q() == test::relative(many.q()));
      CHECK(one.v() == test::relative(many.v()));
    }
  }
}

TEST_CASE("without viscous friction the axis accelerates evenly") {
  motion::DriveData d = drive(2);
  d.viscous_friction = 0;
  SimAxis axis = at_rest(d);
  axis.push(14);  // (14 − 2)/12 = 1 m/s²
  axis.advance(0.5);
  CHECK(axis.v() == test::relative(0.5, 1e-14));
  CHECK(axis.q() == test::relative(0.125, 1e-14));
  axis.release();  // 2/12 m/s² stop it after 3 s and 0.75 m
  axis.advance(2.9);
  CHECK(axis.v() > 0);
  axis.advance(0.2);
  CHECK(axis.v() == 0);
  CHECK(axis.q() == test::relative(0.875, 1e-12));
}

TEST_CASE("a force below Coulomb friction moves nothing at all") {
  SimAxis axis = at_rest(drive(0.3));
  for (int k = 0; k < 1000; ++k) {
    axis.push(k % 2 == 0 ? 0.3 : -0.29);
    axis.advance(0.005);
  }
  CHECK(axis.q() == 0);
  CHECK(axis.v() == 0);
  axis.push(0.31);
  axis.advance(0.005);
  CHECK(axis.q() > 0);
}

TEST_CASE("friction stops the axis and does not set it in motion again") {
  SimAxis axis = at_rest(drive(0.3));
  axis.push(5);
  axis.advance(0.1);
  axis.push(-0.2);
  // v' = −(0.5 + 4v)/12: rest after 3·ln(1 + 8v) s.
  const double stops_after = 3 * std::log(1 + 8 * axis.v());
  SimAxis shortly_before = axis;
  shortly_before.advance(stops_after * (1 - 1e-9));
  CHECK(shortly_before.v() > 0);
  axis.advance(stops_after * (1 + 1e-9));
  CHECK(axis.v() == 0);
  const double q = axis.q();
  axis.advance(10);
  CHECK(axis.q() == q);
}

TEST_CASE("a force that outlasts the stop turns the axis round") {
  motion::DriveData d = drive(2);
  d.viscous_friction = 0;
  SimAxis axis = at_rest(d);
  axis.push(14);
  axis.advance(0.7);  // 0.7 m/s at 0.245 m
  axis.push(-14);     // −16/12 m/s²: rest after 0.525 s and 0.18375 m; back with 1 m/s²
  axis.advance(0.525 + 0.4);
  CHECK(axis.v() == test::relative(-0.4, 1e-12));
  CHECK(axis.q() == test::relative(0.245 + 0.18375 - 0.08, 1e-12));
}

TEST_CASE("work done is kinetic energy and what friction took") {
  std::mt19937 random(31);
  std::uniform_real_distribution<double> force(-20, 20);
  const motion::DriveData d = drive(0.3);
  SimAxis axis = at_rest(d);
  double work = 0;
  double taken = 0;
  for (int n = 0; n < 200; ++n) {
    const double u = force(random);
    axis.push(u);
    for (int k = 0; k < 1000; ++k) {
      const double q = axis.q();
      const double v = axis.v();
      axis.advance(1e-4);
      const double way = axis.q() - q;
      const double mean = 0.5 * (v + axis.v());
      work += u * way;
      taken += d.viscous_friction * mean * mean * 1e-4 + d.coulomb_friction * std::abs(way);
    }
  }
  const double kinetic = 0.5 * d.inertia * axis.v() * axis.v();
  CHECK(work == test::relative(kinetic + taken, 1e-4));
  CHECK(taken > 0.1);
}

TEST_CASE("all samples of a servo period at once lead where they lead one by one") {
  constexpr int kSamples = 20;
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> force(-8, 8);
  for (const double viscous : {0.0, 4.0, 400.0}) {
    motion::DriveData d = drive(0.3);
    d.viscous_friction = viscous;
    d.encoder_resolution = 1e-9;  // what rounding makes of a count changes the velocity by less
    SimAxis at_once = at_rest(d);
    SimAxis one_by_one = at_rest(d);
    for (int period = 0; period < 2000; ++period) {
      // Also such as do not move it; it stops and turns now and then.
      const double u = period % 7 == 0 ? 0.2 : force(random);
      at_once.push(u);
      one_by_one.push(u);
      at_once.advance_sampled(kSamples);
      for (int i = 0; i < kSamples; ++i) {
        one_by_one.advance(Encoder::kPeriod);
        one_by_one.sample();
      }
      REQUIRE(std::abs(at_once.q() - one_by_one.q()) < 1e-11);
      REQUIRE(std::abs(at_once.v() - one_by_one.v()) < 1e-12);
      REQUIRE(std::abs(at_once.measured_v() - one_by_one.measured_v()) < 2e-7);
    }
  }
}

TEST_CASE("the motor gives no more than its greatest force, and none for what is no number") {
  SimAxis limited = at_rest(drive(0));
  SimAxis full = at_rest(drive(0));
  limited.push(1e6);
  full.push(60);
  limited.advance(0.1);
  full.advance(0.1);
  CHECK(limited.v() == full.v());
  SimAxis broken = at_rest(drive(0));
  broken.push(std::nan(""));
  broken.advance(0.1);
  CHECK(broken.q() == 0);
}

TEST_CASE("a drive that holds brakes with all its force, then stands") {
  SimAxis axis = at_rest(drive(0));
  axis.push(60);
  axis.advance(0.1);
  const double v = axis.v();
  axis.hold();
  axis.advance(0.2);  // about as long as it took to get there
  CHECK(axis.v() == 0);
  // Between the ways of braking with and without viscous friction helping.
  CHECK(axis.q() < 0.1 * v / 2 * 1.02 + v * v * 12 / (2 * 60));
}

}  // namespace rob::drivers
