#pragma once

#include <cstddef>
#include <deque>

#include "motion/ahead/path_item.h"
#include "motion/ahead/path_shape.h"
#include "motion/robots/robot_model.h"

namespace rob::motion {

// Which mean a run has where it is one of the axes, and bounds their jerk. A run keeps its mean
// from rest to rest.

/// [choice] So many items are looked at for the first curve of a run.
inline constexpr std::size_t kMostBeforeCurve = 256;

/// Whether that decides on the mean of a run that begins with the first of these items, and is not
/// known yet: all of them are short.
bool awaits_curve(const RobotModel& robot, const std::deque<PathItem>& items);

/// Where a run begins with `leg`: of its accelerations, and of the mean's time, what lets it be
/// gone the fastest. `next` follow it; 1 where too little is known.
double share_for_bends(const RobotModel& robot, const ShapedLeg& leg,
                       const std::deque<PathItem>& next);

/// A mean of so many s is too long for the first item, or for the curve that it leads into.
bool needs_shorter_mean(const RobotModel& robot, double window, const std::deque<PathItem>& items);

}  // namespace rob::motion
