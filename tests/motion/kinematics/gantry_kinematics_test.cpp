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

TEST_CASE("the axes that are found for a pose bring the tool there") {
  const GantryKinematics gantry;
  for (const double theta : {0.0, 0.7, -2.5, 3.0}) {
    const JointVector q = axes(0.14, 0.04, theta);
    const auto found = gantry.inverse(gantry.forward(q), q);
    REQUIRE(found.has_value());
    CHECK((*found - q).cwiseAbs().maxCoeff() < 1e-15);
  }
}

TEST_CASE("of all turns that point the same way the one nearest to the axis is taken") {
  const GantryKinematics gantry;
  const auto found = gantry.inverse(gantry.forward(axes(0, 0, -3.1)), axes(0, 0, 3.1));
  REQUIRE(found.has_value());
  CHECK((*found)[2] == doctest::Approx(2 * std::numbers::pi - 3.1));
}

TEST_CASE("a pose above the gantry's plane, or tilted, has no axes") {
  const GantryKinematics gantry;
  Pose pose;
  CHECK(gantry.inverse(pose, axes(0, 0, 0)).has_value());
  pose.position.z() = 0.001;
  CHECK_FALSE(gantry.inverse(pose, axes(0, 0, 0)).has_value());
  pose.position.z() = 0;
  pose.orientation = orientation_from({0.001, 0, 0});
  CHECK_FALSE(gantry.inverse(pose, axes(0, 0, 0)).has_value());
}

TEST_CASE("three linear axes place the tool in space, axis a turns it about x") {
  const GantryKinematics gantry(3, GantryKinematics::Turn::AboutX);
  JointVector q(4);
  q << 0.1, 0.2, 0.3, 0.5;
  const Pose pose = gantry.forward(q);
  CHECK(pose.position == Eigen::Vector3d(0.1, 0.2, 0.3));
  CHECK(fixed_angles(pose.orientation).a == doctest::Approx(0.5));
  const auto found = gantry.inverse(pose, q);
  REQUIRE(found.has_value());
  CHECK((*found - q).cwiseAbs().maxCoeff() < 1e-15);
  CHECK_FALSE(gantry.inverse({pose.position, orientation_from({0, 0.1, 0})}, q).has_value());
  // A tip 30 mm along x and 40 mm along y off the axis swings on a circle of 40 mm.
  CHECK(gantry.lever(3, {0.03, 0.04, 0}) == doctest::Approx(0.04));
  CHECK(gantry.lever(2, {0.03, 0.04, 0}) == 0);
  CHECK(gantry.coordinate(2) == 2);
  CHECK(gantry.coordinate(3) == 3);
}

TEST_CASE("three linear axes alone do not turn their tool") {
  const GantryKinematics gantry(3, GantryKinematics::Turn::None);
  CHECK(gantry.axes() == 3);
  CHECK(gantry.inverse({{1, 2, 3}, orientation_from({0, 0, 0})}, axes(0, 0, 0)).has_value());
  CHECK_FALSE(gantry.inverse({{1, 2, 3}, orientation_from({0, 0, 1e-3})}, axes(0, 0, 0)));
}

TEST_CASE("the gantry's kinematics takes no memory") {
  const GantryKinematics gantry;
  const JointVector q = axes(0.1, 0.2, 0.3);
  rob::test::NoAllocation guard;
  CHECK(gantry.forward(q).position.x() == 0.1);
  CHECK(gantry.inverse(gantry.forward(q), q).has_value());
  CHECK(gantry.axes() == 3);
  CHECK(guard.count() == 0);
}
