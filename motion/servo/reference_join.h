#pragma once

#include "motion/space/joint_vector.h"

namespace rob::motion {

/// The difference between where the axes are sent and where the references are, on its way to
/// nothing. s, SI. It is added to the references.
///
/// The velocity is matched first, in d_v; the distance that is left by then is made up slowly, in
/// d_q. With Δ the difference at the start, c the distance lost while the velocity is matched:
///
///     o(t) = p(t) − c + (Δq + c)·(1 − 10s³ + 15s⁴ − 6s⁵),   s = t/d_q
///     p'(t) = Δq'·(1 − 3r² + 2r³) + Δq''·d_v·(r − 2r² + r³),   r = t/d_v,   c = p(d_v)
///
/// so that o, o', o'' begin at Δ and end at 0. One quintic for all three would overshoot by half of
/// Δq', however long it lasts. The times are the least, the same for all axes, that keep
///
///     speed beyond the references and Δq'    <= v_max/10 + 4/27·d_v·|Δq''|
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

  double period_;
  JointVector v_max_;
  JointVector a_max_;
  bool active_ = false;
  double start_ = 0;
  double d_v_ = 0;
  double d_q_ = 0;
  JointVector dv_;    // Δq'
  JointVector da_;    // Δq''
  JointVector lost_;  // c
  JointVector way_;   // Δq + c
};

}  // namespace rob::motion
