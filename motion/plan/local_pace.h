#pragma once

#include <optional>

#include "motion/path/joint_path.h"
#include "motion/path/paced_path.h"
#include "motion/path/tool_path.h"
#include "motion/robots/robot_model.h"

namespace rob::motion {

/// The pace that a motion along a path of the tool asks for.
struct PaceWish {
  double rate = 0;   ///< 1/s: the greatest that the tool may have; infinite where none is asked for
  double share = 1;  ///< of the axes' speeds
  double change = 0;  ///< 1/s by which the path's time may also speed up or slow down
};

/// At each place the greatest rate that its axes can follow, and not above the wish, with what it
/// takes to change it; smooth within jerk. None if the path has no way to pace.
std::optional<PaceLaw> local_pace(const RobotModel& robot, const JointPath& axes,
                                  const PaceWish& wish);

}  // namespace rob::motion
