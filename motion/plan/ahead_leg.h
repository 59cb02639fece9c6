#pragma once

#include <cstdint>

#include "motion/plan/leg_bounds.h"
#include "motion/plan/leg_demand.h"
#include "motion/plan/motion_request.h"
#include "motion/robots/robot_model.h"

namespace rob::motion {

/// A motion under the look-ahead law: its bounds, and what is known of it before its neighbours
/// are.
struct AheadLeg {
  LegBounds bounds;
  double duration = 0;        ///< s: the least that it takes at full speed from end to end
  double alone = 0;           ///< s: the least from rest to rest
  std::uint8_t warnings = 0;  ///< of PlannedSegment
};

/// The longest mean of the references: s, and periods. [choice] So many the tick keeps and adds up;
/// with less jerk the acceleration is made smaller, too.
inline constexpr double kLongestWindow = 2;
inline constexpr int kMostPeriods = 4096;

/// The bounds that a request asks for, per unit of the leg's σ (LegBounds).
///
///   AT v, AT ω    the tip's speed, or that of every rotary axis (on a path, of the tool's
///                 turning), kept at the leg's fastest place
///   AT p%         p times the speed of the axis that is slowest on the leg
///   OVER t        length/t: speeding up and slowing down come on top
///   ACCEL         a share of every axis' a_max: so much that the tip, or the turning, is
///                 accelerated by that much where the axes are strongest, along the leg
///   ACCEL p%      that share itself
///   JERK          T_w = max_i 2·A_i/J_i with A_i that share of a_max, J_i the least of j_max
///                 and of JERK. For a tip that axes of another kind move, 2·σ''/JERK
///   JERK p%       J_i = p·j_max of axis i
///   ZONE          z: miss; t: the corner begins t before the target at the leg's full speed;
///                 p%: of half of the legs; without it the robot's. Its angle, or the
///                 robot's zone.angle, always
///
/// Where jerk is low, and T_w would be long, the share is √(F·J)/2: a ramp up to F, of F/A + 2A/J,
/// takes as long as with √(F·J), and the mean moves corners by an eighth. A leg that turns out to
/// stand alone, or to be part of a curve, has another (PathPlanner). `demand`: per unit of the
/// leg's parameter, with the length of the tip's way.
AheadLeg ahead_leg(const RobotModel& robot, const LegDemand& demand, const MotionRequest& request);

/// Bounds the corner at its target by the ZONE of a request, or the robot's; `speed`: m/s of σ
/// there, for a ZONE in time.
void bound_corner(const RobotModel& robot, const MotionRequest& request, double speed,
                  LegBounds& bounds);

}  // namespace rob::motion
