#pragma once

#include <cstdint>
#include <limits>
#include <memory>

#include "motion/plan/leg_motion.h"
#include "motion/plan/motion_request.h"
#include "motion/plan/planned_leg.h"
#include "motion/space/pose.h"

namespace rob::motion {

/// Where the planner is between two motions: the last target, and how the axes get there. m, rad,
/// s.
struct LastTarget {
  JointVector q;
  double t_acc = 0;  ///< half the transition around it: t_B of the next segment
  bool exact = true;
  std::uint32_t number = 0;  ///< of the last segment made; 0: none yet

  /// The motion that leads there; only where a corner can lead out of it.
  struct Before {
    LegMotion motion;
    std::shared_ptr<const PlannedLeg> leg;
    Pose tool;
    double zone = std::numeric_limits<double>::infinity();  ///< m
    Tag tag = 0;
  };
  Before before;
};

}  // namespace rob::motion
