#pragma once

#include <cstdint>
#include <memory>

#include "motion/plan/leg_demand.h"
#include "motion/plan/planned_leg.h"
#include "motion/plan/profile.h"
#include "motion/space/joint_vector.h"

namespace rob::motion {

/// A motion in the making.
struct MotionDraft {
  JointVector target;  ///< m, rad
  bool no_length = false;
  LegDemand demand{};
  std::shared_ptr<PlannedLeg> leg{};  ///< null: straight in the axes, and S1's corner
  PaceCut pace_cut{};
};

/// Its time, s.
struct Timing {
  double duration = 0;
  double t_acc = 0;
  std::uint8_t limit = 0;     ///< SegmentMotion
  std::uint8_t warnings = 0;  ///< PlannedSegment
  ProfileLaw profile{};
};

}  // namespace rob::motion
