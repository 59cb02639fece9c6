#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <array>
#include <random>

#include "motion/dynamics/ums7_dynamics.h"

// S2's table against the recursive Newton-Euler equations (Luh, Walker, Paul 1980), written for any
// chain of turning joints and applied to the two parts of the arm that the table describes exactly:
// an arm of two rods on a column, and a hand on an arm at rest.

namespace rob::motion {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kGravity = 9.81;

struct RigidLink {
  Vector3d axis;     ///< of the joint that it hangs on, in its own frame
  Vector3d next;     ///< from that joint to the next one, in its own frame
  double mass;       ///< kg
  Vector3d centre;   ///< of mass, from the joint
  Matrix3d inertia;  ///< about the centre of mass
};

using Chain = std::array<RigidLink, 6>;

/// Torques at the joints for q, q', q'', gravity being an acceleration of the base upwards.
JointVector newton_euler(const Chain& chain, const JointVector& q, const JointVector& qd,
                         const JointVector& qdd, double gravity) {
  std::array<Vector3d, 6> z, joint, centre, force, moment;
  Matrix3d turn = Matrix3d::Identity();
  Vector3d at = Vector3d::Zero();
  Vector3d w = Vector3d::Zero();
  Vector3d dw = Vector3d::Zero();
  Vector3d a(0, 0, gravity);
  for (std::size_t i = 0; i < 6; ++i) {  // outwards
    const auto k = static_cast<Eigen::Index>(i);
    const RigidLink& body = chain[i];
    z[i] = turn * body.axis;
    turn = turn * Eigen::AngleAxisd(q[k], body.axis).toRotationMatrix();
    dw += z[i] * qdd[k] + w.cross(z[i] * qd[k]);
    w += z[i] * qd[k];
    joint[i] = at;
    const Vector3d c = turn * body.centre;
    centre[i] = at + c;
    force[i] = body.mass * (a + dw.cross(c) + w.cross(w.cross(c)));
    const Matrix3d inertia = turn * body.inertia * turn.transpose();
    moment[i] = inertia * dw + w.cross(inertia * w);
    const Vector3d way = turn * body.next;
    a += dw.cross(way) + w.cross(w.cross(way));
    at += way;
  }
  JointVector torque(6);
  Vector3d f = Vector3d::Zero();  // what the next body asks of this one, at its joint
  Vector3d n = Vector3d::Zero();
  Vector3d from = at;
  for (std::size_t i = 6; i-- > 0;) {  // inwards
    n += moment[i] + (centre[i] - joint[i]).cross(force[i]) + (from - joint[i]).cross(f);
    f += force[i];
    from = joint[i];
    torque[static_cast<Eigen::Index>(i)] = n.dot(z[i]);
  }
  return torque;
}

Matrix3d inertia_of(double x, double y, double z) { return Vector3d(x, y, z).asDiagonal(); }

constexpr double kUpperLength = 0.45, kForeLength = 0.35;
constexpr double kUpperMass = 11, kUpperCentre = 0.2, kUpperInertia = 0.17;
constexpr double kForeMass = 7, kForeCentre = 0.15, kForeInertia = 0.08;
constexpr double kHandMass = 3, kHandCentre = 0.09, kHandAcross = 0.006, kHandAlong = 0.004;

/// At zero the upper arm is level, along x, and the forearm upright; the hand prolongs it.
Chain arm(double arm_masses, double hand_masses) {
  const Vector3d y = Vector3d::UnitY();
  const Vector3d z = Vector3d::UnitZ();
  const double m = arm_masses;
  const double h = hand_masses;
  const Vector3d zero = Vector3d::Zero();
  const Matrix3d none = Matrix3d::Zero();
  return {RigidLink{z, zero, 0, zero, m * inertia_of(0, 0, 0.7)},
          RigidLink{y,
                    {kUpperLength, 0, 0},
                    m * kUpperMass,
                    {kUpperCentre, 0, 0},
                    m * inertia_of(0, kUpperInertia, kUpperInertia)},
          RigidLink{y,
                    {0, 0, kForeLength},
                    m * kForeMass,
                    {0, 0, kForeCentre},
                    m * inertia_of(kForeInertia, kForeInertia, 0)},
          RigidLink{z, zero, 0, zero, none},
          RigidLink{y, zero, 0, zero, none},
          RigidLink{z,
                    zero,
                    h * kHandMass,
                    {0, 0, kHandCentre},
                    h * inertia_of(kHandAcross, kHandAcross, kHandAlong)}};
}

/// The table of both parts, by their definitions.
Ums7Dynamics table() {
  Ums7Parameters p;
  p.c0 = 0.7;
  p.c1 = kUpperInertia + kUpperMass * kUpperCentre * kUpperCentre +
         kForeMass * kUpperLength * kUpperLength;
  p.c3 = kForeInertia + kForeMass * kForeCentre * kForeCentre;
  p.c4 = p.c1 + p.c3;
  p.c5 = kForeMass * kForeCentre * kUpperLength;
  p.c2 = 2 * p.c5;
  p.c6 = kHandMass * kGravity * kHandCentre;
  p.c7 = kHandAcross + kHandMass * kHandCentre * kHandCentre;
  p.c8 = kHandAlong;
  REQUIRE(fault_of(p) == nullptr);
  return Ums7Dynamics(p);
}

/// Random values of the axes first … last, 0 of the others.
JointVector random_values(std::mt19937& random, int first, int last) {
  std::uniform_real_distribution<double> value(-3, 3);
  JointVector v = JointVector::Zero(6);
  for (int i = first; i <= last; ++i) v[i] = value(random);
  return v;
}

}  // namespace

