#include "motion/kinematics/gantry_kinematics.h"

#include <doctest/doctest.h>

#include <numbers>

#include "tests/support/no_allocation.h"

using namespace rob::motion;

namespace {

JointVector axes(double x, double y, double theta) {
  JointVector q(3);
  q << x, y, theta;
  return q;
}

}  // namespace

TEST_CASE("the gantry's axes x and y are the tool's place, theta turns it about z") {
  const GantryKinematics gantry;
  for (const double theta : {0.0, 0.7, -2.5, std::numbers::pi}) {
    const Pose pose = gantry.forward(axes(0.14, 0.04, theta));
    CHECK(pose.position == Eigen::Vector3d(0.14, 0.04, 0));
    const FixedAngles angles = fixed_angles(pose.orientation);
    CHECK(angles.a == doctest::Approx(0));
    CHECK(angles.b == doctest::Approx(0));
    CHECK(angles.c == doctest::Approx(theta));
  }
}

TEST_CASE("with theta at 90° the tool's x axis points along the world's y") {
  const Pose pose = GantryKinematics().forward(axes(0, 0, std::numbers::pi / 2));
  CHECK((pose.orientation * Eigen::Vector3d(1, 0, 0)).isApprox(Eigen::Vector3d(0, 1, 0)));
}

TEST_CASE("the gantry's kinematics takes no memory") {
  const GantryKinematics gantry;
  const JointVector q = axes(0.1, 0.2, 0.3);
  rob::test::NoAllocation guard;
  CHECK(gantry.forward(q).position.x() == 0.1);
  CHECK(gantry.axes() == 3);
  CHECK(guard.count() == 0);
}
