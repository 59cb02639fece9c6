#include "motion/servo/feed_forward.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "motion/servo/servo_law.h"
#include "tests/motion/dynamics/random_arm.h"
#include "tests/support/no_allocation.h"
#include "tests/support/relative.h"

namespace rob::motion {
namespace {

using test::axis;
using test::plain_arm;
using test::random_six;
using test::relative;

std::array<DriveData, 6> drives() {
  std::array<DriveData, 6> all;
  for (DriveData& drive : all) {
    drive.inertia = 1;
    drive.viscous_friction = 3;
    drive.force_max = 1e4;
    drive.bandwidth = 10;
  }
  return all;
}

ArmMechanics mechanics(double torque_max = 1e6) {
  ArmMechanics arm{Ums7Dynamics(plain_arm()), {}};
  for (GearedMotor& motor : arm.motors) motor = {1.25, 2, torque_max};
  return arm;
}

JointVector zero() { return JointVector::Zero(6); }

}  // namespace

TEST_CASE("S2's feed-forward: load, rotor and viscous friction, by hand") {
  // Stretched out level, the hand hanging down: H11 = C0 + C1 + C2 + C3, G5 = 0, G4 = 0.
  JointVector q = zero();
  q[2] = q[4] = std::numbers::pi / 2;
  const Ums7Parameters p = plain_arm();
  const FeedForward law(drives(), mechanics());
  const MotionForces forces = law.at({0, q, axis(0, 0.5), axis(0, 2)});
  const double h11 = p.c0 + p.c1 + p.c2 + p.c3;
  CHECK(forces.u0[0] == relative(1.25 * h11 * 2 + 2 * 2 + 3 * 0.5));
  CHECK(forces.u0[1] == 0);  // no Coriolis terms
  CHECK(forces.inertia[0] == relative(1.25 * h11 + 2));
  CHECK(forces.load == relative(h11 * 2 / 1e6));
}

TEST_CASE("acceleration of axis 2 takes torque of axis 3, and weight of axis 5") {
  JointVector q = zero();
  q[2] = std::numbers::pi / 2;  // the hand along the level forearm
  const Ums7Parameters p = plain_arm();
  const FeedForward law(drives(), mechanics());
  const MotionForces forces = law.at({0, q, zero(), axis(1, 1)});
  CHECK(forces.u0[1] == relative(1.25 * (p.c4 + p.c2) + 2));
  CHECK(forces.u0[2] == relative(1.25 * (p.c3 + p.c5)));
  CHECK(forces.u0[4] == relative(-1.25 * p.c6));
  CHECK(forces.u0[3] == 0);
}

TEST_CASE("what is carried weighs at every axis, mass times gravity times its lever, by hand") {
  // Level: upper arm and forearm of 0.4 m, the hand of 0.1 m along them; 2 kg 0.15 m before the
  // flange and 0.05 m to its y, which lies level, too.
  JointVector q = zero();
  q[2] = std::numbers::pi / 2;
  ArmMechanics arm = mechanics();
  arm.lengths = {0.4, 0.4, 0.1};
  FeedForward law(drives(), arm);
  const MotionForces bare = law.at({0, q, zero(), zero()});
  law.carry(ArmLoad::point(2, {0, 0.05, 0.15}));
  const MotionForces loaded = law.at({0, q, zero(), zero()});
  const double weight = 1.25 * 2 * 9.80665;
  const JointVector more = loaded.u0 - bare.u0;
  CHECK(std::abs(more[0]) < 1e-12);
  CHECK(more[1] == relative(-weight * (0.4 + 0.4 + 0.1 + 0.15)));
  CHECK(more[2] == relative(-weight * (0.4 + 0.1 + 0.15)));
  CHECK(more[3] == relative(weight * 0.05));
  CHECK(more[4] == relative(-weight * (0.1 + 0.15)));
  CHECK(more[5] == relative(weight * 0.05));
  CHECK((law.load_weight(q) - more).norm() < 1e-12);
  // S2 counts its inertia about axis 1 at the wrist.
  CHECK(loaded.inertia[0] == relative(bare.inertia[0] + 1.25 * 2 * 0.8 * 0.8));
  law.carry({});
  CHECK((law.at({0, q, zero(), zero()}).u0 - bare.u0).norm() == 0);
}

TEST_CASE("an integral gives up what it has learned of a weight that is told, and no more") {
  JointVector q = zero();
  q[2] = std::numbers::pi / 2;
  ArmMechanics arm = mechanics();
  arm.lengths = {0.4, 0.4, 0.1};
  const double weight = 1.25 * 2 * 9.80665 * (0.1 + 0.15);  // pulls at axis 5 towards more
  // The force of axis 5 before and after, where the integral has pushed by so much before.
  const auto told = [&](double pushed) {
    ServoLaw law(drives(), 0.02, arm);
    law.reset(0);
    const JointReference at{0, q, zero(), zero()};
    const double bare = law.update(0, at, {0, q, zero()})[4];
    law.update(1, at, {0, q - axis(4, 1e-6), zero()});
    const double of_one = law.update(1, at, {0, q, zero()})[4] - bare;
    law.reset(0);
    law.update(1, at, {0, q - axis(4, 1e-6 * pushed / of_one), zero()});
    const double before = law.update(1, at, {0, q, zero()})[4];
    CHECK(before - bare == relative(pushed));
    law.carry(ArmLoad::point(2, {0, 0, 0.15}));
    return law.update(1, at, {0, q, zero()})[4] - before;
  };
  CHECK(std::abs(told(-2 * weight)) < 1e-9);              // all of it had been learned, and more
  CHECK(told(-weight / 4) == relative(-weight * 3 / 4));  // a quarter of it
  CHECK(told(weight / 4) == relative(-weight));           // something else
}

TEST_CASE("torques beyond the gears are limited, and accelerations to what is admissible") {
  const ArmMechanics arm = mechanics(4);
  const FeedForward law(drives(), arm);
  std::mt19937 random(1);
  int limited = 0;
  for (int k = 0; k < 100; ++k) {
    const JointVector q = random_six(random, 3);
    const JointVector qdd = random_six(random, 1);
    const MotionForces forces = law.at({0, q, zero(), qdd});
    const JointVector G = arm.dynamics.published_gravity(q);
    const JointVector P = arm.dynamics.inertia(q).times(qdd) + G;
    CHECK(forces.load == relative(P.cwiseAbs().maxCoeff() / 4));
    limited += forces.load > 1 ? 1 : 0;
    // With Da = 1.25 and Db = 2: u0 = 1.25·(H·a + G) + 2·a, to be solved for a.
    ArmInertia driven = arm.dynamics.inertia(q);
    driven.add_diagonal(JointVector::Constant(6, 2 / 1.25));
    const JointVector a = driven.solve(forces.u0 / 1.25 - G);
    const JointVector admitted = arm.dynamics.inertia(q).times(a) + G;
    CHECK(admitted.cwiseAbs().maxCoeff() < 4 + 1e-9);
    if (forces.load <= 1) CHECK((a - qdd).norm() < 1e-9);
  }
  CHECK(limited > 20);
  CHECK(limited < 80);
}

TEST_CASE("the law counts a torque beyond the gears as saturation") {
  ServoLaw law(drives(), 0.02, mechanics(4));
  law.reset(0);
  JointVector q = zero();
  q[2] = std::numbers::pi / 2;
  law.update(0, {0, q, zero(), axis(0, 3)}, {0, q, zero()});
  const Ums7Parameters p = plain_arm();
  CHECK(law.take_saturation() == relative(3 * (p.c0 + p.c1 + p.c2 + p.c3) / 4));
}

TEST_CASE("the gains vary with the posture, as the inertia that the drive moves") {
  ServoLaw law(drives(), 0.02, mechanics());
  JointVector q = zero();
  for (const double q3 : {0.0, std::numbers::pi / 2}) {
    q[2] = q3;
    law.reset(0);
    const double u = law.update(0, {0, q + axis(0, 0.01), zero(), zero()}, {0, q, zero()})[0];
    const Ums7Parameters p = plain_arm();
    const double h11 = q3 == 0 ? p.c0 + p.c1 : p.c0 + p.c1 + p.c2 + p.c3;
    CHECK(u == relative(100 * (1.25 * h11 + 2) * 0.01));
    law.reset(0);
    const double damped = law.update(0, {0, q, axis(0, 0.1), zero()}, {0, q, zero()})[0];
    CHECK(damped == relative((2 * 10 * (1.25 * h11 + 2) - 3) * 0.1 + 3 * 0.1));
  }
}

TEST_CASE("PID alone is the law less its feed-forward") {
  std::mt19937 random(2);
  const JointReference at{0, random_six(random, 3), random_six(random, 1), random_six(random, 1)};
  const JointMeasurement found{0, at.q + random_six(random, 0.01), at.qd};
  ServoLaw whole(drives(), 0.02, mechanics());
  ServoLaw alone(drives(), 0.02, mechanics());
  alone.leave_out_feed_forward();
  const JointVector u0 = FeedForward(drives(), mechanics()).at(at).u0;
  CHECK((whole.update(0, at, found) - alone.update(0, at, found) - u0).norm() < 1e-9);
}

TEST_CASE("feed-forward and law of an arm take no memory") {
  ServoLaw law(drives(), 0.02, mechanics(4));
  const JointVector q = JointVector::Constant(6, 0.4);
  test::NoAllocation guard;
  law.reset(0);
  law.carry(ArmLoad::point(2, {0.01, 0.02, 0.03}));
  const double u = law.update(0.02, {0, q, q, 10 * q}, {0, q, q})[0];
  CHECK(guard.count() == 0);
  CHECK(u != 0);
}

}  // namespace rob::motion
