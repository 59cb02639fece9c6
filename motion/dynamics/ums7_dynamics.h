#pragma once

#include <Eigen/Core>

#include "motion/dynamics/arm_load.h"
#include "motion/space/joint_vector.h"

namespace rob::motion {

/// S2's table of an arm: C0…C5, C7, C8 in kg·m², C6 in Nm. Angles are those of S2: at q2 = 0 the
/// upper arm is level, axis 2 turns it downwards; at q2 + q3 = 0 the forearm is upright; at q5 = 0
/// the hand prolongs it.
///
/// S2's arm is balanced but for its hand. A weight beyond that pulls at axes 2 and 3 by
/// `upper_pull` and `fore_pull`: mass times gravity times the length of upper arm and forearm, Nm.
/// A load beside axis 6 has the weight moments `side_x` and `side_y` along the flange's x and y,
/// Nm.
struct Ums7Parameters {
  double c0 = 0;  ///< the column
  double c1 = 0;  ///< the upper arm and what it carries at the elbow, about axis 2
  double c2 = 0;  ///< 2·c5
  double c3 = 0;  ///< the forearm, about axis 3
  double c4 = 0;  ///< both about axis 2, at right angles to each other
  double c5 = 0;  ///< what couples axes 2 and 3
  double c6 = 0;  ///< weight of the hand times the distance of its centre of mass from the wrist
  double c7 = 0;  ///< the hand across its axis, about the wrist
  double c8 = 0;  ///< the hand about its axis
  double upper_pull = 0;
  double fore_pull = 0;
  double side_x = 0;
  double side_y = 0;
};

/// The fault of the table; null if it can be an arm's. Beyond signs: c2 = 2·c5;
/// c3·(c4 − c3) > c5² and c1·c3 >= c5², without which some motion had no kinetic energy.
const char* fault_of(const Ums7Parameters& parameters);

/// The same arm with a load at its flange. All of its weight counts, at every axis. For its inertia
/// S2's table sets the form: axes 1 to 3 feel the mass at the wrist, and what lies beside axis 6 is
/// as though it were spread evenly around it.
Ums7Parameters with_load(const Ums7Parameters& parameters, const ArmLoad& load,
                         const ArmLengths& lengths) noexcept;
/// A mass (kg) as a point on axis 6, `hand` (m) from the wrist; upper arm and forearm in m.
Ums7Parameters with_payload(const Ums7Parameters& parameters, double mass, double upper_arm,
                            double forearm, double hand) noexcept;

/// The same arm with masses of another size: inertias and weights alike.
Ums7Parameters scaled(const Ums7Parameters& parameters, double masses);

/// S2's inertia matrix: symmetric, the entries that are not here are 0. kg·m².
struct ArmInertia {
  double h11 = 0, h22 = 0, h32 = 0, h33 = 0, h44 = 0, h55 = 0, h66 = 0;

  JointVector diagonal() const noexcept;
  void add_diagonal(const JointVector& inertias) noexcept;
  /// H·x
  JointVector times(const JointVector& x) const noexcept;
  /// x of H·x = rhs
  JointVector solve(const JointVector& rhs) const noexcept;
};

/// The mechanics of an arm that is described by S2's table, without motors and friction. q, q' have
/// six values in rad, rad/s; torques are Nm at the axes.
///
/// *As S2 publishes it*, for feed-forward: P = inertia(q)·q'' + published_gravity(q). G2 = G3 = 0
/// there, and there are no Coriolis terms.
///
/// *Complete*, for a simulation: P = inertia(q)·q'' + coriolis(q, q') + gravity(q), the Lagrange
/// equations of ½·q'ᵀ·H·q' − potential(q).
///
/// S2's own simplification stays in both: the hand is a point at the wrist for axes 1 to 3, and
/// turning axis 6 does not turn back axis 4 (H46).
///
/// All calls may be used in the tick.
class Ums7Dynamics {
 public:
  static constexpr int kAxes = 6;

  explicit Ums7Dynamics(const Ums7Parameters& parameters) : p_(parameters) {}

  ArmInertia inertia(const JointVector& q) const noexcept;
  JointVector published_gravity(const JointVector& q) const noexcept;

  /// The centrifugal and Coriolis torques: H'·q' − ½·∂(q'ᵀ·H·q')/∂q, as Christoffel's symbols of H
  /// give them.
  JointVector coriolis(const JointVector& q, const JointVector& qd) const noexcept;
  /// J; 0 where the hand is level with the wrist and, with a payload, the arm with axis 2.
  double potential(const JointVector& q) const noexcept;
  /// ∂potential/∂q
  JointVector gravity(const JointVector& q) const noexcept;
  double kinetic_energy(const JointVector& q, const JointVector& qd) const noexcept;

  const Ums7Parameters& parameters() const noexcept { return p_; }

 private:
  Ums7Parameters p_;
};

}  // namespace rob::motion
