#pragma once

#include <optional>

#include "motion/path/joint_path.h"
#include "motion/path/tool_path.h"
#include "motion/plan/feasibility.h"
#include "motion/plan/motion_request.h"
#include "motion/robots/robot_model.h"

namespace rob::motion {

/// The demand of a leg on the axes, per unit of its parameter 0 … 1. m, rad.
struct LegDemand {
  JointVector rates;                 ///< the greatest |dq/ds| of each axis
  double way = 0;                    ///< of the tip: straight, or along its path
  double turn = 0;                   ///< of the tool along its path, or of the axis that turns most
  double pace_way = 0;               ///< its greatest speed
  double pace_turn = 0;              ///< the greatest turning speed that AT bounds
  double farthest = 0;               ///< the most that the tip can cover
  double leaving = 0;                ///< the tip's speed at the end
  const JointPath* path = nullptr;   ///< null: straight in the axes
  const ToolPath* uneven = nullptr;  ///< a path whose parameter does not say how fast the tool is
  double first_point = 1;            ///< of the path, between its ends, that must be met
  double last_point = 0;
};

/// m, rad: two poses that differ by less are one.
inline constexpr double kSamePose = 1e-9;

/// The demand on the axes along a path of the tool.
LegDemand demand_along(const ToolPath& path, const JointPath& axes);

/// The greatest |dq/ds| of each axis along a path.
JointVector greatest_rates(const JointPath& axes);

/// The first place where an axis is beyond its limits; its parameter is Refusal::at.
std::optional<Refusal> first_beyond(const RobotModel& robot, const JointPath& axes);

/// Where the axes allow the least share of the tool's speed: of what is asked for, or, where that
/// is less, of the most that they allow anywhere on the path. On a spline the parameter does not
/// say how fast the tool moves: it may nearly stand where its way turns back.
struct Slowest {
  double at = 0;
  int axis = -1;
  double share = 1;
};
/// `asked`: 1/s of the parameter, infinite without any.
Slowest slowest_place(const RobotModel& robot, const ToolPath& path, const JointPath& axes,
                      double asked);

/// Where on a way of the tool an axis does not permit what AT asks for. m, or rad where the tool
/// only turns.
struct PaceCut {
  int axis = -1;  ///< the slowest; −1: there is no such place
  double from = 0;
  double to = 0;
  double way = 0;
  bool turning = false;
  double asked = 0;   ///< s that the motion would take
  double longer = 0;  ///< s that it takes beyond that; 0 where that is not known yet
};
/// `asked`: s for all of the path, 0 without AT.
PaceCut pace_cut(const RobotModel& robot, const ToolPath& path, const JointPath& axes,
                 double asked);

/// The greatest speed, acceleration and jerk of a parameter, per s, which the axes can follow in a
/// profile while its time is also changed by as much as `change`, 1/s. On a path half of their
/// acceleration is left to its bends [choice: so that the other half speeds the motion up].
struct ProfileLimits {
  double rate = 0;
  double acceleration = 0;
  double jerk = 0;  ///< the axes' own; a profile keeps it where JERK asks for a share of it
};
ProfileLimits profile_limits(const RobotModel& robot, const JointVector& straight, double change);
ProfileLimits profile_limits(const RobotModel& robot, const JointPath& axes, double change);

/// The least time, s, for a path run evenly, with the axes within a_max while the path's time is
/// also sped up or slowed down by as much as `change`, 1/s: |q_ss|/T² + |q_s|·change/T <= a_max.
double least_time(const RobotModel& robot, const JointPath& axes, double change, int& axis);

/// The least time, s, that what AT asks for leaves; 0 without it.
double pace_time(const RobotModel& robot, const LegDemand& demand,
                 const MotionRequest& request) noexcept;
/// s that a LivePace of 1 takes; 0 where that bounds nothing.
double live_unit_time(const RobotModel& robot, const LegDemand& demand,
                      const MotionRequest& request) noexcept;
/// The least time of the axes that a pace speaks of: the linear ones for a tool speed, the rotary
/// ones for an angular speed, all for a share and on a path.
double named_axes_time(const RobotModel& robot, const LegDemand& demand,
                       MotionRequest::Pace pace) noexcept;

}  // namespace rob::motion
