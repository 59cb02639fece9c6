#pragma once

#include <array>

#include "motion/space/axis_motion.h"
#include "motion/space/joint_vector.h"

namespace rob::motion {

/// All axes from any state to rest at a target, together, as fast as the slowest of them can.
///
///     q1 ──╲______          each axis keeps its own limits of speed, acceleration and jerk;
///     q2 ─╲_______          those that could be faster take the slowest one's time
///        aim()   arrival()
///
/// A new target may be aimed at in the middle of a motion, from its own state there: position,
/// speed and acceleration go on without a leap. It keeps no line in any space and knows no ends of
/// axes: where it stops between the state and the target, an axis may be beyond both if its speed
/// leads there. SI. Every call but the constructor may be used in the tick.
class PointToPoint {
 public:
  PointToPoint(const JointVector& v_max, const JointVector& a_max, const JointVector& j_max);

  void aim(const JointReference& from, const JointVector& target) noexcept;
  /// When all are at rest at the target.
  double arrival() const noexcept { return begin_ + duration_; }
  /// At a time no earlier than that of the state it came from.
  JointReference at(double time) const noexcept;

 private:
  JointVector v_max_, a_max_, j_max_;
  std::array<AxisMotion, kMaxJoints> axes_{};
  double begin_ = 0;
  double duration_ = 0;
};

}  // namespace rob::motion
