#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <cmath>
#include <functional>
#include <vector>

#include "motion/dynamics/ums7_dynamics.h"
#include "tests/motion/dynamics/random_arm.h"

// S2's table against arms made of point masses, whose torques follow from d'Alembert's principle:
// the torque of axis i is the sum of m·(∂p/∂q_i)·(p'' + gravity) over all points. Nothing here
// knows H, Christoffel's symbols or a potential.

using namespace rob::motion;
using Eigen::Vector3d;
using rob::test::axis;
using rob::test::random_six;

namespace {

constexpr double kUpper = 0.45;
constexpr double kFore = 0.35;
constexpr double kStep = 1e-4;  // rad, and s along a motion
constexpr double kClose = 1e-5;

struct PointMass {
  double mass;
  std::function<Vector3d(const JointVector&)> place;
};

/// Upper arm level at q2 = 0, turning downwards; `way` along it.
Vector3d on_upper_arm(const JointVector& q, double way) {
  const double r = way * std::cos(q[1]);
  return {r * std::cos(q[0]), r * std::sin(q[0]), -way * std::sin(q[1])};
}

struct ForearmFrame {
  Vector3d along, forward, across;
};

ForearmFrame forearm(const JointVector& q) {
  const double s = q[1] + q[2];
  const Vector3d out(std::cos(q[0]), std::sin(q[0]), 0);
  const Vector3d up(0, 0, 1);
  return {std::sin(s) * out + std::cos(s) * up, std::cos(s) * out - std::sin(s) * up,
          Vector3d(-std::sin(q[0]), std::cos(q[0]), 0)};
}

Vector3d on_forearm(const JointVector& q, double way) {
  return on_upper_arm(q, kUpper) + way * forearm(q).along;
}

/// A point of the hand: `way` along axis 6, `beside` it at q6.
Vector3d on_hand(const JointVector& q, double way, double beside) {
  const ForearmFrame f = forearm(q);
  const Vector3d lean = std::cos(q[3]) * f.forward + std::sin(q[3]) * f.across;
  const Vector3d side = f.along.cross(lean);
  const Vector3d axis6 = std::cos(q[4]) * f.along + std::sin(q[4]) * lean;
  const Vector3d ahead = axis6.cross(side);
  return on_forearm(q, kFore) + way * axis6 +
         beside * (std::cos(q[5]) * side + std::sin(q[5]) * ahead);
}

JointVector torques(const std::vector<PointMass>& points, const JointVector& q,
                    const JointVector& v, const JointVector& a, double gravity) {
  JointVector torque = JointVector::Zero(6);
  const JointVector before = q - kStep * v + 0.5 * kStep * kStep * a;
  const JointVector after = q + kStep * v + 0.5 * kStep * kStep * a;
  for (const auto& [mass, place] : points) {
    const Vector3d acceleration = (place(after) - 2 * place(q) + place(before)) / (kStep * kStep);
    const Vector3d force = mass * (acceleration + Vector3d(0, 0, gravity));
    for (int i = 0; i < 6; ++i) {
      const JointVector d = axis(i, kStep);
      torque[i] += force.dot(place(q + d) - place(q - d)) / (2 * kStep);
    }
  }
  return torque;
}

JointVector torques(const Ums7Dynamics& arm, const JointVector& q, const JointVector& v,
                    const JointVector& a) {
  return arm.inertia(q).times(a) + arm.coriolis(q, v) + arm.gravity(q);
}

/// Two points on each link, of the upper arm m·r² = 1·0.2² + 2·0.3², of the forearm 3·0.1² +
/// 1·0.3².
std::vector<PointMass> two_links() {
  std::vector<PointMass> points;
  points.push_back({1, [](const JointVector& q) { return on_upper_arm(q, 0.2); }});
  points.push_back({2, [](const JointVector& q) { return on_upper_arm(q, 0.3); }});
  points.push_back({3, [](const JointVector& q) { return on_forearm(q, 0.1); }});
  points.push_back({1, [](const JointVector& q) { return on_forearm(q, 0.3); }});
  return points;
}

Ums7Parameters table_of_two_links() {
  Ums7Parameters p;
  p.c1 = 0.04 + 0.18 + 4 * kUpper * kUpper;  // the forearm's 4 kg at the elbow
  p.c3 = 0.03 + 0.09;
  p.c5 = kUpper * (3 * 0.1 + 1 * 0.3);
  p.c2 = 2 * p.c5;
  p.c4 = p.c1 + p.c3;
  return p;
}

/// The hand with a mass across: a ring of four points, so that its inertia is the same in every
/// direction across the axis.
std::vector<PointMass> hand(double along, double beside) {
  std::vector<PointMass> points;
  for (int k = 0; k < 4; ++k) {
    points.push_back({0.5, [=](const JointVector& q) {
                        JointVector turned = q;
                        turned[5] += k * 1.5707963267948966;
                        return on_hand(turned, along, beside);
                      }});
  }
  return points;
}

JointVector wrist_only(JointVector v) {
  v.head(3).setZero();
  return v;
}

}  // namespace

