#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "motion/path/follow.h"
#include "motion/path/tool_path.h"
#include "motion/plan/carrying_arms.h"
#include "motion/plan/feasibility.h"
#include "motion/plan/leg_demand.h"
#include "motion/plan/motion_request.h"
#include "motion/plan/planned_segment.h"
#include "motion/plan/segment_descriptor.h"
#include "motion/plan/sent_boxes.h"
#include "motion/plan/torque_share.h"
#include "motion/robots/robot_model.h"
#include "motion/space/pose.h"

namespace rob::motion {

/// Completes and checks motions (S2's "interface part"), and says what the generator needs to know
/// of them: under Paul's law (S1) their time, under the look-ahead law what bounds it
/// (ahead_leg.h).
///
/// Left-out axes keep the last commanded target. Under Paul's law the time of a segment from B to
/// C, whose transitions take 2·t_B and 2·t_C, is
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
/// On a robot whose mechanics are known T1 is raised until its gears and drives suffice all along
/// (torque_share.h); a corner that asks too much of them all the same becomes exact.
///
/// A t_C that leaves the axes too little to be held within their limits is raised (least_t_acc).
///
/// where AT bounds the straight distance from end to end of the tool (ToolSpeed), every rotary axis
/// (AngularSpeed), or all axes by a share of their maxima (Share). On a path of the tool it bounds
/// the tool's speed or turning speed along it. A target within
/// kLimitTolerance of the last one on every axis is the last one: a segment of no length, which
/// takes t_B + t_C and passes the target exactly.
///
/// A motion along a ToolPath is looked at along its whole length before it is taken (follow.h):
/// reach, the axes' limits, places where they would have to turn too fast. It is run evenly, as
/// fast as the axes' speeds and accelerations allow everywhere on it. Corners into and out of it
/// are made here (corner.h); where there is none, and before a PROFILE, the motion begins at rest.
///
/// On an arm a ZONE's t_C counts with the tool's speed at the target, before and behind it alike;
/// the corner itself is then made so short that it misses the target by no more.
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

  /// How long the leg of a request would be: the way of the tool, m; 0 where it does not move or
  /// the request would be refused.
  double way(const MotionRequest& request) const noexcept;

  /// How far the tip can swing beside the straight line between the ends of the request, m: what
  /// the rotary axes turn, times how far the tip can be from them; 0 where the request would be
  /// refused.
  double swing(const MotionRequest& request) const noexcept;

  /// From here on `tip`, seen from the flange, is the tool.
  void set_tool(const Pose& tip) noexcept;
  /// Its tip, seen from the flange, and the place of that, m.
  const Pose& tool() const noexcept { return tool_; }
  const Eigen::Vector3d& tool_tip() const noexcept { return tool_.position; }
  /// From here on the arm carries that; on a robot whose mechanics are not known it makes no
  /// difference.
  void carry(const ArmLoad& load) { mechanics_ = carrying_.with(load); }
  /// Where the tip is at the last target, in the world.
  Pose tool_pose() const noexcept;

  /// The request as a segment; a refusal leaves everything as it was.
  PlanOutcome plan(const MotionRequest& request);
  /// The same along a path of the tip, which begins at tool_pose(); its target is the path's end.
  PlanOutcome plan(const MotionRequest& request, const ToolPath& path);

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
  /// 1 it is the generator's affair and changes nothing here; under the look-ahead law it always
  /// is, but for jogs and profiles.
  void set_override(double share) noexcept { boost_ = share > 1 ? share : 1; }

  /// Where the planner is between two motions. While it is kept what is planned behind it can be
  /// taken back, as long as none of that is in the buffer.
  class Mark;
  Mark mark() const;
  void go_back(const Mark& mark);

