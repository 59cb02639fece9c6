#pragma once

#include <optional>

#include "motion/dynamics/arm_mechanics.h"
#include "motion/plan/feasibility.h"
#include "motion/plan/last_target.h"
#include "motion/plan/motion_draft.h"
#include "motion/plan/planned_segment.h"
#include "motion/plan/tool_tip.h"
#include "motion/robots/robot_model.h"

namespace rob::motion {

// All that can be said of a motion under the look-ahead law before its neighbours are known.

/// A place of the way from `from`, m, rad, where a gear or a drive does not bear what the arm
/// weighs there.
std::optional<Refusal> too_heavy(const RobotModel& robot, const ArmMechanics& mechanics,
                                 const JointVector& from, const MotionDraft& draft);

/// Warns where a leg is too short for the ZONE of the motion before (PlannedSegment::kZoneCut).
void judge_zone(const RobotModel& robot, const ToolTip& tip, const LastTarget& last,
                const MotionDraft& draft, PlannedSegment& planned);

}  // namespace rob::motion
