#pragma once

#include <vector>

#include "motion/robots/robot_model.h"

namespace rob::runtime {

/// One number of each axis, in its unit.
inline motion::JointVector axis_values(const motion::RobotModel& robot,
                                       double motion::Axis::*number) {
  motion::JointVector values(robot.axis_count());
  for (int i = 0; i < robot.axis_count(); ++i)
    values[i] = robot.axes[static_cast<std::size_t>(i)].*number;
  return values;
}

inline std::vector<motion::DriveData> drives_of(const motion::RobotModel& robot) {
  std::vector<motion::DriveData> drives;
  for (const motion::Axis& axis : robot.axes) drives.push_back(axis.drive);
  return drives;
}

}  // namespace rob::runtime
