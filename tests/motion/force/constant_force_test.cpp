#include "motion/force/constant_force.h"
#include "tests/support/relative.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <deque>

namespace rob::motion {
namespace {

constexpr double kPeriod = 0.004;
constexpr double kStiffest = 150e3;  // N/m

/// A spring that begins `gap` below where the axis stands, and sinks; told a delay later.
struct Spring {
  double stiffness = 0;
  double gap = 0;
  double sinks = 0;  // m/s
  int delay = 0;     // periods
  double time = 0;
  double acting = 0;          // N
  std::deque<double> told{};  // what has acted and is not felt yet

  double feel(double way) {
    time += kPeriod;
    const double depth = -way - gap - sinks * time;
    acting = std::max(0.0, depth) * stiffness;
    told.push_back(acting);
    if (static_cast<int>(told.size()) <= delay) return 0;
    const double felt = told.front();
    told.pop_front();
    return felt;
  }
};

ConstantForce made(int delay) {
  return ConstantForce({kStiffest, delay * kPeriod, kPeriod, 0.5, 20});
}

/// s from the first contact until the force stays within `band` of the set-point; the greatest
/// force.
struct Approach {
  double settled = 0;
  double greatest = 0;
  double last = 0;
  double fastest = 0;
};

Approach approach(ConstantForce& force, Spring spring, double set_point, double limit,
                  double band = 0.15) {
  Approach seen;
  double contact = -1;
  double outside = 0;
  force.begin(set_point, limit);
  for (double t = 0; t < 4; t += kPeriod) {
    force.step(spring.feel(force.way()));
    const double acting = spring.acting;
    if (contact < 0 && acting > 0) contact = t;
    seen.greatest = std::max(seen.greatest, acting);
    seen.fastest = std::max(seen.fastest, std::abs(force.rate()));
    if (std::abs(acting - set_point) > band * set_point) outside = t;
    seen.last = acting;
  }
  seen.settled = outside - contact;
  return seen;
}

}  // namespace

TEST_CASE("a force is reached within half a second of contact, whatever the stiffness and delay") {
  for (const double stiffness : {20e3, 40e3, 75e3, 150e3}) {
    for (const int delay : {0, 2, 5}) {
      CAPTURE(stiffness);
      CAPTURE(delay);
      ConstantForce force = made(delay);
      const Approach seen = approach(force, {stiffness, 1e-3, 0, delay}, 10, 5e-3);
      CHECK(seen.settled < 0.5);
      CHECK(seen.last == test::relative(10, 1e-3));
      // What is gone within the delay and the period presses with no more than the set-point.
      CHECK(seen.greatest < 10 * 2);
      CHECK(force.settled());
      CHECK(force.stiffness() > stiffness / 1.5);
      CHECK(force.stiffness() < stiffness * 1.5);
    }
  }
}

TEST_CASE("a sensor may be quicker than is known: the stiffness is learned all the same") {
  for (const double stiffness : {20e3, 40e3, 75e3, 110e3, 150e3}) {
    for (const int delay : {0, 1, 2, 3, 4, 5}) {
      CAPTURE(stiffness);
      CAPTURE(delay);
      ConstantForce force = made(5);
      const Approach seen = approach(force, {stiffness, 1e-3, 0, delay}, 10, 5e-3);
      CHECK(seen.settled < 0.5);
      CHECK(seen.last == test::relative(10, 1e-3));
      CHECK(force.stiffness() > stiffness / 1.5);
      CHECK(force.stiffness() < stiffness * 1.5);
    }
  }
}

TEST_CASE("what is pressed on may sink: the integral leaves no error") {
  // S4's cap: 0.8 rad/s at a pitch of 3 mm a turn
  ConstantForce force = made(5);
  const double sinks = 0.8 / (2 * 3.14159265358979) * 3e-3;
  const Approach seen = approach(force, {60e3, 1e-3, sinks, 5}, 10, 5e-3);
  CHECK(seen.last == test::relative(10, 0.01));
  CHECK(force.rate() == test::relative(-sinks, 0.01));
}

TEST_CASE("speed, acceleration and jerk along the axis stay within what was asked for") {
  ConstantForce force = made(2);
  const Approach slow = approach(force, {20e3, 1e-3, 0, 2}, 50, 1e-3, 0.5);
  CHECK(slow.fastest <= 1e-3 + 1e-12);
  Spring spring{20e3, 1e-3, 0, 2};
  force.begin(10, 5e-3);
  double before = 0;
  double acceleration = 0;
  for (int k = 0; k < 500; ++k) {
    force.step(spring.feel(force.way()));
    CHECK(std::abs(force.rate() - before) <= 0.5 * kPeriod + 1e-12);
    CHECK(std::abs(force.acceleration() - acceleration) <= 20 * kPeriod + 1e-12);
    const double gained = (acceleration + force.acceleration()) / 2 * kPeriod;
    CHECK(std::abs(force.rate() - before - gained) < 1e-15);
    before = force.rate();
    acceleration = force.acceleration();
  }
}

TEST_CASE("a force of the other sign goes the other way, and braking ends it") {
  ConstantForce force = made(0);
  force.begin(-5, 5e-3);
  for (int k = 0; k < 50; ++k) force.step(0);
  CHECK(force.rate() > 0);
  CHECK_FALSE(force.settled());
  for (int k = 0; k < 20; ++k) force.brake();
  CHECK(force.rate() == 0);
}

}  // namespace rob::motion
