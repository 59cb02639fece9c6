#include "motion/dynamics/ums7_dynamics.h"

#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <cmath>
#include <numbers>
#include <string>

#include "tests/motion/dynamics/random_arm.h"
#include "tests/support/no_allocation.h"
#include "tests/support/relative.h"

using namespace rob::motion;
using rob::test::axis;
using rob::test::plain_arm;
using rob::test::random_six;

namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6>;

constexpr double kDifference = 1e-5;  // rad: differences are exact to kStep² and 1e-16/kDifference
constexpr double kExact = 1e-8;

Matrix6 matrix_of(const ArmInertia& h) {
  Matrix6 m;
  for (int i = 0; i < 6; ++i) m.col(i) = h.times(axis(i, 1));
  return m;
}

/// By how much the inertia changes along qd.
Matrix6 rate_of_inertia(const Ums7Dynamics& arm, const JointVector& q, const JointVector& qd) {
  return (matrix_of(arm.inertia(q + kDifference * qd)) -
          matrix_of(arm.inertia(q - kDifference * qd))) /
         (2 * kDifference);
}

/// Christoffel's matrix C(q, q') with C·q' = coriolis: the one bilinear and symmetric form that has
/// coriolis() as its quadratic one.
Matrix6 christoffel(const Ums7Dynamics& arm, const JointVector& q, const JointVector& qd) {
  Matrix6 c;
  for (int j = 0; j < 6; ++j) {
    const JointVector e = axis(j, 1);
    c.col(j) = 0.5 * (arm.coriolis(q, qd + e) - arm.coriolis(q, qd) - arm.coriolis(q, e));
  }
  return c;
}

}  // namespace

TEST_CASE("S2's formulas at places where all is 0, 1 or -1") {
  Ums7Parameters p;
  p.c0 = 1;
  p.c1 = 20;
  p.c2 = 300;
  p.c3 = 4000;
  p.c4 = 50000;
  p.c5 = 150;
  p.c6 = 7;
  p.c7 = 8;
  p.c8 = 9;
  const Ums7Dynamics arm(p);
  const double right = std::numbers::pi / 2;
  JointVector q = JointVector::Zero(6);

  // Upper arm level, forearm upright, hand along it.
  ArmInertia h = arm.inertia(q);
  CHECK(h.h11 == 21);
  CHECK(h.h22 == 50000);
  CHECK(h.h32 == 4000);
  CHECK(h.h33 == 4000);
  CHECK(h.h44 == 9);
  CHECK(h.h55 == 8);
  CHECK(h.h66 == 9);
  CHECK(arm.potential(q) == 7);  // the hand stands above the wrist
  CHECK(arm.gravity(q).norm() == 0);

  q[2] = right;  // stretched out, level
  h = arm.inertia(q);
  CHECK(h.h11 == rob::test::relative(1 + 20 + 300 + 4000));
  CHECK(h.h22 == rob::test::relative(50300));
  CHECK(h.h32 == rob::test::relative(4150));
  CHECK(arm.published_gravity(q)[4] == rob::test::relative(-7));

  q[4] = right;  // the hand hangs down; turned by 90 degrees it is level
  CHECK(arm.inertia(q).h44 == rob::test::relative(8));
  CHECK(arm.potential(q) == rob::test::relative(-7));
  q[3] = right;
  CHECK(arm.published_gravity(q)[3] == rob::test::relative(7));
}

TEST_CASE("gravity is the gradient of the potential, in all of its six parts") {
  const Ums7Dynamics arm(plain_arm());
  std::mt19937 random(1);
  for (int k = 0; k < 200; ++k) {
    const JointVector q = random_six(random, 3);
    const JointVector g = arm.gravity(q);
    for (int i = 0; i < 6; ++i) {
      const JointVector d = axis(i, kDifference);
      const double slope = (arm.potential(q + d) - arm.potential(q - d)) / (2 * kDifference);
      CHECK(std::abs(g[i] - slope) < kExact);
    }
  }
}

