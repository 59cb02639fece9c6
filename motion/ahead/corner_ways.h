#pragma once

#include <vector>

#include "motion/plan/last_target.h"
#include "motion/plan/segment_descriptor.h"
#include "motion/robots/robot_model.h"

namespace rob::motion {

/// All that the axes may do around the corner between two motions, when what follows the second one
/// is not known yet: ways from the first motion into the second, m or rad, and how far beside one
/// of them each axis may be.
struct CornerWays {
  std::vector<std::vector<JointVector>> ways;
  JointVector beside;
};

/// `before`: the planner between the two. `in`: the motion before; null: only `before` is known of
/// it. None where the second motion begins at rest.
///
/// Under Paul's law it is one way, that of the references. Under the look-ahead law a corner gets
/// its length later, and the mean that bounds the jerk moves it inwards: both stay between the
/// point and the parabola of the axes over the longest corner and half of the mean's time, at twice
/// the speed. Parabolas from short to long stand for all that is between.
CornerWays corner_ways(const RobotModel& robot, const LastTarget& before, const SegmentMotion* in,
                       const SegmentMotion& out);

}  // namespace rob::motion
