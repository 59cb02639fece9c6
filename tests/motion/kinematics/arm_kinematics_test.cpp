#include "motion/kinematics/arm_kinematics.h"

#include <doctest/doctest.h>

#include <stdexcept>

#include "tests/motion/kinematics/arms.h"
#include "tests/motion/kinematics/round_trip.h"
#include "tests/support/no_allocation.h"

using namespace rob::motion;
using namespace rob::test;

namespace {

constexpr double kPi = std::numbers::pi;

ArmBranch branch_number(int i) { return {(i & 1) != 0, (i & 2) != 0, (i & 4) != 0}; }

}  // namespace

TEST_CASE("arms bring their tools where their published tables say") {
  for (const PublishedArm& published : published_arms()) {
    CAPTURE(published.name);
    const auto kinematics = arm(published.name);
    REQUIRE(kinematics);
    std::mt19937 random(1);
    double worst = 0;
    for (int i = 0; i < 1000; ++i) {
      const JointVector q = random_joints(random);
      worst = std::max(
          worst,
          (matrix_of(kinematics->forward(q)) - dh_forward(published, q)).cwiseAbs().maxCoeff());
    }
    CHECK(worst < 1e-14);
  }
}

TEST_CASE("the PUMA 560 stands in its nominal posture as Corke's book prints it") {
  // Corke: Robotics, Vision and Control: fkine(qn) and fkine(qz), to the digits printed.
  const auto puma = arm("puma560");
  const Eigen::Matrix4d nominal = matrix_of(puma->forward(joints({0, 45, 180, 0, 45, 0})));
  Eigen::Matrix4d printed;
  printed << 0, 0, 1, 0.5963, 0, 1, 0, -0.1501, -1, 0, 0, -0.01435, 0, 0, 0, 1;
  CHECK((nominal - printed).cwiseAbs().maxCoeff() <= 5e-5 + 1e-9);
  printed << 1, 0, 0, 0.4521, 0, 1, 0, -0.15005, 0, 0, 1, 0.4318, 0, 0, 0, 1;
  const Eigen::Matrix4d zero = matrix_of(puma->forward(joints({0, 0, 0, 0, 0, 0})));
  CHECK((zero - printed).cwiseAbs().maxCoeff() <= 1e-9);
}

TEST_CASE("each arm stands at its start as its file says") {
  // By hand from the lengths: shoulder, upper arm, forearm and hand added up.
  const auto at = [](const char* name, std::initializer_list<double> degrees) {
    return arm(name)->forward(joints(degrees)).position;
  };
  const double half = std::sqrt(0.5);
  CHECK((at("ums7", {0, -45, 135, 0, 90, 0}) -
         Eigen::Vector3d(0.4 * half + 0.4, 0, 0.5 + 0.4 * half - 0.1))
            .norm() < 1e-12);
  CHECK((at("pc104", {0, -90, 0, 0, 90, 0}) - Eigen::Vector3d(0.15 + 0.65, 0, 0.57 + 0.15)).norm() <
        1e-12);
  CHECK((at("pc104", {0, 0, 0, 0, 0, 0}) - Eigen::Vector3d(0.87, 0, -0.65)).norm() < 1e-12);
  CHECK((at("lwa4p", {0, 0, 0, 0, 0, 0}) - Eigen::Vector3d(0, 0, 0.935)).norm() < 1e-12);
  CHECK((at("lwa4p", {0, 30, -90, 0, -60, 0}) - Eigen::Vector3d(0.439, 0, 0.281)).norm() < 1e-3);
  CHECK((at("irb120", {0, 0, 0, 0, 0, 0}) - Eigen::Vector3d(0.374, 0, 0.63)).norm() < 1e-12);
}

