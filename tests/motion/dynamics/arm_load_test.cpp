#include "motion/dynamics/arm_load.h"

#include <doctest/doctest.h>

#include <random>

#include "motion/robots/robot_library.h"
#include "tests/motion/dynamics/random_arm.h"

// What an arm carries, against the place of its centre of gravity as the arm's kinematics has it,
// which shares nothing with S2's table.

namespace rob::motion {
namespace {

using Eigen::Vector3d;
using test::random_six;

constexpr double kWeight = 9.80665;  // N of a kg

Vector3d carried_at(const RobotModel& robot, const JointVector& q, const Vector3d& cog) {
  return place_of(cog, robot.kinematics->forward(q));
}

}  // namespace

TEST_CASE("the weight of a load pulls at every axis as the height of its centre of gravity says") {
  const RobotModel robot = embedded_robot("ums7");
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(-0.2, 0.2);
  constexpr double kStep = 1e-5;
  for (int k = 0; k < 100; ++k) {
    const Vector3d cog(place(random), place(random), place(random));
    const double mass = 1 + 20 * std::abs(place(random));
    const Ums7Dynamics load = robot.mechanics->load_alone(ArmLoad::point(mass, cog));
    const JointVector q = random_six(random, 3);
    const JointVector gravity = load.gravity(q);
    for (int i = 0; i < 6; ++i) {
      JointVector more = q;
      JointVector less = q;
      more[i] += kStep;
      less[i] -= kStep;
      const double up = carried_at(robot, more, cog).z() - carried_at(robot, less, cog).z();
      CHECK(std::abs(gravity[i] - mass * kWeight * up / (2 * kStep)) < 1e-6);
      const double potential = load.potential(more) - load.potential(less);
      CHECK(std::abs(gravity[i] - potential / (2 * kStep)) < 1e-6);
    }
  }
}

TEST_CASE("a load on axis 6 has the inertia that its place gives it about each axis of the hand") {
  // q5 = 90°: axis 4 turns it with its whole lever, as axis 5 does; axis 6 feels nothing of it.
  const RobotModel robot = embedded_robot("ums7");
  const Ums7Dynamics load = robot.mechanics->load_alone(ArmLoad::point(2, {0, 0, 0.15}));
  JointVector q = robot.start;
  const ArmInertia inertia = load.inertia(q);
  const double lever = 0.1 + 0.15;
  CHECK(inertia.h44 == doctest::Approx(2 * lever * lever));
  CHECK(inertia.h55 == doctest::Approx(2 * lever * lever));
  CHECK(inertia.h66 == 0);
}

TEST_CASE("a load beside axis 6 has its inertia about it, and loads add up") {
  const RobotModel robot = embedded_robot("ums7");
  const ArmLoad tool = ArmLoad::point(0.8, {0, 0, 0.06});
  const ArmLoad part = ArmLoad::point(2, {0.03, -0.04, 0.15});
  CHECK(robot.mechanics->load_alone(part).inertia(robot.start).h66 ==
        doctest::Approx(2 * 0.05 * 0.05));
  const JointVector both = robot.mechanics->load_alone(tool + part).gravity(robot.start);
  const JointVector one = robot.mechanics->load_alone(tool).gravity(robot.start);
  const JointVector other = robot.mechanics->load_alone(part).gravity(robot.start);
  CHECK((both - one - other).norm() < 1e-12);
  // Whatever is carried, the table stays one of an arm.
  const Ums7Parameters loaded = robot.mechanics->carrying(tool + part).dynamics.parameters();
  CHECK(fault_of(loaded) == nullptr);
}

}  // namespace rob::motion
