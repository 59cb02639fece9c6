#include "motion/ahead/miss.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rob::motion {

Miss miss_between(const RobotModel& robot, const Pose& tip, const JointVector& q,
                  const JointVector& point) {
  Miss miss;
  const Pose a = robot.kinematics->forward(q);
  const Pose b = robot.kinematics->forward(point);
  miss.distance = (place_of(tip.position, a) - place_of(tip.position, b)).norm();
  miss.angle = a.orientation.angularDistance(b.orientation);
  if (robot.tool_coordinates) return miss;
  for (int i = 0; i < robot.axis_count(); ++i) {
    if (robot.axes[static_cast<std::size_t>(i)].kind == AxisKind::Rotary)
      miss.angle = std::max(miss.angle, std::abs(q[i] - point[i]));
  }
  return miss;
}

double shrinking(const Miss& miss, double distance, double angle) {
  double factor = std::numeric_limits<double>::infinity();
  if (miss.distance > 0) factor = std::min(factor, distance / miss.distance);
  if (miss.angle > 0) factor = std::min(factor, angle / miss.angle);
  return factor;
}

}  // namespace rob::motion
