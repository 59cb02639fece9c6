#pragma once

#include <cstddef>
#include <memory>
#include <optional>

#include "motion/ahead/path_planner.h"
#include "motion/ahead/path_ring.h"
#include "motion/generate/trajectory_generator.h"
#include "motion/plan/look_ahead_buffer.h"
#include "motion/plan/motion_planner.h"
#include "motion/robots/robot_model.h"

namespace rob::motion {

/// The parts that make references of what one side commands, by the robot's law. Three threads may
/// use it: one `planner` and the writer's side of `buffer`, one plan_path(), one `generator`.
struct MotionChain {
  /// How much may be under way.
  struct Room {
    std::size_t motions = 0;  ///< that the program may be ahead
    std::size_t pieces = 0;   ///< that a path ahead may have
  };

  /// Under the look-ahead law: what lies between the buffer and the generator.
  struct Path {
    Path(const RobotModel& robot, LookAheadBuffer& buffer, const Room& room);

    PathRing ring;
    PathPlanner planner;
  };

  /// As much as the robot file says. The axes stand at the robot's start.
  explicit MotionChain(const RobotModel& robot);
  MotionChain(const RobotModel& robot, const Room& room);

  /// Plans the path ahead; neither in the tick nor in the program. Whether there was anything.
  bool plan_path() { return path && path->planner.work(); }

  LookAheadBuffer buffer;
  MotionPlanner planner;
  std::optional<Path> path;
  std::unique_ptr<TrajectoryGenerator> generator;
};

}  // namespace rob::motion
