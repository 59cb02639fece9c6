#include "motion/plan/ahead_leg.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "motion/plan/planned_segment.h"

namespace rob::motion {

namespace {

using Bound = MotionRequest::Bound;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNoWay = 1e-9;  // m, rad: less is none
/// Relative difference below which two numbers are the same: what is known of a path's rates.
constexpr double kSame = 1e-5;
/// [choice] an axis turns by at most 5° in a piece.
constexpr int kParts = 8;

/// s: up to here every motion has the axes' full acceleration, so that neighbours have one mean.
/// [choice] with 0.1 s a motion of 100 mm/s and 10,000 mm/s³ has just what it can use.
constexpr double kUsualWindow = 0.1;

/// The same where it is the robot's own jerk that asks for it. [choice] more than any of the
/// robots.
constexpr double kOwnWindow = 0.25;

double length_of(const LegDemand& demand) {
  return demand.way > kNoWay ? demand.way : demand.turn * kPerRadian;
}

/// The rates and accelerations that the axes can give a leg: shares of its length, at the places
/// where they give most.
struct AxesGive {
  double most_rate = 0;          ///< 1/s
  double most_acceleration = 0;  ///< 1/s², without bends
  ToolSpeed acceleration;        ///< m/s², rad/s²: the same of what bounds speak of
  double duration = 0;           ///< s from end to end
};

/// How fast the tool is at s, and the leg's length passes by, per unit of s.
struct Passing {
  ToolSpeed tool;
  double share = 1;
};

Passing passing(const LegDemand& demand, double s) {
  if (demand.uneven == nullptr) return {{demand.pace_way, demand.pace_turn}, 1};
  const ToolSpeed tool = speed_at(*demand.uneven, s);
  return {tool, demand.way > kNoWay ? tool.way / demand.way : tool.turn / demand.turn};
}

/// `slowest`: s for the whole leg at the speed that AT and OVER ask for; 0 without them.
AxesGive axes_give(const RobotModel& robot, const LegDemand& demand, double slowest) {
  AxesGive give;
  double before = 0;
  double last = 0;
  const auto look = [&](double s, const JointVector& rates) {
    double time = 0;  // s per unit
    double pull = 0;  // s² per unit
    for (int i = 0; i < robot.axis_count(); ++i) {
      const Axis& axis = robot.axes[static_cast<std::size_t>(i)];
      time = std::max(time, std::abs(rates[i]) / axis.v_max);
      pull = std::max(pull, std::abs(rates[i]) / axis.a_max);
    }
    const Passing passed = passing(demand, s);
    if (time > 0) give.most_rate = std::max(give.most_rate, passed.share / time);
    if (pull > 0) {
      give.most_acceleration = std::max(give.most_acceleration, passed.share / pull);
      give.acceleration.way = std::max(give.acceleration.way, passed.tool.way / pull);
      give.acceleration.turn = std::max(give.acceleration.turn, passed.tool.turn / pull);
    }
    const double here = std::max(time, slowest);
    give.duration += (s - before) * (here + last) / 2;
    before = s;
    last = here;
  };
  if (demand.path == nullptr) {
    look(0, demand.rates);
    look(1, demand.rates);
  } else {
    demand.path->survey(kParts, [&](double s, const PathPoint& point) { look(s, point.qd); });
  }
  return give;
}

/// The acceleration that the axes can give to the subject of a bound; 0 where that does not move.
double given_to(Bound bound, const AxesGive& give) {
  return bound == Bound::Tool     ? give.acceleration.way
         : bound == Bound::Rotary ? give.acceleration.turn
         : bound == Bound::Share  ? 1
                                  : 0;
}

/// The windows, s, that jerk needs for accelerations of a_max: what the axes ask for, and JERK.
struct Windows {
  double axes = 0;
  double asked = 0;
};

Windows windows(const RobotModel& robot, const LegDemand& demand, const MotionRequest& request,
                const AxesGive& give) {
  Windows need;
  bool named = false;
  for (const Axis& axis : robot.axes) {
    need.axes = std::max(need.axes, 2 * axis.a_max / axis.j_max);
    // The axes of a tool's path follow from it: they are bounded with it, not one by one.
    const bool follows = robot.tool_coordinates && demand.path != nullptr;
    const auto kind = request.jerk == Bound::Tool ? AxisKind::Linear : AxisKind::Rotary;
    const bool whole = request.jerk == Bound::Unspecified || request.jerk == Bound::Share;
    if (whole || axis.kind != kind || follows) continue;
    named = true;
    need.asked = std::max(need.asked, 2 * axis.a_max / request.jerk_value);
  }
  if (request.jerk == Bound::Share) need.asked = need.axes / request.jerk_value;
  if (request.jerk == Bound::Unspecified || request.jerk == Bound::Share || named) return need;
  need.asked = 2 * given_to(request.jerk, give) / request.jerk_value;
  return need;
}

}  // namespace

void bound_corner(const RobotModel& robot, const MotionRequest& request, double speed,
                  LegBounds& bounds) {
  bounds.turn = request.zone_angle > 0 ? request.zone_angle : robot.zone.angle;
  switch (request.zone) {
    case MotionRequest::Zone::Unspecified:
      bounds.miss = robot.zone.distance;
      return;
    case MotionRequest::Zone::Length:
      bounds.miss = request.zone_value;
      return;
    case MotionRequest::Zone::Time:
      bounds.lead = speed * request.zone_value;
      return;
    case MotionRequest::Zone::Share:
      bounds.share = std::min(request.zone_value, 1.0);
      return;
  }
}

AheadLeg ahead_leg(const RobotModel& robot, const LegDemand& demand, const MotionRequest& request) {
  AheadLeg leg;
  LegBounds& bounds = leg.bounds;
  bounds.length = length_of(demand);
  bounds.first = demand.first_point * bounds.length;
  bounds.last = (1 - demand.last_point) * bounds.length;
  const double paced = pace_time(robot, demand, request);
  const double asked = std::max(paced, request.at_least);
  bounds.paced = asked > 0;
  if (bounds.paced) bounds.speed = bounds.length / asked;
  const double sure = demand.path == nullptr ? 1 : 1 - kSame;
  if (named_axes_time(robot, demand, request.pace) * sure > paced * (1 + kSame))
    leg.warnings |= PlannedSegment::kPaceCut;
  const AxesGive give = axes_give(robot, demand, asked);
  leg.duration = give.duration;
  if (request.at_least > 0 && axes_give(robot, demand, 0).duration > request.at_least * (1 + kSame))
    leg.warnings |= PlannedSegment::kStretched;

  if (const double given = given_to(request.accel, give); given > 0) {
    const double share = request.accel_value / given;
    if (share > 1 + kSame) leg.warnings |= PlannedSegment::kBoundCut;
    bounds.full = bounds.acceleration = std::min(share, 1.0);
  }
  const Windows need = windows(robot, demand, request, give);
  if (request.jerk != Bound::Unspecified && need.asked > 0 && need.asked < need.axes * (1 - kSame))
    leg.warnings |= PlannedSegment::kBoundCut;
  const double top = std::min(give.most_rate, asked > 0 ? 1 / asked : kInfinity);
  if (const double window = std::max(need.axes, need.asked); window > 0) {
    const double useful = std::sqrt(top / (2 * give.most_acceleration * window));
    const double usual = std::max(kUsualWindow, std::min(need.axes, kOwnWindow));
    const double longest = std::min(kLongestWindow, kMostPeriods * robot.reference_period);
    bounds.acceleration =
        std::min({bounds.acceleration, std::max(useful, usual / window), longest / window});
    bounds.window = window * bounds.acceleration;
  }
  const double acceleration = bounds.acceleration * give.most_acceleration;
  leg.alone = std::max({leg.duration, 2 / std::sqrt(acceleration), 1 / top + top / acceleration});
  bound_corner(robot, request, top * bounds.length, bounds);
  return leg;
}

}  // namespace rob::motion
