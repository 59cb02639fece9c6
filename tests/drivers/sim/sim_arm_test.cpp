#include "drivers/sim/sim_arm.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "drivers/sim/sim_axis.h"
#include "tests/drivers/arm_bench.h"
#include "tests/support/no_allocation.h"

namespace rob::drivers {
namespace {

using motion::ArmMechanics;
using motion::JointVector;
using motion::ServoCommand;
using motion::ServoState;

constexpr double kCycle = 0.005;

/// The UMS-7 of its file, holding `payload`.
SimArmParameters ums7(double payload = 0, double friction = 1) {
  test::TrackingCase c;
  c.payload = payload;
  c.friction = friction;
  return test::real_arm(test::ums7(10), c);
}

ServoCommand drive(const JointVector& u) {
  ServoCommand command;
  command.drive = u;
  return command;
}

JointVector only(int axis, double u) {
  JointVector v = JointVector::Zero(6);
  v[axis] = u;
  return v;
}

/// Switched on at 0, and given u(t) every cycle until `end`.
template <typename Force>
void run(SimArm& arm, double end, const Force& u) {
  arm.open();
  arm.enable(0);
  for (int k = 0; k * kCycle < end; ++k) arm.write(k * kCycle, drive(u(k * kCycle)));
  ServoState state;
  arm.read(end, state);
}

JointVector true_positions(const SimArm& arm) {
  JointVector q(6);
  for (int i = 0; i < 6; ++i) q[i] = arm.true_position(i);
  return q;
}

/// Where a frictionless arm swings to from `q` in `time`, in twenty times finer steps of another
/// method: Störmer's central differences, with the velocity of the last step.
JointVector swing(const ArmMechanics& arm, JointVector q, double time) {
  constexpr double h = 1e-5;
  JointVector rotors(6);
  for (int i = 0; i < 6; ++i) {
    const auto& motor = arm.motors[static_cast<std::size_t>(i)];
    rotors[i] = motor.inertia / motor.load_factor;
  }
  JointVector v = JointVector::Zero(6);
  for (long k = 0; k < std::lround(time / h); ++k) {
    motion::ArmInertia m = arm.dynamics.inertia(q);
    m.add_diagonal(rotors);
    v += h * m.solve(-arm.dynamics.coriolis(q, v) - arm.dynamics.gravity(q));
    q += h * v;
  }
  return q;
}

}  // namespace

TEST_CASE("an arm without friction swings as the complete mechanics say") {
  const SimArmParameters parameters = ums7(10, 0);
  SimArm arm(parameters);
  run(arm, 1, [](double) { return JointVector::Zero(6); });
  const JointVector expected = swing(parameters.mechanics, parameters.start, 1);
  CHECK((expected - parameters.start).norm() > 0.5);  // it has gone far
  CHECK((true_positions(arm) - expected).norm() < 1e-4);
}

TEST_CASE("axis 6 moves as a single axis does: accelerated, braked by friction, turned round") {
  const SimArmParameters parameters = ums7();
  SimArm arm(parameters);
  motion::DriveData alone = parameters.drives[5];
  const motion::GearedMotor& motor = parameters.mechanics.motors[5];
  alone.inertia = motor.load_factor * parameters.mechanics.dynamics.parameters().c8 + motor.inertia;
  SimAxis axis(alone);
  axis.place(0);
  const auto force = [](double t) { return t < 0.2 ? 1.0 : t < 0.5 ? 0.02 : t < 0.8 ? -1.0 : 0.0; };
  for (int k = 0; k < 400; ++k) {
    axis.push(force(k * kCycle));
    axis.advance(kCycle);
  }
  run(arm, 2, [&](double t) { return only(5, force(t)); });
  CHECK(std::abs(axis.q()) > 0.1);
  CHECK(axis.v() == 0);
  // Where it turns round is found to a step: 250 us at 0.3 rad/s at most.
  CHECK(arm.true_position(5) == doctest::Approx(axis.q()).epsilon(1e-3));
}

TEST_CASE("an axis at rest stays exactly there until more than its friction pulls") {
  const SimArmParameters parameters = ums7();
  SimArm arm(parameters);
  const double stuck = 0.99 * parameters.drives[0].coulomb_friction;
  run(arm, 1, [&](double) { return only(0, stuck); });
  CHECK(true_positions(arm) == parameters.start);  // the hand's weight is less than friction, too
  run(arm, 1, [&](double) { return only(0, 1.02 * stuck); });
  CHECK(arm.true_position(0) > parameters.start[0]);
}

TEST_CASE("a heavy load makes the arm sink, its brakes hold it") {
  const SimArmParameters parameters = ums7(10);
  SimArm arm(parameters);
  run(arm, 0.2, [](double) { return JointVector::Zero(6); });
  CHECK(arm.true_position(1) > parameters.start[1] + 0.01);  // axis 2 turns downwards
  const double begin = 0.2;
  ServoState state;
  arm.disable(begin);
  arm.read(begin + 0.1, state);
  const JointVector stopped = true_positions(arm);
  arm.read(begin + 100, state);
  CHECK(true_positions(arm) == stopped);
  CHECK(state.measured.qd.norm() == 0);
}

TEST_CASE("powered up and not yet driven the arm stands") {
  const SimArmParameters parameters = ums7(10);
  SimArm arm(parameters);
  arm.open();
  ServoState state;
  arm.read(0, state);
  arm.read(5, state);
  arm.enable(5);
  arm.read(5.2, state);
  CHECK(true_positions(arm) == parameters.start);
}

TEST_CASE("drives that hear nothing for 250 ms brake by themselves") {
  SimArm arm(ums7());
  arm.open();
  arm.enable(0);
  arm.write(0, drive(only(0, 100)));
  ServoState state;
  arm.read(0.249, state);
  CHECK(state.measured.qd[0] > 0.5);
  arm.read(0.3, state);
  CHECK(std::abs(state.measured.qd[0]) < 1e-6);
}

TEST_CASE("a drive gives no more than its motor has, and nothing for no number") {
  const SimArmParameters parameters = ums7();
  SimArm most(parameters);
  SimArm more(parameters);
  run(most, 0.1, [&](double) { return only(3, parameters.drives[3].force_max); });
  run(more, 0.1, [&](double) { return only(3, 1e6); });
  CHECK(true_positions(most) == true_positions(more));
  run(more, 0.1, [&](double) { return only(3, std::nan("")); });
  CHECK(true_positions(more) == parameters.start);
}

TEST_CASE("axes feel each other: accelerating axis 2 throws axis 3") {
  const SimArmParameters parameters = ums7(0, 0);
  SimArm arm(parameters);
  run(arm, 0.05, [](double) { return only(1, 200); });
  CHECK(arm.true_position(1) > parameters.start[1]);
  CHECK(arm.true_position(2) < parameters.start[2] - 1e-3);
}

TEST_CASE("the encoders tell the place in counts, and the speed") {
  const SimArmParameters parameters = ums7();
  SimArm arm(parameters);
  run(arm, 0.2, [](double) { return only(0, 100); });
  ServoState state;
  arm.read(0.2, state);
  const double count = parameters.drives[0].encoder_resolution;
  CHECK(std::abs(state.measured.q[0] - arm.true_position(0)) <= 0.5001 * count);
  const double before = arm.true_position(0);
  arm.read(0.201, state);
  CHECK(state.measured.qd[0] ==
        doctest::Approx((arm.true_position(0) - before) / 0.001).epsilon(0.05));
}

TEST_CASE("the same calls give the same bits, and take no memory") {
  const auto force = [](double t) {
    JointVector u(6);
    for (int i = 0; i < 6; ++i) u[i] = (i < 3 ? 60 : 3) * std::sin(7 * t + i);
    return u;
  };
  SimArm one(ums7(3));
  SimArm two(ums7(3));
  run(one, 1, force);
  const test::NoAllocation guard;
  run(two, 1, force);
  CHECK(guard.count() == 0);
  CHECK(true_positions(one) == true_positions(two));
}

TEST_CASE("an arm has six drives and six start values") {
  SimArmParameters parameters = ums7();
  parameters.drives.pop_back();
  CHECK_THROWS_AS(SimArm{parameters}, std::invalid_argument);
  parameters = ums7();
  parameters.start.conservativeResize(5);
  CHECK_THROWS_AS(SimArm{parameters}, std::invalid_argument);
  parameters = ums7();
  parameters.actuators.push_back({64, 0, 1, 0.1});
  CHECK_THROWS_AS(SimArm{parameters}, std::invalid_argument);
}

}  // namespace rob::drivers
