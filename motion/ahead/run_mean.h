#pragma once

#include <cstddef>
#include <deque>

#include "motion/ahead/path_item.h"
#include "motion/ahead/path_shape.h"
#include "motion/robots/robot_model.h"

namespace rob::motion {

// Which mean a run has where it is one of the axes, and bounds their jerk. A run keeps its mean
// from rest to rest.

/// [choice] How many items the planner looks at to find the first curve of a run.
inline constexpr std::size_t kMostBeforeCurve = 256;

/// Whether the mean of a run that begins with these items depends on a curve that is not known
/// yet: all of them are short.
bool awaits_curve(const RobotModel& robot, const std::deque<PathItem>& items);

/// The share of the accelerations, and of the mean's time, with which a run that begins with `leg`
/// is fastest. `next` follow it; 1 if too little is known.
double share_for_bends(const RobotModel& robot, const ShapedLeg& leg,
                       const std::deque<PathItem>& next);

/// A mean of so many s is too long for the first item, or for the curve that it leads into.
bool needs_shorter_mean(const RobotModel& robot, double window, const std::deque<PathItem>& items);

}  // namespace rob::motion
