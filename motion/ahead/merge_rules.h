#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <vector>

#include "motion/ahead/curve_axes.h"
#include "motion/ahead/path_item.h"
#include "motion/robots/robot_model.h"

namespace rob::motion {

/// Which motions of a robot may become part of a curve, where they lie, and what they ask of it.
class MergeRules {
 public:
  explicit MergeRules(const RobotModel& robot);

  /// Straight, with a zone that is a length and no pace of its own.
  bool mergeable(const SegmentDescriptor& segment) const;

  // Where a mergeable motion begins and ends, m, and its direction, of length 1.
  Eigen::Vector3d begin_of(const SegmentDescriptor& segment) const;
  Eigen::Vector3d end_of(const SegmentDescriptor& segment) const;
  Eigen::Vector3d direction(const SegmentDescriptor& segment) const;

  /// m/s of σ.
  double speed_on(const SegmentDescriptor& segment) const;
  /// m: a leg that is shorter is passed in a few periods.
  double soon(const SegmentDescriptor& segment) const;
  /// m: a leg that does not crowd, and is shorter, does not keep legs around it from becoming a
  /// curve with a mean that bounds the jerk. `crowd`: the first of these, by which knots are made.
  double longest_between(const SegmentDescriptor& crowd, const SegmentDescriptor& segment) const;
  /// m of each leg that a corner between them would like to have; 0 where there is none.
  double corner_half(const SegmentDescriptor& in, const SegmentDescriptor& out) const;
  /// Where a mean bounds the jerk: whether a curve takes less time for the leg, with corners at
  /// both ends like the one into `out`, than a motion from rest to rest that overlaps the next.
  bool sooner_on_curve(const SegmentDescriptor& segment, const SegmentDescriptor& out) const;
  /// On an arm whose jerk is bounded: the leg bends into the next one so little that a curve is
  /// sooner than a corner and a stop, however long the leg is.
  bool bends_gently(const SegmentDescriptor& segment, const SegmentDescriptor& out) const;
  /// It goes on so straight that nothing is won by a curve.
  bool nearly_straight(const SegmentDescriptor& segment, const SegmentDescriptor& out) const;
  /// m by which a curve may leave a leg.
  double tolerance(const SegmentDescriptor& segment) const;

  /// How far knots lie apart, m, and the stiffness of CurveFit; of a curve that rounds its bends
  /// by jerk, or by acceleration.
  struct Knots {
    double apart = 0;
    double stiffness = 1;
    int order = 2;  ///< of the differences that CurveFit keeps small
  };
  Knots knots_for(const SegmentDescriptor& segment, bool by_jerk) const;

  /// The linear axes along a part of a curve; all others stay as in `like`.
  JointPath axes_of_table(const CurveFit& fit, const CurvePart& part,
                          const JointVector& like) const;

 private:
  bool is_straight(const SegmentDescriptor& segment) const;
  double strength(const SegmentDescriptor& segment) const;
  double reachable_speed(const SegmentDescriptor& segment) const;
  double led_off_by_jerk(const SegmentDescriptor& segment, const SegmentDescriptor& out) const;
  double beside_arc(const SegmentDescriptor& segment, const SegmentDescriptor& out) const;
  Eigen::Vector3d place(const JointVector& q) const;
  JointVector axes_at(const JointVector& like, const Eigen::Vector3d& place) const;

  const RobotModel& robot_;
  std::vector<Eigen::Index> linear_;  ///< the axes that are merged
};

/// Where a mean of the axes bounds the jerk of a curve: the share of its accelerations, and of the
/// mean's time, that keeps the mean within its part of the zone at any acceleration of the axes. 1
/// if there is no mean.
double share_for_mean(const RobotModel& robot, const LegBounds& bounds);

/// Whether a curve may lead from one into the other.
bool joins(const SegmentDescriptor& in, const SegmentDescriptor& out);

/// A piece of a tool's line, between two shares of it.
std::shared_ptr<PathStretch> part_of_line(const SegmentDescriptor& segment, double from, double to);
/// The segment is that part, from here on.
void lie_on(const PathStretch& part, SegmentDescriptor& segment);

}  // namespace rob::motion