TEST_CASE("two rods on a column: torques of axes 1 to 3 are those of Newton and Euler") {
  const Chain chain = arm(1, 0);
  const Ums7Dynamics dynamics = table();
  std::mt19937 random(31);
  double worst = 0;
  for (int i = 0; i < 1000; ++i) {
    const JointVector q = random_values(random, 0, 5);
    const JointVector qd = random_values(random, 0, 2);
    const JointVector qdd = random_values(random, 0, 2);
    const JointVector expected = newton_euler(chain, q, qd, qdd, 0);
    const JointVector torque = dynamics.inertia(q).times(qdd) + dynamics.coriolis(q, qd);
    worst = std::max(worst, (torque - expected).head(3).cwiseAbs().maxCoeff());
  }
  CHECK(worst < 1e-12);  // of up to 30 Nm
}

TEST_CASE("a hand on a resting arm: torques of axes 4 to 6 are those of Newton and Euler") {
  const Chain chain = arm(0, 1);
  const Ums7Dynamics dynamics = table();
  std::mt19937 random(32);
  double worst = 0;
  double published = 0;
  for (int i = 0; i < 1000; ++i) {
    const JointVector q = random_values(random, 0, 5);
    // Axes 4 and 5 together, or axis 6 alone: S2's table does not couple 4 and 6.
    const bool last = i % 4 == 0;
    const JointVector qd = last ? random_values(random, 5, 5) : random_values(random, 3, 4);
    const JointVector qdd = last ? random_values(random, 5, 5) : random_values(random, 3, 4);
    const JointVector expected = newton_euler(chain, q, qd, qdd, kGravity);
    const JointVector moved = dynamics.inertia(q).times(qdd) + dynamics.coriolis(q, qd);
    const JointVector error = moved + dynamics.gravity(q) - expected;
    const JointVector of_s2 = moved + dynamics.published_gravity(q) - expected;
    const auto part = [&](const JointVector& v) {
      return last ? std::abs(v[5]) : v.segment(3, 2).cwiseAbs().maxCoeff();
    };
    worst = std::max(worst, part(error));
    published = std::max(published, part(of_s2));
  }
  CHECK(worst < 1e-12);
  CHECK(published < 1e-12);
}

TEST_CASE("what S2's table leaves out is the turn that axis 6 shares with axis 4") {
  const Chain chain = arm(0, 1);
  const Ums7Dynamics dynamics = table();
  std::mt19937 random(33);
  const JointVector still = JointVector::Zero(6);
  for (int i = 0; i < 100; ++i) {
    const JointVector q = random_values(random, 0, 5);
    const JointVector qdd = random_values(random, 3, 5);
    const JointVector missing =
        newton_euler(chain, q, still, qdd, 0) - dynamics.inertia(q).times(qdd);
    const double h46 = kHandAlong * std::cos(q[4]);
    CHECK(missing[3] == doctest::Approx(h46 * qdd[5]).epsilon(1e-9).scale(1e-6));
    CHECK(std::abs(missing[4]) < 1e-12);
    CHECK(missing[5] == doctest::Approx(h46 * qdd[3]).epsilon(1e-9).scale(1e-6));
  }
}

}  // namespace rob::motion
