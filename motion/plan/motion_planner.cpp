#include "motion/plan/motion_planner.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "motion/robots/time_scaling.h"

namespace rob::motion {

namespace {

/// Relative difference below which two times are the same: rounding of a few operations.
constexpr double kSameTime = 1e-9;

bool longer(double time, double than) { return time > than * (1 + kSameTime); }

std::optional<Refusal> check_wishes(const MotionRequest& request) {
  using Kind = Refusal::Kind;
  const bool paced = request.pace != MotionRequest::Pace::Unspecified;
  if (paced && !(std::isfinite(request.pace_value) && request.pace_value > 0))
    return Refusal{Kind::BadPace, -1, request.pace_value, 0};
  if (!(std::isfinite(request.at_least) && request.at_least >= 0))
    return Refusal{Kind::BadDuration, -1, request.at_least, 0};
  const bool zoned = request.zone != MotionRequest::Zone::Robots;
  if (zoned && !(std::isfinite(request.zone_value) && request.zone_value > 0))
    return Refusal{Kind::BadZone, -1, request.zone_value, 0};
  return std::nullopt;
}

double greatest_tool_speed(const RobotModel& robot) {
  double squares = 0;
  for (const Axis& axis : robot.axes)
    if (axis.kind == AxisKind::Linear) squares += axis.v_max * axis.v_max;
  return std::sqrt(squares);
}

}  // namespace

MotionPlanner::MotionPlanner(const RobotModel& robot, const JointVector& start) noexcept
    : robot_(robot),
      least_t_acc_(least_t_acc(robot)),
      linear_speed_(greatest_tool_speed(robot)),
      tool_speed_(linear_speed_),
      arms_(JointVector::Zero(start.size())),
      commanded_(start),
      t_acc_before_(robot.t_acc) {
  set_tool({});
}

PlanOutcome MotionPlanner::plan(const MotionRequest& request) noexcept {
  const std::array<double, kMaxJoints> wanted = absolute(request);
  if (const auto refusal = check_target(robot_, request.given, wanted)) return *refusal;
  if (const auto refusal = check_wishes(request)) return *refusal;
  JointVector target = complete(request.given, wanted);
  const bool no_length = (target - commanded_).cwiseAbs().maxCoeff() <= kLimitTolerance;
  if (no_length) target = commanded_;
  const Timing timing = time(target, request);
  if (!(timing.duration <= kLongest))
    return Refusal{Refusal::Kind::TooLong, -1, timing.duration, kLongest};
  return PlannedSegment{commit(request.tag, target, no_length, timing), timing.warnings};
}

double MotionPlanner::way(const MotionRequest& request) const noexcept {
  const std::array<double, kMaxJoints> wanted = absolute(request);
  if (check_target(robot_, request.given, wanted)) return 0;
  return tool_distance(complete(request.given, wanted));
}

double MotionPlanner::swing(const MotionRequest& request) const noexcept {
  const std::array<double, kMaxJoints> wanted = absolute(request);
  if (check_target(robot_, request.given, wanted)) return 0;
  return swing_to(complete(request.given, wanted));
}

void MotionPlanner::set_tool(const Pose& tool) noexcept {
  tip_ = tool.position;
  tool_speed_ = linear_speed_;
  for (int i = 0; i < robot_.axis_count(); ++i) {
    const double arm = robot_.kinematics->lever(i, tip_);
    arms_[i] = arm > kLimitTolerance ? arm : 0;
    tool_speed_ += arms_[i] * robot_.axes[static_cast<std::size_t>(i)].v_max;
  }
}

std::optional<SegmentDescriptor> MotionPlanner::stop(Tag tag) noexcept {
  if (exact_) return std::nullopt;
  return commit(tag, commanded_, true, Timing{2 * t_acc_before_, t_acc_before_, 0, 0});
}

PlanOutcome MotionPlanner::jog(Tag tag, JogRates rates) noexcept {
  constexpr double kFastest = 1e3;  // m/s, rad/s. [choice] faster than any axis
  for (int i = 0; i < rates.rate.size(); ++i) {
    if (std::isfinite(rates.rate[i])) continue;
    return Refusal{Refusal::Kind::NotFinite, i, rates.rate[i], 0};
  }
  const double greatest = rates.rate.cwiseAbs().maxCoeff();
  rates.rate *= greatest * boost_ > kFastest ? kFastest / greatest : boost_;
  const double periods = std::ceil(rates.lasts / boost_ / robot_.reference_period - kSameTime);
  rates.lasts = std::max(1.0, periods) * robot_.reference_period;
  if (!(rates.lasts <= kLongest)) rates.lasts = JogRates::kAny;
  const double duration = rates.lasts < JogRates::kAny ? rates.lasts : 0;
  t_acc_before_ = robot_.t_acc;
  SegmentDescriptor segment = commit(tag, commanded_, false, {duration, robot_.t_acc, 0, 0});
  segment.jog = rates;
  exact_ = true;  // nothing is to be made exact behind it
  return PlannedSegment{segment, 0};
}

SegmentDescriptor MotionPlanner::dwell(Tag tag, double duration) noexcept {
  SegmentDescriptor segment = commit(tag, commanded_, true, Timing{duration, robot_.t_acc, 0, 0});
  segment.dwell = true;
  return segment;
}

void MotionPlanner::retarget(const JointVector& q) noexcept {
  stand_at(q, number_);
  ++generation_;
}

void MotionPlanner::stand_at(const JointVector& q, std::uint32_t number) noexcept {
  commanded_ = q;
  exact_ = true;
  t_acc_before_ = robot_.t_acc;
  number_ = number;
}

/// The given components, measured from the origin.
std::array<double, kMaxJoints> MotionPlanner::absolute(
    const MotionRequest& request) const noexcept {
  std::array<double, kMaxJoints> target = request.target;
  if (!request.relative) return target;
  for (int i = 0; i < robot_.axis_count(); ++i)
    target[static_cast<std::size_t>(i)] += commanded_[i];
  return target;
}

JointVector MotionPlanner::complete(std::uint8_t given,
                                    const std::array<double, kMaxJoints>& wanted) const noexcept {
  JointVector target = commanded_;
  for (int i = 0; i < robot_.axis_count(); ++i) {
    if ((given >> i & 1) == 0) continue;
    const Axis& axis = robot_.axes[static_cast<std::size_t>(i)];
    target[i] = std::clamp(wanted[static_cast<std::size_t>(i)], axis.min, axis.max);
  }
  return target;
}

MotionPlanner::Timing MotionPlanner::time(const JointVector& target,
                                          const MotionRequest& request) const noexcept {
  const JointVector delta = (target - commanded_).cwiseAbs();
  Timing timing;
  for (int i = 0; i < robot_.axis_count(); ++i) {
    const double needed = delta[i] / robot_.axes[static_cast<std::size_t>(i)].v_max;
    if (needed <= timing.duration) continue;
    timing.duration = needed;
    timing.limit = static_cast<std::uint8_t>(2 + i);
  }
  const double slowest = timing.duration;
  const double paced = pace_time(delta, target, request);
  if (longer(named_axes_time(delta, request.pace), paced))
    timing.warnings |= PlannedSegment::kPaceCut;
  if (longer(paced / boost_, timing.duration)) timing.limit = 1;
  timing.duration = std::max(timing.duration, paced / boost_);

  const double asked = std::max(timing.duration, request.at_least / boost_);
  timing.t_acc = corner_time(greatest_way(target), asked, request);
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
  return timing;
}

/// t_C as the request asks for it; `duration`: of the motion, corners apart.
double MotionPlanner::corner_time(double distance, double duration,
                                  const MotionRequest& request) const noexcept {
  switch (request.zone) {
    case MotionRequest::Zone::Robots:
      return robot_.t_acc;
    case MotionRequest::Zone::Length:
      return std::min(robot_.t_acc, zone_time(distance, duration, request.zone_value));
    case MotionRequest::Zone::Time:
      return request.zone_value;
    case MotionRequest::Zone::Share:
      return request.zone_value * robot_.t_acc;
  }
  return robot_.t_acc;
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

Eigen::Vector3d MotionPlanner::tip(const JointVector& q) const noexcept {
  return place_of(tip_, robot_.kinematics->forward(q));
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

double MotionPlanner::pace_time(const JointVector& delta, const JointVector& target,
                                const MotionRequest& request) const noexcept {
  switch (request.pace) {
    case MotionRequest::Pace::Unspecified:
      return 0;
    case MotionRequest::Pace::ToolSpeed:
      return tool_distance(target) / request.pace_value;
    case MotionRequest::Pace::AngularSpeed: {
      double turn = 0;
      for (int i = 0; i < robot_.axis_count(); ++i)
        if (robot_.axes[static_cast<std::size_t>(i)].kind == AxisKind::Rotary)
          turn = std::max(turn, delta[i]);
      return turn / request.pace_value;
    }
    case MotionRequest::Pace::Share:
      return named_axes_time(delta, request.pace) / request.pace_value;
  }
  return 0;
}

/// The least time of the axes that a pace speaks of: the linear ones for a tool speed, the rotary
/// ones for an angular speed, all for a share.
double MotionPlanner::named_axes_time(const JointVector& delta,
                                      MotionRequest::Pace pace) const noexcept {
  using Pace = MotionRequest::Pace;
  double least = 0;
  for (int i = 0; i < robot_.axis_count(); ++i) {
    const Axis& axis = robot_.axes[static_cast<std::size_t>(i)];
    const bool named = pace == Pace::Share ||
                       (pace == Pace::ToolSpeed && axis.kind == AxisKind::Linear) ||
                       (pace == Pace::AngularSpeed && axis.kind == AxisKind::Rotary);
    if (named) least = std::max(least, delta[i] / axis.v_max);
  }
  return least;
}

SegmentDescriptor MotionPlanner::commit(Tag tag, const JointVector& target, bool no_length,
                                        const Timing& timing) noexcept {
  SegmentDescriptor segment;
  segment.tag = tag;
  segment.number = ++number_;
  segment.generation = generation_;
  segment.target = target;
  segment.duration = timing.duration;
  segment.t_acc_before = t_acc_before_;
  segment.t_acc = timing.t_acc;
  segment.no_length = no_length;
  segment.limit = timing.limit;
  commanded_ = target;
  exact_ = no_length;
  t_acc_before_ = segment.t_acc;
  return segment;
}

}  // namespace rob::motion