TEST_CASE("S2's feed-forward knows the weight of the hand at the wrist, and no other") {
  Ums7Parameters p = plain_arm();
  p.upper_pull = p.fore_pull = 0;
  const Ums7Dynamics arm(p);
  std::mt19937 random(2);
  for (int k = 0; k < 20; ++k) {
    const JointVector q = random_six(random, 3);
    const JointVector published = arm.published_gravity(q);
    const JointVector whole = arm.gravity(q);
    CHECK(published.head(3).norm() == 0);
    CHECK(published.tail(3) == whole.tail(3));
    CHECK(whole[1] == whole[2]);  // both raise the hand by turning the same angle, q2 + q3
  }
}

TEST_CASE("the inertia is symmetric, positive definite, and undone by solve()") {
  std::mt19937 random(3);
  for (int k = 0; k < 200; ++k) {
    const Ums7Dynamics arm(scaled(plain_arm(), 0.5 + 0.01 * k));
    ArmInertia h = arm.inertia(random_six(random, 3));
    if (k % 2 == 1) h.add_diagonal(JointVector::Constant(6, 2));
    const Matrix6 m = matrix_of(h);
    CHECK((m - m.transpose()).norm() == 0);
    CHECK(Eigen::SelfAdjointEigenSolver<Matrix6>(m).eigenvalues().minCoeff() > 0);
    CHECK((m.diagonal() - h.diagonal()).norm() == 0);
    const JointVector x = random_six(random, 10);
    CHECK((h.solve(m * x) - x).norm() < 1e-10);
  }
}

TEST_CASE("Coriolis torques are Lagrange's: H'q' less half the gradient of q'Hq'") {
  const Ums7Dynamics arm(plain_arm());
  std::mt19937 random(4);
  for (int k = 0; k < 200; ++k) {
    const JointVector q = random_six(random, 3);
    const JointVector v = random_six(random, 2);
    JointVector expected = rate_of_inertia(arm, q, v) * v;
    for (int i = 0; i < 6; ++i) {
      const JointVector d = axis(i, kDifference);
      expected[i] -=
          (arm.kinetic_energy(q + d, v) - arm.kinetic_energy(q - d, v)) / (2 * kDifference);
    }
    CHECK((arm.coriolis(q, v) - expected).norm() < 100 * kExact);  // H·v² is up to 40
  }
}

TEST_CASE("dM/dt - 2C is skew-symmetric") {
  const Ums7Dynamics arm(plain_arm());
  std::mt19937 random(5);
  for (int k = 0; k < 50; ++k) {
    const JointVector q = random_six(random, 3);
    const JointVector v = random_six(random, 2);
    const Matrix6 c = christoffel(arm, q, v);
    CHECK((c * v - arm.coriolis(q, v)).norm() < 1e-12);
    const Matrix6 n = rate_of_inertia(arm, q, v) - 2 * c;
    CHECK((n + n.transpose()).norm() < 100 * kExact);
  }
}

TEST_CASE("a table that is no arm's is told apart") {
  CHECK(fault_of(plain_arm()) == nullptr);
  const auto with = [](double Ums7Parameters::*c, double value) {
    Ums7Parameters p = plain_arm();
    p.*c = value;
    return std::string(fault_of(p) ? fault_of(p) : "");
  };
  CHECK(with(&Ums7Parameters::c8, 0) == "c0, c7 and c8 must be above 0");
  CHECK(with(&Ums7Parameters::c2, 2) == "c2 must be 2*c5");
  CHECK(with(&Ums7Parameters::c4, 1) == "c3*(c4 - c3) must be more than c5^2");
  CHECK(with(&Ums7Parameters::c1, 0.1) == "c1*c3 must not be less than c5^2");
}

TEST_CASE("the dynamics take no memory") {
  const Ums7Dynamics arm(plain_arm());
  const JointVector q = JointVector::Constant(6, 0.3);
  rob::test::NoAllocation guard;
  const JointVector torque = arm.inertia(q).times(q) + arm.coriolis(q, q) + arm.gravity(q) +
                             arm.published_gravity(q) + arm.inertia(q).solve(q);
  const double sum = torque.sum() + arm.kinetic_energy(q, q) + arm.potential(q);
  CHECK(guard.count() == 0);
  CHECK(std::isfinite(sum));
}
