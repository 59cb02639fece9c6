#include "motion/plan/leg_timing.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "motion/plan/local_pace.h"
#include "motion/plan/planned_segment.h"
#include "motion/robots/time_scaling.h"

namespace rob::motion {

namespace {

/// Relative difference below which two times are the same: rounding of a few operations.
constexpr double kSameTime = 1e-9;

bool longer(double time, double than) { return time > than * (1 + kSameTime); }

/// [choice] A path gets a pace for each place where an even rate takes so many times as long. With
/// AT that is soon, since AT is kept elsewhere; without AT an ordinary line keeps an even rate.
constexpr double kWorthWithPace = 1.05;
constexpr double kWorthFree = 1.5;

}  // namespace

LegTiming::LegTiming(const RobotModel& robot, const ToolTip& tip, const LastTarget& last)
    : robot_(robot),
      tip_(tip),
      last_(last),
      usual_t_acc_(robot.law == Law::Paul ? robot.t_acc : 0),
      least_t_acc_(least_t_acc(robot)),
      braking_(time_scale_limits(robot).slope) {}

Timing LegTiming::time(const MotionDraft& draft, const MotionRequest& request) const {
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
  if (request.profile != Profile::Unspecified && !draft.no_length) {
    time_profile(draft, request, timing);
    return timing;
  }

  const double asked = std::max(timing.duration, request.at_least / boost_);
  timing.t_acc = corner_time(demand, asked, request);
  if (timing.t_acc < least_t_acc_) {
    timing.t_acc = least_t_acc_;
    timing.warnings |= PlannedSegment::kZoneRaised;
  }
  const double corners = last_.t_acc + timing.t_acc;
  if (request.at_least > 0 && longer(std::max(slowest, corners), request.at_least))
    timing.warnings |= PlannedSegment::kStretched;
  if (const double other = std::max(corners, request.at_least / boost_); other > timing.duration) {
    timing.duration = other;
    timing.limit = 0;
  }
  if (demand.path == nullptr) return timing;
  // S1's ramps from and to rest change the path's rate by up to 0.75/t.
  const double change = 0.75 / std::min(last_.t_acc, timing.t_acc) + braking_;
  int axis = 0;
  if (const double needed = least_time(robot_, *demand.path, change, axis);
      needed > timing.duration) {
    timing.duration = needed;
    timing.limit = static_cast<std::uint8_t>(10 + axis);
  }
  return timing;
}

/// From rest to rest with what AT and the axes' speeds leave; timing.duration is 1/rate so far.
void LegTiming::time_profile(const MotionDraft& draft, const MotionRequest& request,
                             Timing& timing) const {
  const JointPath* const path = draft.demand.path;
  ProfileLimits limits = path == nullptr ? profile_limits(robot_, draft.demand.rates, braking_)
                                         : profile_limits(robot_, *path, braking_);
  const auto bounded = [&](MotionRequest::Bound bound, double value, double own) {
    if (bound == MotionRequest::Bound::Share) return value * own;
    const double per_share = bound == MotionRequest::Bound::Tool     ? draft.demand.pace_way
                             : bound == MotionRequest::Bound::Rotary ? draft.demand.pace_turn
                                                                     : 0;
    return per_share > 0 ? value / per_share : std::numeric_limits<double>::infinity();
  };
  limits.acceleration = std::min(limits.acceleration,
                                 bounded(request.accel, request.accel_value, limits.acceleration));
  const double rate = std::min(limits.rate, 1 / timing.duration);
  const double asked = request.at_least / boost_;
  const double jerk = bounded(request.jerk, request.jerk_value, limits.jerk);
  const auto law = [&](double most_rate, double at_least) {
    return ProfileLaw::within_jerk(request.profile, most_rate, limits.acceleration, jerk, at_least);
  };
  timing.profile = law(rate, asked);
  timing.duration = timing.profile.duration();
  timing.t_acc = usual_t_acc_;
  // The time that AT adds is no surprise.
  if (request.at_least > 0 && longer(law(limits.rate, 0).duration() * boost_, request.at_least))
    timing.warnings |= PlannedSegment::kStretched;
}

/// t_C as the request asks for it; `duration`: of the motion, corners apart.
double LegTiming::corner_time(const LegDemand& demand, double duration,
                              const MotionRequest& request) const noexcept {
  switch (request.zone) {
    case MotionRequest::Zone::Unspecified:
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
double LegTiming::zone_time(double distance, double duration, double zone) const noexcept {
  const double k = 16 * zone / 3;
  const double v = tip_.greatest_speed();
  if (duration > 0) {
    const double t = k / (distance / duration + v);
    if (last_.t_acc + t <= duration) return t;
  }
  const double half = (distance + v * last_.t_acc - k) / (2 * v);
  return std::sqrt(half * half + k * last_.t_acc / v) - half;
}

/// t = K/2v with v the tip's speed at the target, the same before and after it. Where the motion
/// lasts as long as its corners, v = d/(t_B + t), so t = K·t_B/(2d − K). The corner is made when
/// both speeds are known, and may be shorter then; never is it too short for the axes here.
double LegTiming::arm_zone_time(double leaving, double duration, double zone) const noexcept {
  const double k = 16 * zone / 3;
  if (!(leaving > 0)) return usual_t_acc_;
  double t = k * duration / (2 * leaving);
  if (last_.t_acc + t > duration)
    t = 2 * leaving > k ? k * last_.t_acc / (2 * leaving - k) : usual_t_acc_;
  return std::max(t, least_t_acc_);
}

void LegTiming::slow_down(const TorqueShare& most, const MotionRequest& request,
                          Timing& timing) const {
  // The accelerations of a profile go down with the square of its speed.
  const double share = timing.profile.present() ? std::sqrt(most.speed) : most.speed;
  timing.duration /= share;
  if (timing.profile.present()) timing.profile = timing.profile.slowed(share);
  timing.limit = static_cast<std::uint8_t>(10 + most.axis);
  if (request.at_least > 0 && timing.duration * boost_ > request.at_least)
    timing.warnings |= PlannedSegment::kStretched;
  if (request.pace != MotionRequest::Pace::Unspecified) timing.warnings |= PlannedSegment::kPaceCut;
}

std::optional<PaceLaw> LegTiming::pace(const MotionRequest& request,
                                       const LegDemand& demand) const {
  if (robot_.law != Law::Paul || request.profile != Profile::Unspecified) return std::nullopt;
  const bool by_share = request.pace == MotionRequest::Pace::Share;
  PaceWish wish;
  wish.share = by_share ? std::min(1.0, request.pace_value * boost_) : 1;
  const double paced = by_share ? 0 : pace_time(robot_, demand, request);
  const double asked = std::max(paced, request.at_least) / boost_;
  wish.rate = 1 / asked;
  const double t_acc = std::max(least_t_acc_, corner_time(demand, asked, request));
  wish.change = 0.75 / std::min(last_.t_acc, t_acc) + braking_;
  int axis = 0;
  const double axes_time = named_axes_time(robot_, demand, MotionRequest::Pace::Share);
  const double bends_time = least_time(robot_, *demand.path, wish.change, axis);
  const double evenly = std::max({asked, axes_time / wish.share, bends_time});
  const double worth = asked > 0 ? kWorthWithPace : kWorthFree;
  const double corners = last_.t_acc + t_acc;  // it takes no less
  auto law = local_pace(robot_, *demand.path, wish);
  return law && evenly > worth * std::max(law->duration(), corners) ? law : std::nullopt;
}

}  // namespace rob::motion
