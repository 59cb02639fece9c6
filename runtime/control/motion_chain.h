#pragma once

#include <memory>

#include "motion/generate/trajectory_generator.h"
#include "motion/plan/look_ahead_buffer.h"
#include "motion/plan/motion_planner.h"
#include "motion/robots/robot_model.h"

namespace rob::runtime {

/// What makes references of what one side commands, the program or the handlers of its WHENs, by
/// the robot's law.
struct MotionChain {
  /// The axes stand at the robot's start.
  explicit MotionChain(const motion::RobotModel& robot);

  motion::LookAheadBuffer buffer;
  motion::MotionPlanner planner;
  std::unique_ptr<motion::TrajectoryGenerator> generator;
};

}  // namespace rob::runtime
