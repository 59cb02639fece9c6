#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "motion/path/follow.h"
#include "motion/path/tool_path.h"
#include "motion/plan/carrying_arms.h"
#include "motion/plan/drive_fit.h"
#include "motion/plan/feasibility.h"
#include "motion/plan/last_target.h"
#include "motion/plan/leg_timing.h"
#include "motion/plan/motion_draft.h"
#include "motion/plan/motion_request.h"
#include "motion/plan/path_judge.h"
#include "motion/plan/planned_segment.h"
#include "motion/plan/segment_descriptor.h"
#include "motion/plan/segment_maker.h"
#include "motion/plan/sent_boxes.h"
#include "motion/plan/tool_tip.h"
#include "motion/robots/robot_model.h"
#include "motion/space/pose.h"

namespace rob::motion {

/// Completes and checks motions (S2's "interface part"), and says what the generator needs to know
/// of them: under Paul's law (S1) their time (LegTiming), under the look-ahead law what bounds it
/// (ahead_leg.h).
///
/// Left-out axes keep the last commanded target. A target within kLimitTolerance of the last one on
/// every axis is the last one: a segment of no length, which takes t_B + t_C and passes the target
/// exactly. The tool is the tip that set_tool() names, at first the flange.
///
/// A motion along a ToolPath is looked at along its whole length before it is taken (PathJudge). It
/// is run evenly, as fast as the axes' speeds and accelerations allow everywhere on it.
///
/// SI. Only plan() along a path, and with a zone on an arm, jog() and sends() take memory. One
/// thread, the program's.
class MotionPlanner {
 public:
  /// A motion that takes longer is refused. [choice: 11 days; the generator's clock resolves
  /// 1e-9 s well beyond that]
  static constexpr double kLongest = 1e6;

  /// `start`: where the axes stand.
  MotionPlanner(const RobotModel& robot, const JointVector& start) noexcept;
  MotionPlanner(const MotionPlanner&) = delete;
  MotionPlanner& operator=(const MotionPlanner&) = delete;

  /// How long the leg of a request would be: the way of the tool, m; 0 where it does not move or
  /// the request would be refused.
  double way(const MotionRequest& request) const noexcept;

  /// How far the tip can swing beside the straight line between the ends of the request, m: what
  /// the rotary axes turn, times how far the tip can be from them; 0 where the request would be
  /// refused.
  double swing(const MotionRequest& request) const noexcept;

  /// From here on `tip`, seen from the flange, is the tool.
  void set_tool(const Pose& tip) noexcept { tip_.set(tip); }
  /// Its tip, seen from the flange, and the place of that, m.
  const Pose& tool() const noexcept { return tip_.pose(); }
  const Eigen::Vector3d& tool_tip() const noexcept { return tip_.pose().position; }
  /// From here on the arm carries that; on a robot whose mechanics are not known it makes no
  /// difference.
  void carry(const ArmLoad& load) { mechanics_ = carrying_.with(load); }
  /// Where the tip is at the last target, in the world.
  Pose tool_pose() const noexcept { return tip_.pose_at(last_.q); }

  /// The request as a segment; a refusal leaves everything as it was.
  PlanOutcome plan(const MotionRequest& request);
  /// The same along a path of the tip, which begins at tool_pose(); its target is the path's end.
  /// The planner chooses along the path what the request leaves free: its poses must go on by the
  /// shortest turns that are the same but for that (nearest_turn). The request's own may be of the
  /// gripper alone, which goes there on the way.
  PlanOutcome plan(const MotionRequest& request, const ToolPath& path);

  /// A segment of no length that ends exactly at the last target. None where the axes stand there
  /// anyhow: nothing has moved, or the last motion was exact.
  std::optional<SegmentDescriptor> stop(Tag tag) noexcept;

  /// Motion at these rates, which lasts whole periods; the last target must be exact, or the
  /// motion before a jog, too. Rates too great to be computed with are made smaller, in the same
  /// direction. Until retarget() or stand_at() says where it has led, nothing else can be planned.
  PlanOutcome jog(Tag tag, JogRates rates) noexcept;

  /// A standstill of `duration` s (0: a mark in the buffer) at the last target, which must be
  /// exact: call stop() first.
  SegmentDescriptor dwell(Tag tag, double duration) noexcept;

  /// Override above 1 divides T_user and raises AT from the next segment on, never v_max. Up to
  /// 1 it is the generator's affair and changes nothing here; under the look-ahead law it always
  /// is, but for jogs and profiles.
  void set_override(double share) noexcept { timing_.set_override(share); }

  /// Where the planner is between two motions. While it is kept what is planned after it can be
  /// taken back, as long as none of that is in the buffer.
  using Mark = LastTarget;
  Mark mark() const { return last_; }
  void go_back(const Mark& mark) { last_ = mark; }

  /// Before a segment goes to the generator: what it has boxed is kept as long as it can run.
  void sends(const SegmentDescriptor& segment) { boxes_.keep(segment); }

  const JointVector& commanded() const noexcept { return last_.q; }
  /// Number of the last segment made; 0: none yet. An effect after it carries that.
  std::uint32_t last_number() const noexcept { return last_.number; }
  std::uint32_t generation() const noexcept { return generation_; }
  /// After an early end the axes stand at q, not at the last target. All that is planned from now
  /// on belongs to a new generation.
  void retarget(const JointVector& q) noexcept;
  /// The same, but the motions after number `number` are taken back: what is planned from now on
  /// takes their place.
  void stand_at(const JointVector& q, std::uint32_t number) noexcept;

 private:
  bool brings_gripper(const MotionRequest& request) const noexcept;
  std::array<double, kMaxJoints> absolute(const MotionRequest& request) const noexcept;
  JointVector complete(std::uint8_t given,
                       const std::array<double, kMaxJoints>& wanted) const noexcept;
  PlanOutcome plan_along(const MotionRequest& request, const ToolPath& path);
  Followed axes_along(const MotionRequest& request, const ToolPath& path, bool& alone) const;
  PlanOutcome take(const MotionRequest& request, MotionDraft draft);
  PlanOutcome take_timed(const MotionRequest& request, MotionDraft draft);
  PlanOutcome take_ahead(const MotionRequest& request, MotionDraft draft);
  void leave(const MotionRequest& request, MotionDraft draft, PlannedSegment& planned);
  SegmentDescriptor& commit(Tag tag, SegmentDescriptor& segment) noexcept;

  const RobotModel& robot_;
  CarryingArms carrying_;
  const ArmMechanics* mechanics_;  ///< the robot's, with what it carries; null: not known
  ToolTip tip_;
  LastTarget last_;
  LegTiming timing_;
  SegmentMaker segments_;
  DriveFit drives_;
  PathJudge paths_;
  std::uint32_t generation_ = 1;
  /// Those that segments in the buffer, the running one and the one before it point into.
  std::vector<std::shared_ptr<const PlannedLeg>> kept_;
  std::size_t next_kept_ = 0;
  SentBoxes boxes_;
};

}  // namespace rob::motion
