#pragma once

#include <algorithm>
#include <cmath>
#include <utility>

#include "motion/collision/clearance.h"
#include "motion/robots/robot_model.h"

namespace rob::motion {

/// All that the robot can hit, as `data` says. The robot has a kinematics.
inline Clearance clearance_of(const RobotModel& robot, CollisionData data) {
  JointVector travel = JointVector::Zero(robot.axis_count());
  for (int i = 0; i < robot.axis_count(); ++i) {
    const Axis& axis = robot.axes[static_cast<std::size_t>(i)];
    if (axis.kind == AxisKind::Linear)
      travel[i] = std::max(std::fabs(axis.min), std::fabs(axis.max));
  }
  return {robot.kinematics, travel, std::move(data)};
}

/// As its file says.
inline Clearance clearance_of(const RobotModel& robot) {
  return clearance_of(robot, robot.collision);
}

}  // namespace rob::motion
