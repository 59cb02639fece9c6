#include "motion/path/way_cost.h"

#include <algorithm>

namespace rob::motion {

double way_cost(const RobotModel& robot, const JointVector& from, const JointVector& to) noexcept {
  double sum = 0;
  for (int i = 0; i < robot.axis_count(); ++i) {
    const double time = (to[i] - from[i]) / robot.axes[static_cast<std::size_t>(i)].v_max;
    sum += time * time;
  }
  return sum;
}

double limit_cost(const RobotModel& robot, const JointVector& q) noexcept {
  constexpr double kWeight = 0.01;
  constexpr double kLeast = 1e-6;  // [choice] of 1 − u²: an axis may stand on its limit
  double sum = 0;
  for (int i = 0; i < robot.axis_count(); ++i) {
    const Axis& axis = robot.axes[static_cast<std::size_t>(i)];
    if (!(axis.max > axis.min)) continue;
    const double u = (2 * q[i] - axis.max - axis.min) / (axis.max - axis.min);
    sum += 1 / std::max(1 - u * u, kLeast) - 1;
  }
  return kWeight * sum;
}

bool axes_within(const RobotModel& robot, const JointVector& q) noexcept {
  constexpr double kRounding = 1e-9;  // m, rad
  for (int i = 0; i < robot.axis_count(); ++i) {
    const Axis& axis = robot.axes[static_cast<std::size_t>(i)];
    if (!(q[i] >= axis.min - kRounding && q[i] <= axis.max + kRounding)) return false;
  }
  return true;
}

}  // namespace rob::motion
