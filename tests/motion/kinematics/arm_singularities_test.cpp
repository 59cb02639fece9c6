#include <doctest/doctest.h>

#include "tests/motion/kinematics/arms.h"

using namespace rob::motion;
using namespace rob::test;

namespace {

/// An arm whose two halves are equally long, so that it folds wholly.
ArmKinematics folding_arm() { return *arm("ums7"); }

Pose moved(Pose pose, const Eigen::Vector3d& by) {
  pose.position += by;
  return pose;
}

}  // namespace

TEST_CASE("with axes 4 and 6 in line θ4 keeps its value and θ6 follows") {
  for (const std::string& name : arm_names()) {
    CAPTURE(name);
    const auto kinematics = arm(name);
    std::mt19937 random(11);
    double lost = 0;
    double worst = 0;
    for (int i = 0; i < 1000; ++i) {
      JointVector q = random_joints(random);
      q[4] = i % 2 == 0 ? 0.0 : std::numbers::pi;
      const SingularityDistances far = kinematics->singularities(q);
      if (far.shoulder < 0.1 || far.elbow < 0.2) continue;  // there another branch is as near
      const Pose pose = kinematics->forward(q);
      // θ4 as the program has it, θ6 as it may: the hand is turned by another 5 degrees.
      JointVector near = q;
      near[5] += 5 * kDegree;
      const auto found = kinematics->inverse(pose, near);
      REQUIRE(found.has_value());
      worst = std::max(worst, difference(kinematics->forward(*found), pose));
      lost = std::max(lost, (*found - q).cwiseAbs().maxCoeff());
    }
    CHECK(worst < 1e-9);
    CHECK(lost < 1e-9);
  }
}

TEST_CASE("passing through the wrist's singular place on a joint path turns no axis by itself") {
  const auto kinematics = arm("irb120");
  JointVector near = joints({10, 20, -30, 40, 10, 50});
  for (double wrist = 10; wrist >= -10; wrist -= 0.1) {
    const JointVector q = joints({10, 20, -30, 40, std::round(wrist * 10) / 10, 50});
    const auto found = kinematics->inverse(kinematics->forward(q), near);
    REQUIRE(found.has_value());
    CHECK((*found - q).cwiseAbs().maxCoeff() < 1e-9);
    near = *found;
  }
}

TEST_CASE("with the wrist on axis 1 θ1 keeps its value") {
  const auto kinematics = arm("irb120");
  for (const double base : {0.0, 30.0, -120.0}) {
    CAPTURE(base);
    // Ahead of axis 1: 270·sin(q2) + 302·cos(q2 + q3) + 70·sin(q2 + q3) = 0 for q2 = 30 deg where
    // 135 + 310·cos(q2 + q3 − 13.05 deg) = 0.
    const double angle = std::acos(-0.135 / std::hypot(0.302, 0.07)) + std::atan2(0.07, 0.302);
    JointVector q = joints({base, 30, 0, 20, 40, 60});
    q[2] = angle - 30 * kDegree;
    CHECK(kinematics->singularities(q).shoulder < 1e-12);
    const auto found = kinematics->inverse(kinematics->forward(q), q);
    REQUIRE(found.has_value());
    CHECK((*found - q).cwiseAbs().maxCoeff() < 1e-9);
    for (const JointVector& other : kinematics->solutions(kinematics->forward(q), q))
      CHECK(difference(kinematics->forward(other), kinematics->forward(q)) < 1e-9);
  }
}

TEST_CASE("the straight elbow is reached, and a nanometre beyond, but no more") {
  for (const std::string& name : arm_names()) {
    CAPTURE(name);
    const auto kinematics = arm(name);
    const ArmParameters& p = kinematics->parameters();
    // θ2 = 60°, elbow straight: θ3 = −ψ.
    const double theta2 = 60 * kDegree;
    const double theta3 = -std::atan2(p.a2, p.c3);
    JointVector q = joints({10, 0, 0, 20, 40, 30});
    q[1] = p.sign[1] * (theta2 - p.offset[1]);
    q[2] = p.sign[2] * (theta3 - p.offset[2]);
    CHECK(kinematics->singularities(q).elbow < 1e-12);
    const Pose pose = kinematics->forward(q);
    // Out of reach is along the line from axis 2 to the wrist.
    const double base = p.sign[0] * q[0] + p.offset[0];
    const Eigen::Vector3d out = Eigen::AngleAxisd(base, Eigen::Vector3d::UnitZ()) *
                                Eigen::Vector3d(std::sin(theta2), 0, std::cos(theta2));
    const auto found = kinematics->inverse(pose, q);
    REQUIRE(found.has_value());
    CHECK((*found - q).cwiseAbs().maxCoeff() < 1e-6);  // √ of rounding
    CHECK(difference(kinematics->forward(*found), pose) < 1e-9);
    const Pose beside = moved(pose, 0.5e-9 * out);
    REQUIRE(kinematics->inverse(beside, q).has_value());
    CHECK(difference(kinematics->forward(*kinematics->inverse(beside, q)), beside) < 1e-9);
    const Pose beyond = moved(pose, 0.012 * out);
    CHECK_FALSE(kinematics->inverse(beyond, q).has_value());
    const Shortfall shortfall = kinematics->shortfall(beyond);
    CHECK(shortfall.kind == Shortfall::Kind::TooFar);
    CHECK(shortfall.distance == doctest::Approx(0.012));
  }
}

