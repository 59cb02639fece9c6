#include <algorithm>
#include <cmath>
#include <limits>

#include "motion/plan/motion_planner.h"

/// Member functions of MotionPlanner that calculate the time of a motion.
namespace rob::motion {

namespace {

/// Relative difference below which two times are the same: rounding of a few operations.
constexpr double kSameTime = 1e-9;

bool longer(double time, double than) { return time > than * (1 + kSameTime); }

}  // namespace

LegDemand MotionPlanner::straight_demand(const JointVector& target) const noexcept {
  LegDemand demand;
  demand.rates = (target - commanded_).cwiseAbs();
  demand.way = demand.pace_way = tool_distance(target);
  for (int i = 0; i < robot_.axis_count(); ++i) {
    if (robot_.axes[static_cast<std::size_t>(i)].kind == AxisKind::Rotary)
      demand.pace_turn = std::max(demand.pace_turn, demand.rates[i]);
  }
  demand.turn = demand.pace_turn;
  demand.farthest = greatest_way(target);
  demand.leaving = leaving_speed(target);
  return demand;
}

MotionPlanner::Timing MotionPlanner::time(const Draft& draft, const MotionRequest& request) const {
  const LegDemand& demand = draft.demand;
  Timing timing;
  for (int i = 0; i < robot_.axis_count(); ++i) {
    const double needed = demand.rates[i] / robot_.axes[static_cast<std::size_t>(i)].v_max;
    if (needed <= timing.duration) continue;
    timing.duration = needed;
    timing.limit = static_cast<std::uint8_t>(2 + i);
  }
  const double slowest = timing.duration;
  const double paced = pace_time(robot_, demand, request);
  // The rates along a path are known to a millionth.
  const double sure = demand.path == nullptr ? 1 : 1 - 1e-5;
  if (longer(named_axes_time(robot_, demand, request.pace) * sure, paced))
    timing.warnings |= PlannedSegment::kPaceCut;
  if (longer(paced / boost_, timing.duration)) timing.limit = 1;
  timing.duration = std::max(timing.duration, paced / boost_);
  if (request.profile != ProfileShape::None && !draft.no_length) {
    time_profile(draft, request, timing);
    return timing;
  }

  const double asked = std::max(timing.duration, request.at_least / boost_);
  timing.t_acc = corner_time(demand, asked, request);
  if (timing.t_acc < least_t_acc_) {
    timing.t_acc = least_t_acc_;
    timing.warnings |= PlannedSegment::kZoneRaised;
  }
  const double corners = t_acc_before_ + timing.t_acc;
  if (request.at_least > 0 && longer(std::max(slowest, corners), request.at_least))
    timing.warnings |= PlannedSegment::kStretched;
  if (const double other = std::max(corners, request.at_least / boost_); other > timing.duration) {
    timing.duration = other;
    timing.limit = 0;
  }
  if (demand.path == nullptr) return timing;
  // S1's ramps from and to rest change the path's rate by up to 0.75/t.
  const double change = 0.75 / std::min(t_acc_before_, timing.t_acc) + braking_;
  int axis = 0;
  if (const double needed = least_time(robot_, *demand.path, change, axis);
      needed > timing.duration) {
    timing.duration = needed;
    timing.limit = static_cast<std::uint8_t>(10 + axis);
  }
  return timing;
}

/// From rest to rest with what AT and the axes' speeds leave; timing.duration is 1/rate so far.
void MotionPlanner::time_profile(const Draft& draft, const MotionRequest& request,
                                 Timing& timing) const {
  const JointPath* const path = draft.demand.path;
  ProfileLimits limits = path == nullptr ? profile_limits(robot_, draft.demand.rates, braking_)
                                         : profile_limits(robot_, *path, braking_);
  const auto bounded = [&](MotionRequest::Bound bound, double value) {
    const double per_share = bound == MotionRequest::Bound::Tool     ? draft.demand.pace_way
                             : bound == MotionRequest::Bound::Rotary ? draft.demand.pace_turn
                                                                     : 0;
    return per_share > 0 ? value / per_share : std::numeric_limits<double>::infinity();
  };
  limits.acceleration = std::min(limits.acceleration, bounded(request.accel, request.accel_value));
  const double rate = std::min(limits.rate, 1 / timing.duration);
  const double asked = request.at_least / boost_;
  const double jerk = bounded(request.jerk, request.jerk_value);
  const auto law = [&](double most_rate, double at_least) {
    return ProfileLaw::within_jerk(request.profile, most_rate, limits.acceleration, jerk, at_least);
  };
  timing.profile = law(rate, asked);
  timing.duration = timing.profile.duration();
  timing.t_acc = usual_t_acc_;
  // What AT adds is no surprise.
  if (request.at_least > 0 && longer(law(limits.rate, 0).duration() * boost_, request.at_least))
    timing.warnings |= PlannedSegment::kStretched;
}

/// t_C as the request asks for it; `duration`: of the motion, corners apart.
double MotionPlanner::corner_time(const LegDemand& demand, double duration,
                                  const MotionRequest& request) const noexcept {
  switch (request.zone) {
    case MotionRequest::Zone::Robots:
      return usual_t_acc_;
    case MotionRequest::Zone::Length:
      return std::min(usual_t_acc_,
                      robot_.tool_coordinates
                          ? arm_zone_time(demand.leaving, duration, request.zone_value)
                          : zone_time(demand.farthest, duration, request.zone_value));
    case MotionRequest::Zone::Time:
      return request.zone_value;
    case MotionRequest::Zone::Share:
      return request.zone_value * usual_t_acc_;
  }
  return usual_t_acc_;
}

/// t = K/(v_in + V) with K = 16·z/3. Where the motion lasts as long as its corners, v_in = d/(t_B +
/// t) and t is the root of V·t² + (d + V·t_B − K)·t − K·t_B = 0.
double MotionPlanner::zone_time(double distance, double duration, double zone) const noexcept {
  const double k = 16 * zone / 3;
  const double v = tool_speed_;
  if (duration > 0) {
    const double t = k / (distance / duration + v);
    if (t_acc_before_ + t <= duration) return t;
  }
  const double half = (distance + v * t_acc_before_ - k) / (2 * v);
  return std::sqrt(half * half + k * t_acc_before_ / v) - half;
}

/// t = K/2v with v the tip's speed at the target, the same before and after it. Where the motion
/// lasts as long as its corners, v = d/(t_B + t), so t = K·t_B/(2d − K). The corner is made when
/// both speeds are known, and may be shorter then; never is it too short for the axes here.
double MotionPlanner::arm_zone_time(double leaving, double duration, double zone) const noexcept {
  const double k = 16 * zone / 3;
  if (!(leaving > 0)) return usual_t_acc_;
  double t = k * duration / (2 * leaving);
  if (t_acc_before_ + t > duration)
    t = 2 * leaving > k ? k * t_acc_before_ / (2 * leaving - k) : usual_t_acc_;
  return std::max(t, least_t_acc_);
}

/// The tip's, per unit of the leg.
double MotionPlanner::leaving_speed(const JointVector& target) const noexcept {
  constexpr double kStep = 1e-5;  // of the leg: the error is as small beside the speed
  const JointVector before = target - kStep * (target - commanded_);
  return (tip(target) - tip(before)).norm() / kStep;
}

double MotionPlanner::tool_distance(const JointVector& target) const noexcept {
  return (tip(target) - tip(commanded_)).norm();
}

double MotionPlanner::swing_to(const JointVector& target) const noexcept {
  return arms_.dot((target - commanded_).cwiseAbs());
}

/// What the tip covers at most: the way of the linear axes, and what it swings around the others.
double MotionPlanner::greatest_way(const JointVector& target) const noexcept {
  double squares = 0;
  for (int i = 0; i < robot_.axis_count(); ++i) {
    const double way = target[i] - commanded_[i];
    if (robot_.axes[static_cast<std::size_t>(i)].kind == AxisKind::Linear) squares += way * way;
  }
  return std::sqrt(squares) + swing_to(target);
}

}  // namespace rob::motion
