#pragma once

#include "motion/dynamics/arm_mechanics.h"
#include "motion/plan/last_target.h"
#include "motion/plan/leg_timing.h"
#include "motion/plan/motion_draft.h"
#include "motion/plan/motion_request.h"
#include "motion/plan/segment_maker.h"
#include "motion/plan/torque_share.h"
#include "motion/robots/robot_model.h"

namespace rob::motion {

/// Whether the gears and drives of an arm whose mechanics are known suffice for a motion under
/// Paul's law: T1 is raised until they do all along (torque_share.h); a corner that asks too much
/// of them all the same becomes exact. A weight that they do not bear is not found here: the servo
/// will report it.
class DriveFit {
 public:
  DriveFit(const RobotModel& robot, const LastTarget& last, const LegTiming& timing,
           const SegmentMaker& segments) noexcept
      : robot_(robot), last_(last), timing_(timing), segments_(segments) {}

  /// Slows the motion down until they suffice, in the corner too if that helps; else it will have
  /// to begin at rest.
  void suit(const ArmMechanics& mechanics, const MotionRequest& request, MotionDraft& draft,
            Timing& timing) const;
  bool corner_fits(const ArmMechanics& mechanics, const SegmentDescriptor& segment) const {
    return !(demanded_by_corner(mechanics, segment).speed < 1);
  }

 private:
  TorqueShare demanded_alone(const ArmMechanics& mechanics, const SegmentDescriptor& segment) const;
  TorqueShare demanded_by_corner(const ArmMechanics& mechanics,
                                 const SegmentDescriptor& segment) const;

  const RobotModel& robot_;
  const LastTarget& last_;
  const LegTiming& timing_;
  const SegmentMaker& segments_;
};

}  // namespace rob::motion