TEST_CASE("a place nearer than the arm can fold is refused with how much is lacking") {
  // lwa4p: 350 and 305 mm fold to 45 mm from axis 2. Tool upright 30 mm above it: 15 mm lack.
  const auto kinematics = arm("lwa4p");
  const JointVector q = joints({0, 30, -90, 0, -60, 0});
  Pose pose;
  pose.position = {0, 0, 0.205 + 0.030 + 0.075};
  CHECK(kinematics->solutions(pose, q).count == 0);
  const Shortfall shortfall = kinematics->shortfall(pose);
  CHECK(shortfall.kind == Shortfall::Kind::TooNear);
  CHECK(shortfall.distance == doctest::Approx(0.015));
}

TEST_CASE("a place beside axis 1 that the shoulder's offset keeps away is refused") {
  // puma560: the wrist never comes nearer to axis 1 than 150.05 mm.
  const auto kinematics = arm("puma560");
  const JointVector q = joints({0, 45, -180, 0, 45, 0});
  Pose pose;
  pose.position = {0.1, 0.1, 0.3};
  CHECK(kinematics->solutions(pose, q).count == 0);
  const Shortfall shortfall = kinematics->shortfall(pose);
  CHECK(shortfall.kind == Shortfall::Kind::BesideAxis);
  CHECK(shortfall.distance == doctest::Approx(0.15005 - 0.1 * std::numbers::sqrt2));
  pose.position = {0.15005, 0, 0.3};  // just there: ahead and behind are one
  REQUIRE(kinematics->inverse(pose, q).has_value());
  CHECK(difference(kinematics->forward(*kinematics->inverse(pose, q)), pose) < 1e-9);
}

TEST_CASE("an arm folded onto axis 2 keeps θ2") {
  const ArmKinematics kinematics = folding_arm();
  const JointVector q = joints({10, -30, 270, 20, 40, 30});  // θ3 = 180°
  const Pose pose = kinematics.forward(q);
  const auto found = kinematics.inverse(pose, q);
  REQUIRE(found.has_value());
  CHECK((*found - q).cwiseAbs().maxCoeff() < 1e-6);
  CHECK(difference(kinematics.forward(*found), pose) < 1e-9);
}

TEST_CASE("the PUMA 560's distances are those of its table") {
  const auto kinematics = arm("puma560");
  std::mt19937 random(12);
  for (int i = 0; i < 1000; ++i) {
    const JointVector q = random_joints(random);
    const double c2 = std::cos(q[1]);
    const double s23 = std::sin(q[1] + q[2]);
    const double c23 = std::cos(q[1] + q[2]);
    const SingularityDistances far = kinematics->singularities(q);
    // x of the wrist in the plane of the arm.
    CHECK(far.shoulder ==
          doctest::Approx(std::abs(0.4318 * c2 + 0.0203 * c23 - 0.4318 * s23)).epsilon(1e-12));
    CHECK(std::sin(far.wrist) == doctest::Approx(std::abs(std::sin(q[4]))));
    // Straight and folded: forearm in line with the upper arm, by the triangle's sides.
    const double wrist_x = 0.4318 + 0.0203 * std::cos(q[2]) - 0.4318 * std::sin(q[2]);
    const double wrist_z = 0.0203 * std::sin(q[2]) + 0.4318 * std::cos(q[2]);
    const double area = std::abs(wrist_z) * 0.4318;  // twice: upper arm times height
    const double forearm = std::hypot(0.0203, 0.4318);
    CHECK(std::sin(far.elbow) == doctest::Approx(area / (0.4318 * forearm)).epsilon(1e-9));
    CHECK(std::hypot(wrist_x, wrist_z) <= 0.4318 + forearm + 1e-12);
  }
}

TEST_CASE("poses that are no poses have no solution") {
  const auto kinematics = arm("pc104");
  const JointVector q = joints({0, -90, 0, 0, 90, 0});
  Pose pose = kinematics->forward(q);
  pose.position.x() = std::nan("");
  CHECK_FALSE(kinematics->inverse(pose, q).has_value());
  pose = kinematics->forward(q);
  pose.orientation = Eigen::Quaterniond(0, 0, 0, 0);
  CHECK_FALSE(kinematics->inverse(pose, q).has_value());
  // A quaternion that is not of unit length is one all the same.
  pose = kinematics->forward(q);
  pose.orientation.coeffs() *= 3;
  REQUIRE(kinematics->inverse(pose, q).has_value());
  CHECK((*kinematics->inverse(pose, q) - q).cwiseAbs().maxCoeff() < 1e-12);
}
