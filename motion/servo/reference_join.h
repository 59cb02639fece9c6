#pragma once

#include "motion/space/joint_vector.h"
#include "motion/space/point_to_point.h"

namespace rob::motion {

/// The difference between where the axes are sent and where the references are, on its way to
/// nothing. s, SI. It is added to the references.
///
/// With Δ the difference at the start:
///
///     o(t) = way·f(t) + u·g(t) + Δq''·h(t)      h'' = 1 ╲__     from 1 to 0 in τ, at once
///     u    = Δq' + Δq''·τ/2                     g'  = 1 ‾╲__    a stop, over c, at once
///     way  = Δq + u·c − Δq''·τ²/6               f   = 1 ‾‾╲__   from rest to rest, slowly
///
/// u is the speed when the acceleration has been taken back, in τ = max |Δq''|/(5/16·j_max), way
/// the distance when the speed has, too. f, g, h are one motion from point to point. Each has a
/// share of the limits, so that together they keep on every axis
///
///     speed beyond the references             <= v_max/10 + |Δq'| + |Δq''|·τ/2
///     acceleration beyond the references      <= a_max/2 + |Δq''|
///     jerk beyond the references              <= j_max/2
///
/// They are the same for all axes. So the offset stays among the directions of Δq, Δq' and Δq'': on
/// a straight line, along which all three lie, it is along that line, in the space of the axes
/// exactly and of an arm's tool as nearly as it is short. The end is exact.
///
/// [choice] A tenth lets a drive that is planned to v_max follow; half leaves the references
/// theirs. With infinite j_max the acceleration leaps. May be used in the tick.
class ReferenceJoin {
 public:
  ReferenceJoin(const JointVector& v_max, const JointVector& a_max, const JointVector& j_max);

  /// `from` and `to` at the same instant: where the axes are sent, where they should be.
  void start(const JointReference& from, const JointReference& to) noexcept;
  void clear() noexcept { active_ = false; }
  bool active() const noexcept { return active_; }

  /// Adds what is left at reference.time; ends by itself.
  void apply(JointReference& reference) noexcept;

 private:
  JointVector v_max_;
  JointVector a_max_;
  JointVector j_max_;
  bool active_ = false;
  JointVector way_;
  JointVector speed_;         // u
  JointVector acceleration_;  // Δq''
  PointToPoint fgh_;
};

}  // namespace rob::motion
