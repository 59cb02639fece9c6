#pragma once

#include <cmath>
#include <memory>
#include <vector>

#include "motion/ahead/path_item.h"
#include "motion/ahead/piece.h"
#include "motion/plan/leg_motion.h"
#include "motion/plan/segment_descriptor.h"
#include "motion/robots/robot_model.h"

namespace rob::motion {

/// The share of the axes' jerk that the bends of an arm's path may ask for; what they do ask for at
/// the speed that is planned is not there for speeding up and slowing down near them (SpeedPlan).
/// [choice]
inline constexpr double kBendsShare = 0.85;

/// d³q/dσ³ at `at`, σ from the beginning of a piece.
JointVector third_derivative(const Piece& piece, double at);

/// s of a mean, which has whole periods.
inline double whole_periods(const RobotModel& robot, double average) {
  return std::ceil(average / robot.reference_period - 1e-9) * robot.reference_period;
}

/// s: what is passed sooner is a short motion. [choice] of 8 reference periods
inline double few_periods(const RobotModel& robot) { return 8 * robot.reference_period; }

/// A motion as part of a path: from the middle of the corner before it, or from rest.
struct ShapedLeg {
  SegmentDescriptor segment;
  LegMotion motion;                            ///< evenly along σ: its `duration` is its length, m
  std::shared_ptr<const PathStretch> stretch;  ///< PathItem
  double begin = 0;                            ///< σ at its beginning
  double sent = 0;              ///< m from there, up to which it has been made into pieces
  double before = Piece::kAny;  ///< m by which the tip may miss the point before it
  bool starts = false;          ///< at rest
  bool ends = false;            ///< at rest: there is no corner after it
  JointVector acceleration;
  JointVector jerk;  ///< m/s³, rad/s³; infinite where it is not bounded

  double length() const noexcept { return motion.duration; }
  double end() const noexcept { return begin + length(); }
  /// The next item continues it without a corner.
  bool goes_on() const noexcept { return stretch && stretch->goes_on; }
  /// It is a curve along several motions, not a part of one.
  bool merged() const noexcept { return stretch && !stretch->slopes.empty(); }
  PathPoint at(double way) const noexcept { return motion.at(way); }
};
ShapedLeg shaped_leg(const RobotModel& robot, const SegmentDescriptor& segment, double begin);
ShapedLeg shaped_leg(const RobotModel& robot, const PathItem& item, double begin);

/// σ' that is asked for on a leg, or what the speeds of the axes leave of it at one of its places.
double greatest_rate(const RobotModel& robot, const ShapedLeg& leg, const PathPoint& place);

/// Lowers Piece::fastest to what the speeds of the axes leave where they have these slopes, dq/dσ.
void bound_speed(const RobotModel& robot, const JointVector& slopes, Piece& piece);

/// σ'' that the axes allow at one of its places, as if it were straight.
double greatest_control(const ShapedLeg& leg, const PathPoint& place);

/// The greatest u with which all axes can take on u times `turn`: min A_i/|turn_i|.
double turning_reserve(const ShapedLeg& in, const ShapedLeg& out, const JointVector& turn);

/// A leg from rest to rest with nothing before and after, in the least time: that of a
/// third-order profile. The mean takes A/J, for the guide pauses (Guide).
///
/// The forces that an arm's mechanics ask of its drives are known only when they cannot give them:
/// such a robot must be able to slow down at once (DriveRelief). It does not pause, and its mean
/// takes 2A/J; so does that of a leg along a path of the tool, which bends.
struct LegAlone {
  double share = 1;    ///< of the leg's accelerations
  double average = 0;  ///< s of the mean
  double time = 0;     ///< s from rest to rest
  bool pauses = false;
};
LegAlone alone(const RobotModel& robot, const ShapedLeg& leg);

/// The way from one leg into the next around the point between them: `half` m of σ on each side.
struct Turn {
  double half = 0;
  JointPath axes;                ///< of σ from −half to half; none: a parabola of the axes
  double fastest = Piece::kAny;  ///< σ' in it, for the sake of the mean that follows
  double calm = 1;      ///< share of the axes' accelerations to be used around it (MeanShift)
  double calm_way = 0;  ///< on each side of its middle, m
};

/// The pieces of a leg from one place to a later one, m from its beginning; straight ones no longer
/// than `longest`.
void append_leg(const RobotModel& robot, const ShapedLeg& leg, double from, double to,
                double longest, std::vector<Piece>& pieces);
/// Appends the pieces of a corner, split in its middle: there the pace changes from one leg's to
/// the other's.
void append_turn(const RobotModel& robot, const ShapedLeg& in, const ShapedLeg& out,
                 const Turn& turn, std::vector<Piece>& pieces);

}  // namespace rob::motion
