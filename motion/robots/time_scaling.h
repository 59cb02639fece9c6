#pragma once

#include "motion/robots/robot_model.h"

namespace rob::motion {

/// How fast the time scale r of a motion under Paul's law may change, so that holding,
/// resuming and override keep every axis within a_max and j_max wherever on the path they come.
struct TimeScaleLimits {
  double slope = 0;  ///< 1/s: greatest |r'|
  double bend = 0;   ///< 1/s²: greatest |r''|
};

/// Not positive where Paul's corners alone use up an axis' acceleration or jerk.
TimeScaleLimits time_scale_limits(const RobotModel& robot);

/// s that r takes from 1 to 0 under these limits.
double stopping_time(const TimeScaleLimits& limits);

}  // namespace rob::motion
