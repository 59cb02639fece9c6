#pragma once

#include <cstdint>

#include "motion/plan/last_target.h"
#include "motion/plan/leg_timing.h"
#include "motion/plan/motion_draft.h"
#include "motion/plan/segment_descriptor.h"
#include "motion/plan/tool_tip.h"
#include "motion/robots/robot_model.h"

namespace rob::motion {

/// Makes segments out of drafts and their times, with the corners out of the motions before: those
/// into and out of a path of the tool are made here (corner.h). Where there is no corner, and
/// before a profile, the motion begins at rest.
class SegmentMaker {
 public:
  SegmentMaker(const RobotModel& robot, const ToolTip& tip, const LastTarget& last,
               const LegTiming& timing) noexcept
      : robot_(robot), tip_(tip), last_(last), timing_(timing) {}

  SegmentDescriptor segment_to(const JointVector& target, bool no_length,
                               const Timing& timing) const noexcept;
  /// With its corner, which the draft's leg keeps; adds to `warnings` (PlannedSegment).
  SegmentDescriptor joined(MotionDraft& draft, const Timing& timing, std::uint8_t& warnings) const;

 private:
  void join(MotionDraft& draft, SegmentDescriptor& segment, std::uint8_t& warnings) const;

  const RobotModel& robot_;
  const ToolTip& tip_;
  const LastTarget& last_;
  const LegTiming& timing_;
};

}  // namespace rob::motion
