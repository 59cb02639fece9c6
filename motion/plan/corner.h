#pragma once

#include <optional>

#include "motion/path/tool_line.h"
#include "motion/plan/leg_motion.h"
#include "motion/robots/robot_model.h"

namespace rob::motion {

/// The way from one leg into the next around the point between them. The parameter of `axes` is
/// time, from −half to half s, 0 when the point would be reached. Position, velocity and
/// acceleration are continuous at both ends.
struct Corner {
  JointPath axes;
  double half = 0;
};

/// The motions that a corner joins, and its bounds.
struct CornerTask {
  LegMotion in;
  LegMotion out;
  const ToolLine* line_in = nullptr;  ///< of a leg on a straight line of the tool
  const ToolLine* line_out = nullptr;
  Pose tip;            ///< of the tool, seen from the flange
  double longest = 0;  ///< s: the greatest `half`
  double zone = 0;     ///< m by which the tip may miss the point; infinite: it does not matter
  double braking = 0;  ///< 1/s: what a hold may ask for beside (TimeScaleLimits::slope)
};

/// The corner with the greatest `half` that keeps the zone and what the axes may do; none where
/// there is none.
///
/// Between two lines the tip is led by Paul's quartic, and so is its turning, as rotation vectors
/// about the orientation in the point. Any other corner is a quintic of the axes.
std::optional<Corner> make_corner(const RobotModel& robot, const CornerTask& task);

/// The corner's axes for that `half`, whatever they may do; none where the tip cannot be led.
/// `longest`, `zone` and `braking` do not count.
std::optional<JointPath> corner_axes(const RobotModel& robot, const CornerTask& task, double half);

/// By how much the tip misses the point at least, m, on the way of corner_axes().
double corner_miss_of(const RobotModel& robot, const CornerTask& task, const JointPath& axes);

/// By how far the tip's way and those that corner_axes() replaces are apart at most, m. Where one
/// of them winds round that can be far more than it misses the point by.
double beside_ways(const RobotModel& robot, const CornerTask& task, const JointPath& axes);

/// Whether the tip's way beside the point turns by more than 90° within such a corner.
bool winds_round(const RobotModel& robot, const CornerTask& task, double half);

}  // namespace rob::motion
