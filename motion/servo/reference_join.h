#pragma once

#include "motion/space/joint_vector.h"
#include "motion/space/point_to_point.h"

namespace rob::motion {

/// The difference between where the axes are sent and where the references are, on its way to
/// nothing: from its own position, speed and acceleration to rest at 0 as one motion from point to
/// point. s, SI. It is added to the references.
///
/// With Δ the difference at the start, every axis keeps
///
///     speed beyond the references             <= max(v_max/10, |Δq'| + |Δq''|·τ/2)
///     acceleration beyond the references      <= max(a_max/2, |Δq''|)
///     jerk beyond the references              <= j_max/2          τ = max |Δq''|/(j_max/2)
///
/// It may be started again at any time, from what is left and what has been added to it. If nothing
/// has, it goes on as it was: so a join that is disturbed again and again closes, too. Where Δq,
/// Δq' and Δq'' lie along one direction, as they do on a straight line, it stays along that, in the
/// space of the axes exactly and of an arm's tool as nearly as it is short. The end is exact.
///
/// [choice] A tenth lets a drive that is planned to v_max follow; half leaves the references
/// theirs. With infinite j_max the acceleration leaps. May be used in the tick.
class ReferenceJoin {
 public:
  ReferenceJoin(const JointVector& v_max, const JointVector& a_max, const JointVector& j_max);

  /// `from` and `to` at the same instant: where the axes are sent, where they should be.
  void start(const JointReference& from, const JointReference& to) noexcept;
  void clear() noexcept {
    active_ = false;
    behind_ = 0;
  }
  bool active() const noexcept { return active_; }

  /// Adds what is left at reference.time; ends by itself.
  void apply(JointReference& reference) noexcept;

  /// The time that was left at the last apply(), s: the longest time that an axis needs for it at
  /// v_max.
  double behind() const noexcept { return behind_; }

 private:
  JointVector direction_of(const JointReference& left) const noexcept;

  JointVector v_max_;  ///< what it may take of the limits
  JointVector a_max_;
  JointVector j_max_;
  PointToPoint way_;
  double behind_ = 0;
  bool active_ = false;
};

}  // namespace rob::motion
