#pragma once

#include "motion/robots/robot_model.h"

namespace rob::motion {

/// How fast the time scale r of a motion under Paul's law may change, so that holding,
/// resuming and override keep every axis within a_max and j_max wherever on the path they come.
struct TimeScaleLimits {
  double slope = 0;  ///< 1/s: greatest |r'|
  double bend = 0;   ///< 1/s²: greatest |r''|
};

/// The reserve that the axes of a robot have beyond their speed: the least of all axes.
struct AxisReserve {
  double acceleration = 0;  ///< a_max/v_max, 1/s
  double jerk = 0;          ///< j_max/v_max, 1/s²
};
AxisReserve axis_reserve(const RobotModel& robot);
/// The same beyond these speeds, m/s, rad/s.
AxisReserve axis_reserve(const RobotModel& robot, const JointVector& speeds) noexcept;

/// Where corners take 2·t_acc or longer. Not positive where they alone use up an axis' acceleration
/// or jerk. May be used in the tick.
TimeScaleLimits time_scale_limits(const AxisReserve& reserve, double t_acc) noexcept;
/// With the robot's own corners under Paul's law. Under the look-ahead law motions with a PROFILE
/// alone run so, which have no corners: half of what the axes have is for the scale, the rest for
/// the profile [choice: a hold should not take much longer than the profile itself to end].
TimeScaleLimits time_scale_limits(const RobotModel& robot);

/// s that r takes from 1 to 0 under these limits.
double stopping_time(const TimeScaleLimits& limits);

/// A motion that is held must stand within this time, s. [choice: a controlled stop is over within
/// 1 s, so that the drives can then be switched off]
inline constexpr double kLongestStop = 1.0;

/// Whether corners of 2·t_acc leave every axis so much that a motion can be held anywhere.
bool leaves_room_to_stop(const AxisReserve& reserve, double t_acc);

/// s: the least t_acc, above 0, that leaves room to stop; at most the robot's own, which does. 0
/// under the look-ahead law, whose corners have none.
double least_t_acc(const RobotModel& robot);

}  // namespace rob::motion
