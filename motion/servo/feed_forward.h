#pragma once

#include <array>
#include <optional>
#include <span>

#include "motion/dynamics/arm_mechanics.h"
#include "motion/servo/drive_data.h"
#include "motion/space/joint_vector.h"

namespace rob::motion {

/// The forces that a reference asks of the drives, before any error. N or Nm at the axes.
struct MotionForces {
  JointVector u0;       ///< the feed-forward
  JointVector inertia;  ///< that the drive of each axis moves there: Da·H_ii + Db
  double load = 0;      ///< max |P_i|/P_i,max before limiting; 0 where there is no such limit
};

/// S2's feed-forward, from the angles of the reference motion:
///
///     P  = H(q0)·q0'' + G(q0)       (published; no Coriolis terms, G2 = G3 = 0 for the bare arm)
///     u0 = Da·P + Db·q0'' + Dc·q0'
///
/// The torques P are checked against what the gears bear, limited to it, and turned into the
/// accelerations that are admissible with them: H·q'' = P − G; these count in u0.
///
/// The load that the arm carries counts in H and, with all of its weight at every axis, in G.
///
/// Without mechanics the axes are decoupled: u0 = inertia·q0'' + Dc·q0'. Coulomb friction is not in
/// it. at() may be used in the tick.
class FeedForward {
 public:
  /// At most kMaxJoints drives; six of them with an arm's mechanics.
  FeedForward(std::span<const DriveData> drives, const std::optional<ArmMechanics>& arm);

  MotionForces at(const JointReference& reference) const noexcept;

  /// From here on the arm carries that; without mechanics it makes no difference.
  void carry(const ArmLoad& load) noexcept;
  /// The part of u0 that is the weight of what is carried; 0 without mechanics.
  JointVector load_weight(const JointVector& q) const noexcept;

 private:
  MotionForces of_axes(const JointReference& reference) const noexcept;
  MotionForces of_arm(const JointReference& reference) const noexcept;

  std::array<DriveData, kMaxJoints> drives_;
  int count_;
  std::optional<ArmMechanics> arm_;       ///< as it is, with nothing to carry
  std::optional<ArmMechanics> carrying_;  ///< the same with what it carries
  std::optional<Ums7Dynamics> load_;      ///< that alone, if there is any
};

}  // namespace rob::motion
