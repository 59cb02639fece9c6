#pragma once

#include "motion/space/joint_vector.h"
#include "motion/space/path_point.h"

namespace rob::motion {

/// One segment of S1's on-line law (after R. P. Paul, 1981): the transition around B, in which the
/// motion that comes from A turns towards C, and the straight part after it.
///
///     A                      t = −t_acc: the segment before is left
///      ·
///       ·                    B itself is passed at a distance
///        · .
///     B    ˙ · ─────── C     t = t_acc: straight from here; t = T1: C would be reached
///
/// t is 0 when B would be reached. With t_acc the half transition around B; the one around C may
/// have another, and the segment ends that much before T1. Position, velocity and acceleration
/// are continuous. m, rad, s. May be used in the tick.
class PaulTransition {
 public:
  PaulTransition() = default;
  /// Needs t_acc > 0 and T1 >= t_acc.
  PaulTransition(const JointVector& a, const JointVector& b, const JointVector& c, double t1,
                 double t_acc) noexcept;

  /// −t_acc <= t <= T1.
  PathPoint sample(double t) const noexcept;

 private:
  PathPoint corner(double h) const noexcept;

  JointVector b_;
  JointVector delta_b_;   ///< ΔB = A − B
  JointVector velocity_;  ///< ΔC/T1
  JointVector turn_;      ///< ΔC·t_acc/T1 + ΔB
  double t_acc_ = 0;
};

}  // namespace rob::motion
