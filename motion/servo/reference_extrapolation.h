#pragma once

#include "motion/space/joint_vector.h"

namespace rob::motion {

/// How the axes go on when no reference follows the last one. s, SI.
///
///     q'  ──╮ constant acceleration, at most v_max
///           ╰──────╮
///                   ╲  all axes to rest in the same time,
///                    ╲ the hardest at a_max
///                     ╰──────────────
///     stamp        +3 periods
///
/// libfranka, too, takes a lost packet for constant acceleration. Because all axes come to rest
/// together, the tool stays on the tangent of its path. May be used in the tick.
class ReferenceExtrapolation {
 public:
  /// How long the last acceleration is believed. [choice] Three periods of 10 ms at the highest
  /// jerk of the gantry (1 m/s³) are 4.5 µm off, still much less than a following error.
  static constexpr int kPeriods = 3;

  ReferenceExtrapolation(double period, const JointVector& v_max, const JointVector& a_max);

  void start(const JointReference& last) noexcept;
  const JointReference& base() const noexcept { return base_; }
  /// Neither velocity nor acceleration: standing there is no extrapolation.
  bool at_rest() const noexcept { return at_rest_; }

  /// now >= base().time.
  JointReference at(double now) const noexcept;

 private:
  JointReference coast(double now) const noexcept;

  double coast_time_;
  JointVector v_max_;
  JointVector a_max_;
  JointReference base_;
  JointReference ramp_;  // where the ramp to rest begins
  double ramp_time_ = 0;
  bool at_rest_ = true;
};

}  // namespace rob::motion
