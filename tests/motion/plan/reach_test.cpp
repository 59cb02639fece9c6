#include "motion/plan/reach.h"

#include <doctest/doctest.h>

#include <numbers>

#include "motion/robots/robot_library.h"

using rob::motion::JointVector;

namespace {

JointVector joints(double x, double y, double theta) {
  JointVector q(3);
  q << x, y, theta;
  return q;
}

}  // namespace

TEST_CASE("of two turns to a pose the nearer one is taken, unless it is beyond the limits") {
  const rob::motion::RobotModel gantry = rob::motion::embedded_robot("gantry");
  constexpr double kDegree = std::numbers::pi / 180;
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

TEST_CASE("a pose off the gantry's plane has no axis values") {
  const rob::motion::RobotModel gantry = rob::motion::embedded_robot("gantry");
  auto pose = gantry.kinematics->forward(joints(0.1, 0.2, 0));
  pose.position.z() = 0.06;
  CHECK_FALSE(rob::motion::reach(gantry, pose, joints(0.1, 0.2, 0)));
}