TEST_CASE("every solution brings the tool back to its pose, and the joints it came from are one") {
  // tests/bench/pose_round_trip does it with a million poses an arm.
  for (const std::string& name : arm_names()) {
    CAPTURE(name);
    const RoundTrip trip = round_trip(*arm(name), 16'000, 2);
    CHECK(trip.position < 1e-9);
    CHECK(trip.rotation < 1e-9);
    CHECK(trip.regular_error < 1e-13);
    CHECK(trip.none == 0);
    CHECK(trip.lost == 0);
    CHECK(trip.regular > 9'500);
    CHECK(trip.solutions > 6 * trip.poses);
  }
}

TEST_CASE("a pose has eight solutions of eight branches, or four where a1 keeps one side away") {
  for (const std::string& name : arm_names()) {
    CAPTURE(name);
    const auto kinematics = arm(name);
    std::mt19937 random(3);
    int eights = 0;
    for (int i = 0; i < 1000; ++i) {
      const JointVector q = random_joints(random);
      if (!is_regular(kinematics->singularities(q))) continue;
      const InverseSolutions found = kinematics->solutions(kinematics->forward(q), q);
      const bool counted =
          found.count == 8 || (found.count == 4 && kinematics->parameters().a1 != 0);
      REQUIRE(counted);
      if (found.count == 8) ++eights;
      for (int number = 0; number < 8; ++number) {
        const auto of_branch = std::count_if(found.begin(), found.end(), [&](const JointVector& s) {
          return kinematics->branch(s) == branch_number(number);
        });
        CHECK(of_branch <= 1);
        if (found.count == 8) CHECK(of_branch == 1);
      }
    }
    CHECK(eights > 800);
  }
}

TEST_CASE("of all solutions the nearest is taken, and axes do not wind by themselves") {
  const auto kinematics = arm("irb120");
  const JointVector q = joints({20, 30, -20, 50, 60, 300});
  const auto found = kinematics->inverse(kinematics->forward(q), q);
  REQUIRE(found.has_value());
  CHECK((*found - q).cwiseAbs().maxCoeff() < 1e-12);
  const JointVector flipped = joints({20, 30, -20, 230, -60, 480});
  const auto other = kinematics->inverse(kinematics->forward(q), flipped);
  REQUIRE(other.has_value());
  CHECK((*other - flipped).cwiseAbs().maxCoeff() < 1e-12);
}

TEST_CASE("the nearest is the one that a look at all of them finds") {
  for (const std::string& name : arm_names()) {
    CAPTURE(name);
    const auto kinematics = arm(name);
    const Kinematics& any = *kinematics;
    std::mt19937 random(3);
    std::uniform_real_distribution<double> much(-1, 1);
    for (int i = 0; i < 3000; ++i) {
      JointVector q = random_joints(random);
      if (i % 4 == 0) q[4] = 1e-7 * much(random);
      JointVector near = q;
      for (double& axis : near) axis += std::pow(10.0, i % 5 - 4) * much(random);
      const Pose pose = any.forward(q);
      const auto found = any.inverse(pose, near);
      const auto looked_for = any.Kinematics::inverse(pose, near);
      REQUIRE(found.has_value());
      REQUIRE(looked_for.has_value());
      // In singular places two may be as near as each other.
      const double apart = (*looked_for - near).norm();
      REQUIRE(std::abs((*found - near).norm() - apart) <= 1e-12);
    }
  }
}

TEST_CASE("each branch is left by turning the wrist, the elbow or the base over") {
  const auto kinematics = arm("lwa4p");
  const JointVector q = joints({10, 30, -90, 20, -60, 5});
  CHECK(kinematics->branch(q) == ArmBranch{false, false, false});
  CHECK(kinematics->branch(joints({10, 30, -90, 200, 60, 185})) == ArmBranch{false, false, true});
  CHECK(kinematics->branch(joints({10, 100, 90, 20, -60, 5})) == ArmBranch{false, true, false});
  CHECK(kinematics->branch(joints({190, -30, 90, 20, -60, 5})) == ArmBranch{true, true, false});
}

TEST_CASE("the Jacobian is what forward kinematics changes by") {
  for (const std::string& name : arm_names()) {
    CAPTURE(name);
    const auto kinematics = arm(name);
    std::mt19937 random(4);
    double worst = 0;
    for (int i = 0; i < 200; ++i) {
      const JointVector q = random_joints(random);
      const Eigen::Matrix<double, 6, 6> jacobian = kinematics->jacobian(q);
      for (int axis = 0; axis < 6; ++axis) {
        constexpr double kStep = 1e-5;
        JointVector before = q;
        JointVector after = q;
        before[axis] -= kStep;
        after[axis] += kStep;
        const Pose from = kinematics->forward(before);
        const Pose to = kinematics->forward(after);
        const Eigen::AngleAxisd turn(to.orientation * from.orientation.conjugate());
        Eigen::Matrix<double, 6, 1> change;
        change << to.position - from.position, turn.angle() * turn.axis();
        worst = std::max(worst, (jacobian.col(axis) - change / (2 * kStep)).cwiseAbs().maxCoeff());
      }
    }
    CHECK(worst < 1e-8);
  }
}

TEST_CASE("the Jacobian's determinant is the product of the three distances") {
  // |det J| = c2 · k · |sin(elbow)| · |wrist ahead of axis 1| · |sin θ5|: the geometry of the arm.
  for (const std::string& name : arm_names()) {
    CAPTURE(name);
    const auto kinematics = arm(name);
    const ArmParameters& p = kinematics->parameters();
    std::mt19937 random(5);
    for (int i = 0; i < 200; ++i) {
      const JointVector q = random_joints(random);
      const SingularityDistances far = kinematics->singularities(q);
      const double product =
          p.c2 * std::hypot(p.a2, p.c3) * std::sin(far.elbow) * far.shoulder * std::sin(far.wrist);
      CHECK(std::abs(kinematics->jacobian(q).determinant()) ==
            doctest::Approx(product).epsilon(1e-9).scale(1e-6));
    }
  }
}

TEST_CASE("a tip is never farther from an axis than the lever says, and nearly as far somewhere") {
  const Eigen::Vector3d tip(0.02, -0.03, 0.1);
  for (const std::string& name : arm_names()) {
    CAPTURE(name);
    const auto kinematics = arm(name);
    std::mt19937 random(6);
    for (int axis = 0; axis < 6; ++axis) {
      CAPTURE(axis);
      double farthest = 0;
      for (int i = 0; i < 20'000; ++i) {
        JointVector q = random_joints(random);
        const Pose from = kinematics->forward(q);
        q[axis] += kPi;
        const Pose to = kinematics->forward(q);
        const Eigen::Vector3d way =
            to.position + to.orientation * tip - from.position - from.orientation * tip;
        farthest = std::max(farthest, way.norm() / 2);
      }
      const double lever = kinematics->lever(axis, tip);
      CHECK(farthest <= lever + 1e-12);
      CHECK(farthest > 0.9 * lever);
    }
  }
}

TEST_CASE("measures that are no arm's are refused") {
  ArmParameters good = arm("pc104")->parameters();
  CHECK_NOTHROW(ArmKinematics{good});
  const auto refuses = [&](auto&& spoil) {
    ArmParameters p = good;
    spoil(p);
    CHECK_THROWS_AS(ArmKinematics{p}, std::invalid_argument);
  };
  refuses([](ArmParameters& p) { p.c2 = 0; });
  refuses([](ArmParameters& p) { p.c2 = -0.3; });
  refuses([](ArmParameters& p) { p.c3 = -0.3; });
  refuses([](ArmParameters& p) { p.c3 = p.a2 = 0; });
  refuses([](ArmParameters& p) { p.b = std::nan(""); });
  refuses([](ArmParameters& p) { p.offset[3] = INFINITY; });
  refuses([](ArmParameters& p) { p.sign[3] = 0; });
}

TEST_CASE("the arms' kinematics takes no memory") {
  const auto kinematics = arm("puma560");
  const JointVector q = joints({10, 20, 30, 40, 50, 60});
  NoAllocation guard;
  const Pose pose = kinematics->forward(q);
  CHECK(kinematics->solutions(pose, q).count == 8);
  CHECK(kinematics->inverse(pose, q).has_value());
  CHECK(kinematics->jacobian(q).allFinite());
  CHECK(kinematics->singularities(q).wrist > 0);
  CHECK(kinematics->branch(q).behind == false);
  CHECK(kinematics->shortfall(pose).distance == 0);
  CHECK(guard.count() == 0);
}