TEST_CASE("two links of point masses: inertia and Coriolis torques of axes 1 to 3") {
  const Ums7Dynamics arm(table_of_two_links());
  std::mt19937 random(1);
  for (int k = 0; k < 100; ++k) {
    const JointVector q = random_six(random, 3);
    const JointVector v = random_six(random, 2);
    const JointVector a = random_six(random, 5);
    const JointVector expected = torques(two_links(), q, v, a, 0);
    CHECK((torques(arm, q, v, a) - expected).norm() < kClose);
  }
}

TEST_CASE("a hand on a resting arm: inertia, weight and Coriolis torques of axes 4 and 5") {
  Ums7Parameters p;
  p.c7 = 2 * 0.1 * 0.1;  // all on the axis: nothing turns about it
  p.c6 = 2 * 9.80665 * 0.1;
  const Ums7Dynamics arm(p);
  std::mt19937 random(2);
  for (int k = 0; k < 100; ++k) {
    const JointVector q = random_six(random, 3);
    const JointVector v = wrist_only(random_six(random, 2));
    const JointVector a = wrist_only(random_six(random, 5));
    const JointVector expected = torques(hand(0.1, 0), q, v, a, 9.80665);
    CHECK((torques(arm, q, v, a) - expected).tail(3).norm() < kClose);
  }
}

TEST_CASE("what the hand's weight does to axes 2 and 3, beside that of a point at the wrist") {
  Ums7Parameters p;
  p = with_payload(p, 2, kUpper, kFore, 0.1);
  const Ums7Dynamics arm(p);
  const JointVector zero = JointVector::Zero(6);
  std::mt19937 random(3);
  for (int k = 0; k < 100; ++k) {
    const JointVector q = random_six(random, 3);
    CHECK((arm.gravity(q) - torques(hand(0.1, 0), q, zero, zero, 9.80665)).norm() < kClose);
  }
}

TEST_CASE("a hand that is wide turns its axes as S2's table has it, but for H46") {
  Ums7Parameters p;
  p.c7 = 2 * (0.1 * 0.1 + 0.05 * 0.05 / 2);
  p.c8 = 2 * 0.05 * 0.05;
  const Ums7Dynamics arm(p);
  const JointVector zero = JointVector::Zero(6);
  std::mt19937 random(4);
  for (int k = 0; k < 20; ++k) {
    const JointVector q = random_six(random, 3);
    for (int j = 3; j < 6; ++j) {
      const JointVector column = torques(hand(0.1, 0.05), q, zero, axis(j, 1), 0);
      const JointVector published = arm.inertia(q).times(axis(j, 1));
      CHECK(std::abs(column[j] - published[j]) < kClose);
    }
    // Axis 6 turning turns axis 4 back, by its inertia as axis 4 sees it; S2 leaves that out.
    const double h46 = torques(hand(0.1, 0.05), q, zero, axis(5, 1), 0)[3];
    CHECK(std::abs(h46 - p.c8 * std::cos(q[4])) < kClose);
    CHECK(arm.inertia(q).times(axis(5, 1))[3] == 0);
  }
}
