#pragma once

#include "motion/robots/robot_model.h"
#include "motion/space/joint_vector.h"
#include "motion/space/pose.h"

namespace rob::motion {

/// By how much a place of the axes misses another.
struct Miss {
  double distance = 0;  ///< m, of the tip
  double angle = 0;     ///< rad, of the tool and of each rotary axis
};

/// `tip`: of the tool, seen from the flange.
Miss miss_between(const RobotModel& robot, const Pose& tip, const JointVector& q,
                  const JointVector& point);

/// By how much to shrink a corner that misses so much; 1 and more: not at all. Bounds: m, rad.
double shrinking(const Miss& miss, double distance, double angle);

}  // namespace rob::motion
