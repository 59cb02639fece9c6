#include "motion/robots/time_scaling.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rob::motion {

namespace {

/// Where jerk is unlimited r' has its greatest value within a millisecond. [choice] so that r'' is
/// a number
TimeScaleLimits bounded(double slope, double bend) noexcept {
  constexpr double kRise = 1e-3;
  return {slope, std::isfinite(bend) ? bend : slope / kRise};
}

}  // namespace

// On a path q(s) run with s' = r (r <= 1) the chain rule gives, with q', q'', q''' along s,
//
//   acceleration  q''·r² + q'·r'                   jerk  q'''·r³ + 3·q''·r·r' + q'·r''
//
// Paul's law (S1) with v = v_max, t = t_acc has |q'| <= v; at worst, where an axis turns from −v
// to +v, |q''| <= 0.75·2v/t = 1.5·v/t and |q'''| <= 1.5·2v/t² = 3·v/t². With |r'| <= R, |r''| <= S
// it is therefore enough that on every axis
//
//   v·(1.5/t + R) <= a_max                         v·(3/t² + 4.5·R/t + S) <= j_max
//
// R takes all that a_max leaves, but at most half of the jerk that the corner leaves goes into
// the mixed term [choice: so that S stays positive, and near the best share for low j_max].
TimeScaleLimits time_scale_limits(const AxisReserve& reserve, double t_acc) noexcept {
  const double acceleration_left = reserve.acceleration - 1.5 / t_acc;
  const double jerk_left = reserve.jerk - 3 / (t_acc * t_acc);
  const double slope = std::min(acceleration_left, jerk_left / 2 / (4.5 / t_acc));
  return bounded(slope, jerk_left - 4.5 / t_acc * slope);
}

TimeScaleLimits time_scale_limits(const RobotModel& robot) {
  const AxisReserve reserve = axis_reserve(robot);
  if (robot.law == Law::Paul) return time_scale_limits(reserve, robot.t_acc);
  return bounded(reserve.acceleration / 2, reserve.jerk / 2);
}

AxisReserve axis_reserve(const RobotModel& robot) {
  JointVector speeds(robot.axis_count());
  for (int i = 0; i < robot.axis_count(); ++i)
    speeds[i] = robot.axes[static_cast<std::size_t>(i)].v_max;
  return axis_reserve(robot, speeds);
}

AxisReserve axis_reserve(const RobotModel& robot, const JointVector& speeds) noexcept {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  AxisReserve reserve{kInfinity, kInfinity};
  for (int i = 0; i < robot.axis_count(); ++i) {
    const Axis& axis = robot.axes[static_cast<std::size_t>(i)];
    reserve.acceleration = std::min(reserve.acceleration, axis.a_max / speeds[i]);
    reserve.jerk = std::min(reserve.jerk, axis.j_max / speeds[i]);
  }
  return reserve;
}

double stopping_time(const TimeScaleLimits& limits) {
  const auto [slope, bend] = limits;
  if (slope * slope >= bend) return 2 / std::sqrt(bend);  // r' is a triangle
  return 1 / slope + slope / bend;                        // a trapezium
}

bool leaves_room_to_stop(const AxisReserve& reserve, double t_acc) {
  const TimeScaleLimits limits = time_scale_limits(reserve, t_acc);
  return limits.slope > 0 && limits.bend > 0 && stopping_time(limits) <= kLongestStop;
}

double least_t_acc(const RobotModel& robot) {
  if (robot.law != Law::Paul) return 0;
  const AxisReserve reserve = axis_reserve(robot);
  // Bisection: longer corners only leave more. 50 halvings come closer than any clock resolves.
  double low = 0;
  double high = robot.t_acc;
  for (int i = 0; i < 50; ++i) {
    const double middle = (low + high) / 2;
    (leaves_room_to_stop(reserve, middle) ? high : low) = middle;
  }
  // A segment lasts at least the sum of two: no more than one corner begins in a period.
  return std::clamp(robot.reference_period, high, robot.t_acc);
}

}  // namespace rob::motion
