#include "motion/generate/retrace.h"

#include <algorithm>
#include <limits>

namespace rob::motion {

namespace {

/// With r = dplace/dt·T, the recorded q' <= v·T, q'' <= a·T², q''' <= j·T³ by the place, and r <=
/// ½:
///
///     qd   = q'·r/T                                      <= v/2
///     qdd  = q''·r²/T² + q'·ṙ/T                          <= a/4 + v·ṙ        = 3/4·a
///     qddd = q'''·r³/T³ + 3·q''·r·ṙ/T² + q'·r̈/T          <= j/8 + 3/2·a·ṙ + v·r̈ = 3/4·j
///
/// by ṙ <= a/2v, ṙ <= j/4a, r̈ <= j/4v.
AxisLimits limits_of(const RobotModel& robot) {
  AxisLimits rate{0.5, std::numeric_limits<double>::infinity(),
                  std::numeric_limits<double>::infinity()};
  for (const Axis& axis : robot.axes) {
    rate.a = std::min({rate.a, axis.a_max / axis.v_max / 2, axis.j_max / axis.a_max / 4});
    rate.j = std::min(rate.j, axis.j_max / axis.v_max / 4);
  }
  const double T = robot.reference_period;
  return {rate.v / T, rate.a / T, rate.j / T};
}

}  // namespace

Retrace::Retrace(const RobotModel& robot, std::size_t most)
    : record_(most), limits_(limits_of(robot)) {}

void Retrace::aim(double place, double share) noexcept {
  const AxisState now = course_.at(time_);
  course_ = AxisMotion(now, place, {limits_.v * share, limits_.a, limits_.j});
  time_ = 0;
}

bool Retrace::back(double share) noexcept {
  if (record_.empty()) return false;
  if (!away_) {
    left_ = record_.last();
    course_ = AxisMotion({left_, 0, 0}, left_, limits_);
    time_ = 0;
  }
  const double here = course_.at(time_).q;
  const auto mark = record_.mark_before(held_at_ >= 0 ? std::min(held_at_, here) : here);
  const double target = mark ? mark->place : record_.first();
  if (target >= here) return false;
  away_ = true;
  returns_ = false;
  held_at_ = target;
  tag_ = mark ? mark->tag : 0;
  aim(target, share);
  return true;
}

void Retrace::forth(double share) noexcept {
  held_at_ = -1;
  returns_ = true;
  aim(left_, share);
}

void Retrace::halt() noexcept {
  const AxisState now = course_.at(time_);
  held_at_ = -1;
  returns_ = false;
  tag_ = 0;
  aim(speed_change(now, 0, limits_).end(now).q, 1);
}

void Retrace::pass(double time) noexcept {
  time_ += time;
  if (!moving() && course_.at(time_).q == left_) away_ = returns_ = false;
}

JointReference Retrace::reference(double time) const noexcept {
  const AxisState state = course_.at(time_);
  JointReference reference = record_.at(state.q);
  reference.time = time;
  reference.qdd = reference.qdd * (state.v * state.v) + reference.qd * state.a;
  reference.qd *= state.v;
  return reference;
}

void Retrace::stay() noexcept {
  record_.cut(course_.at(time_).q);
  held_at_ = -1;
  away_ = false;
}

}  // namespace rob::motion
