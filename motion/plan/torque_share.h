#pragma once

#include "motion/robots/robot_model.h"
#include "motion/space/joint_vector.h"

namespace rob::motion {

/// The demand of a state of motion on a robot's gears and drives.
struct TorqueShare {
  /// The most that a plan may ask for; the rest is the servo's. [choice: S2 gives none]
  static constexpr double kMost = 0.9;

  /// Greatest of |P|/torque_max of a gear and |u|/force_max of a drive.
  double share = 0;
  int axis = 0;  ///< that it is of
  /// The greatest share of this speed, 0 … 1, at which no axis is asked for more than kMost: with
  /// velocities and accelerations taken down in proportion, as Paul's law does when T1 is raised
  /// and t_acc stays. 0: the weight alone is too much.
  double speed = 1;
};

/// With the complete mechanics of an arm, Coriolis torques and all weight:
///
///     P = H(q)·q'' + c(q, q') + ∂V/∂q        u = Da·P + Db·q'' + Dc·q' + C·sign(q')
///
/// without them (null) u = inertia·q'' + Dc·q' + C·sign(q'). The load that the arm carries counts
/// as far as it is in `mechanics` (ArmMechanics::carrying); the payload of [simulation] is not
/// known. May be used in the tick.
TorqueShare torque_share(const RobotModel& robot, const ArmMechanics* mechanics,
                         const JointVector& q, const JointVector& qd,
                         const JointVector& qdd) noexcept;
/// The share of an arm that carries nothing.
TorqueShare torque_share(const RobotModel& robot, const JointVector& q, const JointVector& qd,
                         const JointVector& qdd) noexcept;

/// The same of a joint segment: share and axis where the most is asked for, speed that of the place
/// where it is least. `curve(t)` has members q, qd, qdd (PaulTransition::sample), begin <= t <=
/// end; it is looked at in `places` instants. [choice] 65: of a corner of half a segment 32.
template <typename Curve>
TorqueShare torque_share_along(const RobotModel& robot, const ArmMechanics* mechanics,
                               const Curve& curve, double begin, double end,
                               int places = 65) noexcept {
  TorqueShare greatest;
  for (int k = 0; k < places; ++k) {
    const auto state = curve(begin + (end - begin) * k / (places - 1));
    const TorqueShare here = torque_share(robot, mechanics, state.q, state.qd, state.qdd);
    const double speed = here.speed < greatest.speed ? here.speed : greatest.speed;
    if (here.share > greatest.share) greatest = here;
    greatest.speed = speed;
  }
  return greatest;
}

}  // namespace rob::motion
