#pragma once

#include "motion/space/joint_vector.h"

namespace rob::motion {

/// The difference between where the axes are sent and where the references are, on its way to
/// nothing. s, SI. It is added to the references.
///
/// The acceleration is matched first, in d_a, the velocity in d_v, and the distance that is left by
/// then is made up slowly, in d_q. With Δ the difference at the start and c the distance lost
/// meanwhile:
///
///     o(t)  = p(t) − c + (Δq + c)·(1 − 10s³ + 15s⁴ − 6s⁵)                            s = t/d_q
///     p'(t) = Δq'·(1 − 3r² + 2r³) + Δq''·d_a·(h − 2h² + h³)           r = t/d_v,   h = t/d_a
///     c     = p(max(d_v, d_a)) = Δq'·d_v/2 + Δq''·d_a²/12
///
/// so that o, o', o'' begin at Δ and end at 0. One quintic for all three would overshoot by half of
/// Δq', however long it lasts. Every time is at least a period and the same for all axes, so that
/// straight lines stay straight; d_v and d_q are the least, d_a the longest that keep
///
///     speed beyond the references and Δq'    <= v_max/10 + v_max/20
///     acceleration beyond the references     <= a_max/2 + |Δq''|
///
/// [choice] A tenth lets a drive that is planned to v_max follow; half leaves the references
/// theirs. May be used in the tick.
class ReferenceJoin {
 public:
  ReferenceJoin(double period, const JointVector& v_max, const JointVector& a_max);

  /// `from` and `to` at the same instant: where the axes are sent, where they should be.
  void start(const JointReference& from, const JointReference& to) noexcept;
  void clear() noexcept { active_ = false; }
  bool active() const noexcept { return active_; }

  /// Adds what is left at reference.time; ends by itself.
  void apply(JointReference& reference) noexcept;

 private:
  void choose_times(const JointVector& dq) noexcept;
  void add_acceleration_part(double h, JointReference& reference) const noexcept;
  void add_velocity_part(double r, JointReference& reference) const noexcept;
  void add_way_part(double s, JointReference& reference) const noexcept;

  double period_;
  JointVector v_max_;
  JointVector a_max_;
  bool active_ = false;
  double start_ = 0;
  double d_a_ = 0;
  double d_v_ = 0;
  double d_q_ = 0;
  JointVector dv_;   // Δq'
  JointVector da_;   // Δq''
  JointVector way_;  // Δq + c
};

}  // namespace rob::motion
