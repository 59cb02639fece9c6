#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <variant>

#include "motion/plan/feasibility.h"
#include "motion/plan/motion_request.h"
#include "motion/plan/segment_descriptor.h"
#include "motion/robots/robot_model.h"
#include "motion/space/pose.h"

namespace rob::motion {

/// A motion that can be, and what its asker should be told of it.
struct PlannedSegment {
  /// AT asks for more than the axes it names can do; they go as fast as they can.
  static constexpr std::uint8_t kPaceCut = 1;
  /// The axes or the corners need longer than OVER asks; segment.duration is the true time.
  static constexpr std::uint8_t kStretched = 2;
  /// ZONE asks for a tighter corner than the axes can take; segment.t_acc is the least.
  static constexpr std::uint8_t kZoneRaised = 4;

  SegmentDescriptor segment;
  std::uint8_t warnings = 0;  ///< kPaceCut | kStretched | kZoneRaised
};

using PlanOutcome = std::variant<PlannedSegment, Refusal>;

/// Completes, checks and times motions under Paul's law (S1; S2's "interface part").
///
/// Left-out axes keep the last commanded target. The time of a segment from B to C, whose
/// transitions take 2·t_B and 2·t_C, is
///
///   T1 = max{ |ΔC_i|/v_i,max ; t_B + t_C ; T_user ; what AT asks for }
///
/// The tool is the tip that set_tool() names, at first the flange.
///
/// t_C is the robot's t_acc or what ZONE asks for: a time, a share of the robot's, or for a length
/// z the time after which the tool misses C by z at most, whatever follows, and at most the
/// robot's:
///
///   miss <= 3/16·t_C·|v_out − v_in| (S1's polynomial at t = 0),  so  t_C = 16·z / 3(|v_in| +
///   v_tool,max)
///
/// A t_C that leaves the axes too little to be held within their limits is raised (least_t_acc).
///
/// where AT bounds the straight distance from end to end of the tool (ToolSpeed), every rotary axis
/// (AngularSpeed), or all axes by a share of their maxima (Share). A target within
/// kLimitTolerance of the last one on every axis is the last one: a segment of no length, which
/// takes t_B + t_C and passes the target exactly.
///
/// SI. No call throws or takes memory. One thread, the program's.
class MotionPlanner {
 public:
  /// A motion that takes longer is refused. [choice: 11 days; the generator's clock resolves
  /// 1e-9 s well beyond that]
  static constexpr double kLongest = 1e6;

  /// `start`: where the axes stand.
  MotionPlanner(const RobotModel& robot, const JointVector& start) noexcept;

  /// How long the leg of a request would be: the way of the tool, m; 0 where it does not move or
  /// the request would be refused.
  double way(const MotionRequest& request) const noexcept;

  /// How far the tip can swing beside the straight line between the ends of the request, m: what
  /// the rotary axes turn, times how far the tip can be from them; 0 where the request would be
  /// refused.
  double swing(const MotionRequest& request) const noexcept;

  /// From here on `tip`, seen from the flange, is the tool.
  void set_tool(const Pose& tip) noexcept;
  /// The place of its tip, m, seen from the flange.
  const Eigen::Vector3d& tool_tip() const noexcept { return tip_; }

  /// The request as a segment; a refusal leaves everything as it was.
  PlanOutcome plan(const MotionRequest& request) noexcept;

  /// A segment of no length that ends exactly at the last target. None where the axes stand there
  /// anyhow: nothing has moved, or the last motion was exact.
  std::optional<SegmentDescriptor> stop(Tag tag) noexcept;

  /// Motion at these rates, which lasts whole periods; the last target has to be exact, or the
  /// motion before a jog, too. Rates too great to be computed with are made smaller, in the same
  /// direction. Until retarget() or stand_at() says where it has led, nothing else can be planned.
  PlanOutcome jog(Tag tag, JogRates rates) noexcept;

  /// A standstill of `duration` s (0: a mark in the buffer) at the last target, which has to be
  /// exact: call stop() first.
  SegmentDescriptor dwell(Tag tag, double duration) noexcept;

  /// Override above 1 divides T_user and raises AT from the next segment on, never v_max. Up to
  /// 1 it is the generator's affair and changes nothing here.
  void set_override(double share) noexcept { boost_ = share > 1 ? share : 1; }

  const JointVector& commanded() const noexcept { return commanded_; }
  /// Number of the last segment made; 0: none yet. What an effect behind it carries.
  std::uint32_t last_number() const noexcept { return number_; }
  std::uint32_t generation() const noexcept { return generation_; }
  /// After an early end the axes stand at q, not at the last target. What is planned from now on
  /// belongs to a new generation.
  void retarget(const JointVector& q) noexcept;
  /// The same, but the motions behind number `number` are taken back: what is planned from now on
  /// takes their place.
  void stand_at(const JointVector& q, std::uint32_t number) noexcept;

 private:
  struct Timing {
    double duration = 0;
    double t_acc = 0;
    std::uint8_t limit = 0;
    std::uint8_t warnings = 0;
  };

  std::array<double, kMaxJoints> absolute(const MotionRequest& request) const noexcept;
  JointVector complete(std::uint8_t given,
                       const std::array<double, kMaxJoints>& wanted) const noexcept;
  Timing time(const JointVector& target, const MotionRequest& request) const noexcept;
  double corner_time(double distance, double duration, const MotionRequest& request) const noexcept;
  double zone_time(double distance, double duration, double zone) const noexcept;
  Eigen::Vector3d tip(const JointVector& q) const noexcept;
  double tool_distance(const JointVector& target) const noexcept;
  double swing_to(const JointVector& target) const noexcept;
  double greatest_way(const JointVector& target) const noexcept;
  double pace_time(const JointVector& delta, const JointVector& target,
                   const MotionRequest& request) const noexcept;
  double named_axes_time(const JointVector& delta, MotionRequest::Pace pace) const noexcept;
  SegmentDescriptor commit(Tag tag, const JointVector& target, bool no_length,
                           const Timing& timing) noexcept;

  const RobotModel& robot_;
  const double least_t_acc_;
  const double linear_speed_;  ///< the greatest that the linear axes make together
  double tool_speed_;          ///< the same with what the rotary axes make of the tool
  Eigen::Vector3d tip_ = Eigen::Vector3d::Zero();  ///< of the tool, seen from the flange
  JointVector arms_;  ///< how far the tip can be from the rotary axes, m; 0 of linear ones
  JointVector commanded_;
  double t_acc_before_;  ///< t_B of the next segment
  bool exact_ = true;    ///< the last target is reached exactly
  std::uint32_t number_ = 0;
  std::uint32_t generation_ = 1;
  double boost_ = 1;
};

}  // namespace rob::motion
