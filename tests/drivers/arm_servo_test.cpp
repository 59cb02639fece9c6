#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "tests/drivers/arm_bench.h"
#include "tests/support/degrees.h"
#include "tests/support/no_allocation.h"

// S2's servo on the simulated UMS-7: 40 ms references, interpolated; what feed-forward is worth,
// and how far errors can go at most.

namespace rob::test {
namespace {

using motion::ArmInertia;
using motion::JointVector;

/// ∫|error| that a unit impulse of torque leaves, times ω²·inertia: of the loop
/// s/(s³ + 2ωs² + ω²s + ω³/10) that ServoLaw makes, at ω = 1. It is 1 without the integral.
double worst_case_gain() {
  constexpr double h = 1e-3;
  double q = 0;
  double v = 1;
  double e = 0;
  double area = 0;
  for (int k = 0; k < 100'000; ++k) {
    v += h * (-2 * v - q - 0.1 * e);
    q += h * v;
    e += h * q;
    area += h * std::abs(q);
  }
  return area;
}

/// The tour of the arm that the servo knows, with feed-forward; each is run once.
const Tracking& known(double period) {
  static std::map<double, Tracking> runs;
  const auto found = runs.find(period);
  if (found != runs.end()) return found->second;
  return runs.emplace(period, track({.servo_period = period})).first->second;
}

/// What the plant takes at t, Coulomb friction aside.
JointVector needed(const drivers::SimArmParameters& plant, double t) {
  const motion::JointReference r = tour(t);
  const motion::Ums7Dynamics& arm = plant.mechanics.dynamics;
  JointVector u = arm.inertia(r.q).times(r.qdd) + arm.coriolis(r.q, r.qd) + arm.gravity(r.q);
  for (int i = 0; i < 6; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const motion::GearedMotor& motor = plant.mechanics.motors[at];
    u[i] = motor.load_factor * u[i] + motor.inertia * r.qdd[i] +
           plant.friction * plant.drives[at].viscous_friction * r.qd[i];
  }
  return u;
}

/// How far the axes can be from the tour, rad: the greatest torque that is not fed forward, in any
/// cycle from its beginning to its end, through the worst case of the loop.
JointVector greatest_error(const TrackingCase& c) {
  const motion::RobotModel robot = ums7(c.bandwidth);
  const drivers::SimArmParameters plant = real_arm(robot, c);
  const motion::FeedForward feed_forward(plant.drives, robot.mechanics);
  const double omega = std::min(c.bandwidth, 0.2 / c.servo_period);
  // Half a period and the encoder's 3.3 ms late the loop is less damped than it is reckoned; while
  // ω·(delay) is below 0.2 that is less than half as much again.
  const double gain = 1.5 * worst_case_gain() / (omega * omega);
  JointVector worst = JointVector::Zero(6);
  for (double t = 0; t < kTourTime; t += c.servo_period) {
    const motion::MotionForces fed = feed_forward.at(tour(t));
    for (const double later : {0.0, c.servo_period}) {
      JointVector lacking = needed(plant, t + later);
      if (c.feed_forward) lacking -= fed.u0;
      lacking = lacking.cwiseAbs();
      for (int i = 0; i < 6; ++i)
        lacking[i] += plant.friction * plant.drives[static_cast<std::size_t>(i)].coulomb_friction;
      worst = worst.cwiseMax(gain * lacking.cwiseQuotient(fed.inertia));
    }
  }
  return worst;
}

}  // namespace

TEST_CASE("the loop passes on a disturbance at most twice as much as without its integral") {
  CHECK(worst_case_gain() > 1);
  CHECK(worst_case_gain() < 2);
}

TEST_CASE("with feed-forward the arm stays within what is left of the torques") {
  for (const double period : {0.020, 0.015, 0.001}) {
    CAPTURE(period);
    const TrackingCase c{.servo_period = period};
    const Tracking& fed = known(period);
    const JointVector bound = greatest_error(c);
    for (int i = 0; i < 6; ++i) {
      CAPTURE(i);
      CHECK(fed.worst[i] < bound[i]);
    }
  }
}

TEST_CASE("PID alone lets the axes lag several times as far as with feed-forward") {
  for (const double period : {0.020, 0.015, 0.001}) {
    CAPTURE(period);
    const Tracking& fed = known(period);
    const Tracking alone = track({.servo_period = period, .feed_forward = false});
    // By the torques, not by how the loop happens to answer: what is not fed forward is mostly
    // friction, a third of all or less.
    const JointVector bound = greatest_error({.servo_period = period, .feed_forward = false});
    const JointVector expected = bound.cwiseQuotient(greatest_error({.servo_period = period}));
    for (int i = 0; i < 6; ++i) {
      CAPTURE(i);
      CHECK(expected[i] > 2);
      CHECK(alone.rms[i] > 2 * fed.rms[i]);
      CHECK(alone.worst[i] > fed.worst[i]);
      CHECK(alone.worst[i] < bound[i]);
    }
  }
}

TEST_CASE("an arm that the servo does not know is followed, less well, within its torques") {
  const TrackingCase cases[] = {{.payload = 3}, {.masses = 1.3}, {.friction = 1.5}};
  for (const TrackingCase& c : cases) {
    const Tracking found = track(c);
    const JointVector bound = greatest_error(c);
    for (int i = 0; i < 6; ++i) {
      CAPTURE(i);
      CHECK(found.worst[i] < bound[i]);
    }
    CHECK(found.rms.norm() > known(c.servo_period).rms.norm());
  }
}

TEST_CASE("a shorter servo period follows better") {
  const Tracking& slow = known(0.020);
  const Tracking& wanted = known(0.015);
  const Tracking& fast = known(0.001);
  for (int i = 0; i < 6; ++i) {
    CHECK(wanted.rms[i] < slow.rms[i]);
    CHECK(fast.rms[i] < wanted.rms[i]);
  }
}

TEST_CASE("no drive is asked for more than it has, whatever the arm carries") {
  ArmBench bench({.payload = 30, .bandwidth = 10});
  double most = 0;
  while (bench.step()) {
    for (int i = 0; i < 6; ++i) {
      const double limit = bench.robot().axes[static_cast<std::size_t>(i)].drive.force_max;
      most = std::max(most, std::abs(bench.command().drive[i]) / limit);
    }
  }
  CHECK(most <= 1);
}

TEST_CASE("a servo every 15 ms gets its references between those of 40 ms") {
  // A quintic of 3 s through its values at both ends of 40 ms is that quintic.
  motion::ReferenceInterpolator interpolator(kKinematicPeriod, JointVector::Constant(6, 2),
                                             JointVector::Constant(6, 10),
                                             JointVector::Constant(6, 100));
  interpolator.reset(tour(0));
  for (int ms = 0; ms < 2900; ++ms) {
    if (ms % 40 == 0) interpolator.push(tour((ms + 40) * 1e-3));
    if (ms % 15 != 0) continue;
    const motion::JointReference at = interpolator.at(ms * 1e-3);
    const motion::JointReference exact = tour(ms * 1e-3);
    REQUIRE((at.q - exact.q).norm() < 1e-12);
    REQUIRE((at.qd - exact.qd).norm() < 1e-10);
    REQUIRE((at.qdd - exact.qdd).norm() < 1e-8);
  }
}

TEST_CASE("a servo cycle of the arm takes no memory") {
  ArmBench bench({});
  const NoAllocation guard;
  for (int k = 0; k < 200; ++k) bench.step();
  CHECK(guard.count() == 0);
}

}  // namespace rob::test
