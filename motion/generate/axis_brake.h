#pragma once

#include "motion/space/joint_vector.h"

namespace rob::motion {

/// Brings all axes to rest at the same instant, as fast as the accelerations permit and without a
/// limit of jerk: each decelerates at a constant rate, one of them at its a_max. The way is
/// straight in the space of the axes, along the velocity at the start; it leaves a path that bends.
/// Every call but the constructor may be used in the tick.
class AxisBrake {
 public:
  /// `a_max`: of each axis, m/s² or rad/s².
  explicit AxisBrake(const JointVector& a_max) : a_max_(a_max) {}

  /// From this reference on; its acceleration does not count.
  void start(const JointReference& from) noexcept {
    from_ = from;
    duration_ = from.qd.cwiseAbs().cwiseQuotient(a_max_).maxCoeff();
    active_ = true;
    rested_ = false;
  }
  bool active() const noexcept { return active_; }
  /// When the axes stand, s.
  double rest() const noexcept { return from_.time + duration_; }

  /// Whether the axes stand at `time`; true once.
  bool take_rest(double time) noexcept {
    const bool comes = !rested_ && time >= rest();
    rested_ = rested_ || comes;
    return comes;
  }

  /// At `time`, no earlier than the start.
  JointReference at(double time) const noexcept {
    JointReference now = from_;
    now.time = time;
    now.qdd.setZero(from_.q.size());
    if (duration_ == 0) return now;
    const double since = time < rest() ? time - from_.time : duration_;
    now.q += from_.qd * (since - since * since / (2 * duration_));
    now.qd = from_.qd * (1 - since / duration_);
    if (time < rest()) now.qdd = from_.qd / -duration_;
    return now;
  }

 private:
  JointVector a_max_;
  JointReference from_{};
  double duration_ = 0;  ///< s
  bool active_ = false;
  bool rested_ = false;
};

}  // namespace rob::motion
