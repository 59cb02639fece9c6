#pragma once

#include <optional>

#include "motion/collision/path_proof.h"
#include "motion/plan/segment_descriptor.h"
#include "runtime/command/assumptions.h"
#include "runtime/words/words.h"

namespace rob::runtime {

/// Proves that a motion hits nothing before it is queued, where the robot's file has shapes. A run
/// is proved as a whole when it is foretold, rounded corners included; this is for motions that
/// nobody has foreseen, such as those after a look at an input. A program that is only foretold is
/// not looked at here: ContactWatch follows its references.
class ContactProof {
 public:
  ContactProof(const motion::RobotModel& robot, const Assumptions& assumptions);
  ContactProof(const ContactProof&) = delete;

  /// What the motion would hit on its way from `from` to its target; none if nothing.
  std::optional<Words> hit(int line, const motion::JointVector& from,
                           const motion::SegmentDescriptor& segment);

 private:
  std::optional<motion::PathProof::Contact> follow(const motion::SegmentDescriptor& segment,
                                                   double& share, motion::JointVector& q);

  const motion::RobotModel& robot_;
  const Assumptions& assumptions_;
  const motion::Clearance clearance_;
  motion::PathProof proof_;
};

}  // namespace rob::runtime
