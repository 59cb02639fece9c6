#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "motion/collision/path_proof.h"
#include "motion/plan/motion_planner.h"
#include "motion/plan/segment_descriptor.h"
#include "runtime/command/assumptions.h"
#include "runtime/command/way_marks.h"
#include "runtime/words/words.h"

namespace rob::runtime {

/// Proves that a motion hits nothing before it is queued, where the robot's file has shapes. What
/// was foretold has been followed by its references, corners and early ends included, and is taken
/// as it is (trust()). This is for motions that nobody has foreseen, such as those after a look at
/// an input: to its target, where the robot stops if nothing follows, and around the corner that
/// leads into it. A program that is only foretold is not looked at here: ContactWatch follows its
/// references.
class ContactProof {
 public:
  ContactProof(const motion::RobotModel& robot, const Assumptions& assumptions)
      : robot_(robot), assumptions_(assumptions) {}
  ContactProof(const ContactProof&) = delete;

  /// These motions are not judged anew.
  void trust(std::shared_ptr<const ClearedWays> cleared) { cleared_ = std::move(cleared); }
  using Shared = std::shared_ptr<const motion::Clearance>;

  /// The thing that the motion would hit of `clearance` on its way to its target; none if nothing.
  /// `before`: the planner before it was planned.
  std::optional<Words> hit(int line, const Shared& clearance,
                           const motion::MotionPlanner::Mark& before,
                           const motion::SegmentDescriptor& segment);
  /// The mark of the last motion.
  std::uint64_t known_by() const { return known_by_; }

 private:
  using Touch = std::optional<motion::PathProof::Contact>;

  void watch(const Shared& clearance);
  std::optional<Words> judge(int line, const motion::MotionPlanner::Mark& before,
                             const motion::SegmentDescriptor& segment);
  Touch around(const motion::MotionPlanner::Mark& before, const motion::SegmentMotion& segment,
               motion::JointVector& q);
  Touch along(const motion::SegmentDescriptor& segment, double& share, motion::JointVector& q);

  const motion::RobotModel& robot_;
  const Assumptions& assumptions_;
  Shared clearance_;  ///< of the last motion
  std::uint64_t clearance_mark_ = 0;
  std::optional<motion::PathProof> proof_;
  std::shared_ptr<const ClearedWays> cleared_;
  std::uint64_t known_by_ = 0;
  motion::SegmentMotion last_;  ///< the last motion that had a way
};

}  // namespace rob::runtime