  /// Before a segment goes to the generator: what it has boxed is kept as long as it can run.
  void sends(const SegmentDescriptor& segment) { boxes_.keep(segment); }

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
    ProfileLaw profile{};
  };
  /// A motion in the making.
  struct Draft {
    JointVector target;
    bool no_length = false;
    LegDemand demand{};
    std::shared_ptr<PlannedLeg> leg{};  ///< null: straight in the axes, and S1's corner
    PaceCut pace_cut{};
  };
  /// The motion before, where a corner can lead out of it.
  struct Before {
    LegMotion motion;
    std::shared_ptr<const PlannedLeg> leg;
    Pose tool;
    double zone = std::numeric_limits<double>::infinity();  ///< m
    Tag tag = 0;
  };

  std::array<double, kMaxJoints> absolute(const MotionRequest& request) const noexcept;
  JointVector complete(std::uint8_t given,
                       const std::array<double, kMaxJoints>& wanted) const noexcept;
  Eigen::Vector3d tip(const JointVector& q) const noexcept;
  PlanOutcome take(const MotionRequest& request, Draft draft);
  PlanOutcome take_timed(const MotionRequest& request, Draft draft);
  SegmentDescriptor segment_to(const JointVector& target, bool no_length,
                               const Timing& timing) const noexcept;
  SegmentDescriptor& commit(Tag tag, SegmentDescriptor& segment) noexcept;

  // How long it takes (motion_planner_timing.cpp)
  LegDemand straight_demand(const JointVector& target) const noexcept;
  Timing time(const Draft& draft, const MotionRequest& request) const;
  void time_profile(const Draft& draft, const MotionRequest& request, Timing& timing) const;
  double corner_time(const LegDemand& demand, double duration,
                     const MotionRequest& request) const noexcept;
  double zone_time(double distance, double duration, double zone) const noexcept;
  double arm_zone_time(double leaving, double duration, double zone) const noexcept;
  double tool_distance(const JointVector& target) const noexcept;
  double leaving_speed(const JointVector& target) const noexcept;
  double swing_to(const JointVector& target) const noexcept;
  double greatest_way(const JointVector& target) const noexcept;

  // Under the look-ahead law (motion_planner_ahead.cpp)
  PlanOutcome take_ahead(const MotionRequest& request, Draft draft);
  std::optional<Refusal> too_heavy(const Draft& draft) const;
  void judge_zone(const Draft& draft, PlannedSegment& planned) const;
  void measure_swing(const JointVector& target, LegDemand& demand) const;

  // Gears and drives (motion_planner_drives.cpp)
  void suit_drives(Draft& draft, const MotionRequest& request, Timing& timing) const;
  void slow_down(Timing& timing, const TorqueShare& most, const MotionRequest& request) const;
  TorqueShare demanded_alone(const SegmentDescriptor& segment) const;
  TorqueShare demanded_by_corner(const SegmentDescriptor& segment) const;

  // Paths and corners (motion_planner_paths.cpp)
  std::optional<Refusal> judge(const MotionRequest& request, const ToolPath& path,
                               const Followed& followed) const;
  Refusal refusal_for(const PathTrouble& trouble, const ToolPath& path,
                      const JointPath& axes) const;
  std::optional<Refusal> too_slow(const MotionRequest& request, const ToolPath& path,
                                  const JointPath& axes) const;
  std::optional<PaceLaw> pace(const MotionRequest& request, const LegDemand& demand) const;
  Refusal placed(Refusal refusal, const ToolPath& path) const;
  bool reachable_otherwise(const ToolPath& path) const;
  SegmentDescriptor joined(Draft& draft, const Timing& timing, std::uint8_t& warnings) const;
  void join(Draft& draft, SegmentDescriptor& segment, std::uint8_t& warnings) const;
  void keep(std::shared_ptr<const PlannedLeg> leg);

  const RobotModel& robot_;
  CarryingArms carrying_;
  const ArmMechanics* mechanics_;  ///< the robot's, with what it carries; null: not known
  const double usual_t_acc_;       ///< s; 0 under the look-ahead law
  const double least_t_acc_;
  const double braking_;       ///< 1/s: what a hold may change of the path's rate
  const double linear_speed_;  ///< the greatest that the linear axes make together
  double tool_speed_;          ///< the same with what the rotary axes make of the tool
  Pose tool_;                  ///< its tip, seen from the flange
  JointVector arms_;           ///< how far the tip can be from the rotary axes, m; 0 of linear ones
  JointVector commanded_;
  double t_acc_before_ = usual_t_acc_;  ///< t_B of the next segment
  bool exact_ = true;                   ///< the last target is reached exactly
  Before before_;                       ///< only where it is not
  std::uint32_t number_ = 0;
  std::uint32_t generation_ = 1;
  double boost_ = 1;
  /// Those that segments in the buffer, the running one and the one before it point into.
  std::vector<std::shared_ptr<const PlannedLeg>> kept_;
  std::size_t next_kept_ = 0;
  SentBoxes boxes_;
};

class MotionPlanner::Mark {
  friend class MotionPlanner;
  JointVector commanded_;
  double t_acc_before_ = 0;
  bool exact_ = true;
  Before before_;
  std::uint32_t number_ = 0;
};

}  // namespace rob::motion
