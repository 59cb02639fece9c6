#pragma once

#include <optional>

#include "motion/path/paced_path.h"
#include "motion/plan/last_target.h"
#include "motion/plan/leg_demand.h"
#include "motion/plan/motion_draft.h"
#include "motion/plan/motion_request.h"
#include "motion/plan/tool_tip.h"
#include "motion/plan/torque_share.h"
#include "motion/robots/robot_model.h"

namespace rob::motion {

/// How long a motion takes under Paul's law (S1), or in a profile. The time of a segment from B to
/// C, whose transitions take 2·t_B and 2·t_C, is
///
///   T1 = max{ |ΔC_i|/v_i,max ; t_B + t_C ; T_user ; what AT asks for }
///
/// where AT bounds the straight distance from end to end of the tool (ToolSpeed), every rotary axis
/// (AngularSpeed), or all axes by a share of their maxima (Share). On a path of the tool it bounds
/// the tool's speed or turning speed along it.
///
/// t_C is the robot's t_acc or what ZONE asks for: a time, a share of the robot's, or for a length
/// z the time after which the tool misses C by z at most, whatever follows, and at most the
/// robot's:
///
///   miss <= 3/16·t_C·|v_out − v_in| (S1's polynomial at t = 0),  so  t_C = 16·z / 3(|v_in| +
///   v_tool,max)
///
/// On an arm a ZONE's t_C counts with the tool's speed at the target, before and after it alike;
/// the corner itself is then made so short that it misses the target by no more.
///
/// A t_C that leaves the axes too little to be held within their limits is raised (least_t_acc). s.
class LegTiming {
 public:
  /// `last`: the target before.
  LegTiming(const RobotModel& robot, const ToolTip& tip, const LastTarget& last);

  /// Above 1 it divides T_user and raises AT, never v_max; up to 1 it changes nothing here.
  void set_override(double share) noexcept { boost_ = share > 1 ? share : 1; }
  double boost() const noexcept { return boost_; }
  /// s; 0 under the look-ahead law.
  double usual_t_acc() const noexcept { return usual_t_acc_; }
  /// 1/s: what a hold may change of the path's rate.
  double braking() const noexcept { return braking_; }

  Timing time(const MotionDraft& draft, const MotionRequest& request) const;
  /// So much slower that gears and drives suffice.
  void slow_down(const TorqueShare& most, const MotionRequest& request, Timing& timing) const;
  /// Under Paul's law the tool goes along a path at an even rate. Where that would take much longer
  /// than what its slowest places cost, it is slowed down at these alone.
  std::optional<PaceLaw> pace(const MotionRequest& request, const LegDemand& demand) const;

 private:
  void time_profile(const MotionDraft& draft, const MotionRequest& request, Timing& timing) const;
  double corner_time(const LegDemand& demand, double duration,
                     const MotionRequest& request) const noexcept;
  double zone_time(double distance, double duration, double zone) const noexcept;
  double arm_zone_time(double leaving, double duration, double zone) const noexcept;

  const RobotModel& robot_;
  const ToolTip& tip_;
  const LastTarget& last_;
  const double usual_t_acc_;
  const double least_t_acc_;
  const double braking_;
  double boost_ = 1;
};

}  // namespace rob::motion
