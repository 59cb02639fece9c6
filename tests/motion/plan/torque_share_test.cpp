#include "motion/plan/torque_share.h"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "motion/path/paul_transition.h"
#include "motion/robots/robot_library.h"
#include "tests/support/degrees.h"
#include "tests/support/no_allocation.h"
#include "tests/support/relative.h"

namespace rob::motion {
namespace {

using rob::test::kDegree;
using test::relative;

JointVector vector_of(std::initializer_list<double> values) {
  JointVector v(static_cast<Eigen::Index>(values.size()));
  std::copy(values.begin(), values.end(), v.data());
  return v;
}

JointVector degrees(std::initializer_list<double> values) { return vector_of(values) * kDegree; }

JointVector random_vector(std::mt19937& random, double reach) {
  std::uniform_real_distribution<double> value(-reach, reach);
  JointVector v(6);
  for (double& x : v) x = value(random);
  return v;
}

/// The UMS-7 with gears that bear so much less.
RobotModel weak_arm(double divisor) {
  RobotModel robot = embedded_robot("ums7");
  for (GearedMotor& motor : robot.mechanics->motors) motor.torque_max /= divisor;
  return robot;
}

}  // namespace

TEST_CASE("an arm at rest takes the weight of its hand, and nothing else") {
  // Level hand: 2.35 Nm at axes 2, 3 and 5, of gears for 300, 150 and 30 Nm and drives for 60 Nm.
  const RobotModel robot = embedded_robot("ums7");
  const JointVector zero = JointVector::Zero(6);
  const JointVector level = degrees({0, 0, 0, 0, 90, 0});
  const TorqueShare found = torque_share(robot, level, zero, zero);
  CHECK(found.share == relative(2.35 / 30));
  CHECK(found.axis == 4);
  CHECK(found.speed == 1);
}

TEST_CASE("an axis that speeds up takes inertia, rotor and friction") {
  // Axis 6: u = 0.004·q''/0.9 + 80²·1.5e-5·q'' + 0.4·q' + 0.03 of 20 Nm; q'' = 100, q' = 2.
  const RobotModel robot = embedded_robot("ums7");
  const JointVector q = degrees({0, -45, 135, 0, 0, 0});
  const TorqueShare found =
      torque_share(robot, q, vector_of({0, 0, 0, 0, 0, 2}), vector_of({0, 0, 0, 0, 0, 100}));
  CHECK(found.axis == 5);
  CHECK(found.share == relative((0.4 / 0.9 + 9.6 + 0.8 + 0.03) / 20));
  // Twice that is beyond 0.9·20 Nm: (18 − 0.03) / (2·(0.4/0.9 + 9.6 + 0.8)).
  const TorqueShare twice =
      torque_share(robot, q, vector_of({0, 0, 0, 0, 0, 4}), vector_of({0, 0, 0, 0, 0, 200}));
  CHECK(twice.speed == relative((18 - 0.03) / (2 * (0.4 / 0.9 + 9.6 + 0.8))));
}

TEST_CASE("at the speed that is found the most is asked for, and no more") {
  const RobotModel robot = weak_arm(4);
  std::mt19937 random(7);
  int slowed = 0;
  for (int i = 0; i < 2000; ++i) {
    const JointVector q = random_vector(random, 3);
    const JointVector qd = random_vector(random, 4);
    const JointVector qdd = random_vector(random, 30);
    const TorqueShare found = torque_share(robot, q, qd, qdd);
    CHECK((found.share > TorqueShare::kMost) == (found.speed < 1));
    if (found.speed == 1) continue;
    ++slowed;
    const TorqueShare there = torque_share(robot, q, qd * found.speed, qdd * found.speed);
    CHECK(there.share == relative(TorqueShare::kMost, 1e-6));
    // Slower still is never too much before that.
    for (const double part : {0.25, 0.5, 0.75})
      CHECK(torque_share(robot, q, qd * found.speed * part, qdd * found.speed * part).share <
            TorqueShare::kMost);
  }
  CHECK(slowed > 500);
}

TEST_CASE("a weight that the gears do not bear leaves no speed") {
  RobotModel robot = embedded_robot("ums7");
  robot.mechanics->motors[4].torque_max = 2;
  const JointVector zero = JointVector::Zero(6);
  CHECK(torque_share(robot, degrees({0, 0, 0, 0, 90, 0}), zero, zero).speed == 0);
}

TEST_CASE("T1 raised by what is found keeps a segment from rest within its torques") {
  const RobotModel robot = weak_arm(16);
  const JointVector from = degrees({0, -45, 135, 0, 90, 0});
  const JointVector to = degrees({70, -20, 90, 60, 20, 100});
  const double t_acc = 0.2;
  const auto along = [&](double t1) {
    const PaulTransition segment(from, from, to, t1, t_acc);
    return torque_share_along(
        robot, &*robot.mechanics, [&](double t) { return segment.sample(t); }, -t_acc, t1 - t_acc);
  };
  double t1 = 0.8;
  const TorqueShare first = along(t1);
  CHECK(first.share > 1.2);
  CHECK(first.speed < 1);
  // Places in the corner move a little with T1: twice is enough.
  t1 /= first.speed;
  t1 /= along(t1).speed;
  const TorqueShare raised = along(t1);
  CHECK(raised.share < TorqueShare::kMost + 0.01);
  CHECK(raised.share > TorqueShare::kMost - 0.05);
}

TEST_CASE("without mechanics it is the drives alone that count") {
  // The gantry's x: 14 kg, 30 N·s/m, 0.3 N of 60 N in its file's own figures.
  const RobotModel robot = embedded_robot("gantry");
  const DriveData& x = robot.axes[0].drive;
  const TorqueShare found =
      torque_share(robot, JointVector::Zero(3), vector_of({-0.02, 0, 0}), vector_of({-0.1, 0, 0}));
  CHECK(found.axis == 0);
  CHECK(found.share ==
        relative((x.inertia * 0.1 + x.viscous_friction * 0.02 + x.coulomb_friction) / x.force_max));
}

TEST_CASE("looking for torques takes no memory") {
  const RobotModel robot = weak_arm(16);
  const JointVector q = degrees({0, -45, 135, 0, 90, 0});
  test::NoAllocation guard;
  CHECK(torque_share(robot, q, q, q).share > 0);
  CHECK(guard.count() == 0);
}

}  // namespace rob::motion
