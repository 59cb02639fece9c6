#pragma once

#include <memory>
#include <optional>

#include "runtime/command/commanded.h"
#include "runtime/command/contact_proof.h"
#include "runtime/command/plan_warnings.h"
#include "runtime/command/press_line.h"
#include "runtime/command/robot_links.h"
#include "runtime/command/surroundings.h"
#include "runtime/command/tool_paths.h"
#include "runtime/command/touching.h"

namespace rob::runtime {

/// Turns a motion as it was commanded into a segment: completes its target with WITH and IN, finds
/// its path, and has it planned after all that was planned before. It queues nothing.
class MotionPlans {
 public:
  MotionPlans(const RobotLinks& links, const Assumptions& assumptions,
              const Surroundings& surroundings, const PressLine& press, Touching& touching)
      : links_(links),
        surroundings_(surroundings),
        press_(press),
        touching_(touching),
        proof_(links.robot, assumptions) {}

  /// Fills in the segment, with what is done on its way; or why it cannot be.
  std::optional<Words> plan(int line, Commanded& commanded);
  std::optional<Words> plan_jog(int line, const lang::MoveCommand& asked,
                                motion::SegmentDescriptor& segment);
  /// These motions have been foretold, and hit nothing.
  void trust(std::shared_ptr<const ClearedWays> cleared) { proof_.trust(std::move(cleared)); }
  /// The bodies that a motion in this setting must not hit.
  std::shared_ptr<const motion::Clearance> clearance(const lang::Setting& setting) {
    return touching_.in(setting);
  }
  /// Line of the last motion that was planned.
  int last_line() const { return last_.line; }

 private:
  std::optional<Words> plan_leg(int line, Commanded& commanded);
  std::optional<Words> plan_straight(int line, Commanded& commanded);
  std::optional<Words> plan_along(int line, const motion::MotionRequest& request,
                                  Commanded& commanded);
  std::optional<Words> words_against_branch(const motion::MotionRequest& request,
                                            const lang::MoveCommand& command) const;
  std::optional<Words> take(int line, const motion::PlanOutcome& outcome, Commanded& commanded);
  bool moves_against_press(const Commanded& commanded) const;
  motion::Pose target_of(const lang::MoveCommand& command) const;
  ToolPathOrWords tool_path(const Commanded& commanded) const;
  std::optional<Words> settle_target(lang::MoveCommand& command) const;
  motion::JointVector near(const lang::MoveCommand& command) const;
  std::optional<motion::FreeTurn> free_turn(const lang::MoveCommand& command) const {
    return free_turn_of(command, surroundings_.frame());
  }
  motion::MotionRequest request_for(int line, const lang::MoveCommand& command,
                                    const Commanded& commanded) const;

  const RobotLinks& links_;
  const Surroundings& surroundings_;
  const PressLine& press_;
  Touching& touching_;
  CornerBefore last_;
  ContactProof proof_;
};

}  // namespace rob::runtime
