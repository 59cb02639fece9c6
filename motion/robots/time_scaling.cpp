#include "motion/robots/time_scaling.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rob::motion {

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
TimeScaleLimits time_scale_limits(const RobotModel& robot) {
  const double t = robot.t_acc;
  double acceleration_left = std::numeric_limits<double>::infinity();
  double jerk_left = std::numeric_limits<double>::infinity();
  for (const Axis& axis : robot.axes) {
    acceleration_left = std::min(acceleration_left, axis.a_max / axis.v_max - 1.5 / t);
    jerk_left = std::min(jerk_left, axis.j_max / axis.v_max - 3 / (t * t));
  }
  const double slope = std::min(acceleration_left, jerk_left / 2 / (4.5 / t));
  return {slope, jerk_left - 4.5 / t * slope};
}

double stopping_time(const TimeScaleLimits& limits) {
  const auto [slope, bend] = limits;
  if (slope * slope >= bend) return 2 / std::sqrt(bend);  // r' is a triangle
  return 1 / slope + slope / bend;                        // a trapezium
}

}  // namespace rob::motion
