#include "motion/plan/reach.h"

#include <doctest/doctest.h>

#include <numbers>

#include "motion/robots/robot_library.h"
#include "tests/support/degrees.h"

using rob::motion::JointVector;
using rob::test::kDegree;

namespace {

JointVector joints(double x, double y, double theta) {
  JointVector q(3);
  q << x, y, theta;
  return q;
}

}  // namespace

TEST_CASE("of two turns to a pose the nearer one is taken, unless it is beyond the limits") {
  const rob::motion::RobotModel gantry = rob::motion::embedded_robot("gantry");
  const auto pose = gantry.kinematics->forward(joints(0.1, 0.2, -170 * kDegree));
  // 190 degrees would be nearer to 170 degrees, and beyond the limit of 180 degrees.
  for (const double near : {-180.0, 0.0, 170.0}) {
    CAPTURE(near);
    const auto q = rob::motion::reach(gantry, pose, joints(0.1, 0.2, near * kDegree));
    REQUIRE(q);
    CHECK((*q)[2] == doctest::Approx(-170 * kDegree));
  }
}

TEST_CASE("a place beyond the limits is told as it is nearest") {
  const rob::motion::RobotModel gantry = rob::motion::embedded_robot("gantry");
  const auto pose = gantry.kinematics->forward(joints(9, 0.2, 1));
  const auto q = rob::motion::reach(gantry, pose, joints(0.1, 0.2, 0));
  REQUIRE(q);
  CHECK((*q)[0] == doctest::Approx(9));
  CHECK((*q)[2] == doctest::Approx(1));
}

TEST_CASE("of an arm's solutions the nearest within the limits is taken, whole turns included") {
  const rob::motion::RobotModel arm = rob::motion::embedded_robot("irb120");
  JointVector q(6);
  q << 10, 20, -30, 100, 60, 50;
  q *= kDegree;
  JointVector near = q;
  // The wrist turned over, which is nearest to (…, -80, -60, 230): as good, and within.
  near[3] -= 180 * kDegree;
  near[4] = -near[4];
  near[5] += 180 * kDegree;
  const auto pose = arm.kinematics->forward(q);
  const auto over = rob::motion::reach(arm, pose, near);
  REQUIRE(over);
  CHECK((*over - near).cwiseAbs().maxCoeff() < 1e-9);
  // Axis 4 ends at 160 degrees: at 170 the wrist has to turn over; axis 6 goes a turn back from
  // 410.
  q[3] = 170 * kDegree;
  q[5] = 410 * kDegree;
  const auto within = rob::motion::reach(arm, arm.kinematics->forward(q), q);
  REQUIRE(within);
  CHECK((*within)[3] == doctest::Approx(-10 * kDegree));
  CHECK((*within)[4] == doctest::Approx(-60 * kDegree));
  CHECK((*within)[5] == doctest::Approx(230 * kDegree));
}

TEST_CASE("where all of an arm's solutions are beyond a limit the nearest tells which") {
  const rob::motion::RobotModel arm = rob::motion::embedded_robot("irb120");
  JointVector q(6);
  q << 10, 20, 80, 40, 60, 50;  // axis 3 ends at 70 degrees
  q *= kDegree;
  const auto beyond = rob::motion::reach(arm, arm.kinematics->forward(q), q);
  REQUIRE(beyond);
  CHECK((*beyond)[2] == doctest::Approx(80 * kDegree));
}

TEST_CASE("a pose off the gantry's plane has no axis values") {
  const rob::motion::RobotModel gantry = rob::motion::embedded_robot("gantry");
  auto pose = gantry.kinematics->forward(joints(0.1, 0.2, 0));
  pose.position.z() = 0.06;
  CHECK_FALSE(rob::motion::reach(gantry, pose, joints(0.1, 0.2, 0)));
}
