#include "motion/plan/motion_planner.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "motion/plan/wishes.h"
#include "motion/robots/time_scaling.h"

namespace rob::motion {

namespace {

/// The motion that runs, the one before it in the corner, and those of a buffer that has just been
/// given up for another one.
constexpr std::size_t kMostRunning = 8;

double greatest_tool_speed(const RobotModel& robot) {
  double squares = 0;
  for (const Axis& axis : robot.axes)
    if (axis.kind == AxisKind::Linear) squares += axis.v_max * axis.v_max;
  return std::sqrt(squares);
}

}  // namespace

MotionPlanner::MotionPlanner(const RobotModel& robot, const JointVector& start) noexcept
    : robot_(robot),
      carrying_(robot.mechanics),
      mechanics_(carrying_.with({})),
      usual_t_acc_(robot.law == Law::Paul ? robot.t_acc : 0),
      least_t_acc_(least_t_acc(robot)),
      braking_(time_scale_limits(robot).slope),
      linear_speed_(greatest_tool_speed(robot)),
      tool_speed_(linear_speed_),
      arms_(JointVector::Zero(start.size())),
      commanded_(start),
      kept_(static_cast<std::size_t>(robot.most_ahead()) + kMostRunning),
      boxes_(robot) {
  set_tool({});
}

PlanOutcome MotionPlanner::plan(const MotionRequest& request) {
  const std::array<double, kMaxJoints> wanted = absolute(request);
  if (const auto refusal = check_target(robot_, request.given, wanted)) return *refusal;
  if (const auto refusal = check_wishes(request)) return *refusal;
  Draft draft{complete(request.given, wanted)};
  draft.no_length = (draft.target - commanded_).cwiseAbs().maxCoeff() <= kLimitTolerance;
  if (draft.no_length) draft.target = commanded_;
  draft.demand = straight_demand(draft.target);
  return take(request, std::move(draft));
}

/// A profile has its own time under both laws.
PlanOutcome MotionPlanner::take(const MotionRequest& request, Draft draft) {
  const bool profiled = request.profile != ProfileShape::None && !draft.no_length;
  const bool timed = robot_.law == Law::Paul || profiled;
  if (robot_.law == Law::LookAhead && draft.demand.path == nullptr && !draft.no_length)
    measure_swing(draft.target, draft.demand);
  return timed ? take_timed(request, std::move(draft)) : take_ahead(request, std::move(draft));
}

PlanOutcome MotionPlanner::take_timed(const MotionRequest& request, Draft draft) {
  Timing timing = time(draft, request);
  if (robot_.mechanics && !draft.no_length) suit_drives(draft, request, timing);
  if (!(timing.duration <= kLongest))
    return Refusal{Refusal::Kind::TooLong, -1, timing.duration, kLongest};
  PlannedSegment planned;
  planned.warnings = timing.warnings;
  planned.pace_cut = draft.pace_cut;
  if (draft.pace_cut.axis >= 0) planned.warnings |= PlannedSegment::kPaceCut;
  if (draft.pace_cut.asked > 0)
    planned.pace_cut.longer =
        std::max(0.0, timing.duration - std::max(draft.pace_cut.asked, request.at_least / boost_));
  planned.segment = joined(draft, timing, planned.warnings);
  if (robot_.mechanics && demanded_by_corner(planned.segment).speed < 1) {
    planned.segment.from_rest = true;
    planned.warnings |= PlannedSegment::kCornerExact;
  }
  const JointVector from = commanded_;
  SegmentDescriptor& segment = planned.segment;
  segment.live.unit_time = live_unit_time(robot_, draft.demand, request);
  segment.reserve = axis_reserve(robot_, draft.demand.rates / segment.duration);
  commit(request.tag, segment);
  before_ = {{segment.path, from, segment.target, segment.duration}, draft.leg, tool_};
  if (request.zone == MotionRequest::Zone::Length) before_.zone = request.zone_value;
  planned.leg = std::move(draft.leg);
  keep(planned.leg);
  return planned;
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
  tool_ = tool;
  tool_speed_ = linear_speed_;
  for (int i = 0; i < robot_.axis_count(); ++i) {
    const double arm = robot_.kinematics->lever(i, tool_.position);
    arms_[i] = arm > kLimitTolerance ? arm : 0;
    tool_speed_ += arms_[i] * robot_.axes[static_cast<std::size_t>(i)].v_max;
  }
}

std::optional<SegmentDescriptor> MotionPlanner::stop(Tag tag) noexcept {
  if (exact_) return std::nullopt;
  SegmentDescriptor segment =
      segment_to(commanded_, true, Timing{2 * t_acc_before_, t_acc_before_, 0, 0});
  return commit(tag, segment);
}

PlanOutcome MotionPlanner::jog(Tag tag, JogRates rates) noexcept {
  constexpr double kFastest = 1e3;    // m/s, rad/s. [choice] faster than any axis
  constexpr double kRounding = 1e-9;  // periods: of the quotient
  for (int i = 0; i < rates.rate.size(); ++i) {
    if (std::isfinite(rates.rate[i])) continue;
    return Refusal{Refusal::Kind::NotFinite, i, rates.rate[i], 0};
  }
  const double greatest = rates.rate.cwiseAbs().maxCoeff();
  rates.rate *= greatest * boost_ > kFastest ? kFastest / greatest : boost_;
  const double periods = std::ceil(rates.lasts / boost_ / robot_.reference_period - kRounding);
  rates.lasts = std::max(1.0, periods) * robot_.reference_period;
  if (!(rates.lasts <= kLongest)) rates.lasts = JogRates::kAny;
  const double duration = rates.lasts < JogRates::kAny ? rates.lasts : 0;
  t_acc_before_ = usual_t_acc_;
  SegmentDescriptor segment = segment_to(commanded_, false, {duration, usual_t_acc_, 0, 0});
  segment.jog = rates;
  commit(tag, segment);
  exact_ = true;  // nothing is to be made exact after it
  return PlannedSegment{segment, 0};
}

SegmentDescriptor MotionPlanner::dwell(Tag tag, double duration) noexcept {
  SegmentDescriptor segment = segment_to(commanded_, true, Timing{duration, usual_t_acc_, 0, 0});
  segment.dwell = true;
  return commit(tag, segment);
}

void MotionPlanner::retarget(const JointVector& q) noexcept {
  stand_at(q, number_);
  ++generation_;
}

void MotionPlanner::stand_at(const JointVector& q, std::uint32_t number) noexcept {
  commanded_ = q;
  exact_ = true;
  t_acc_before_ = usual_t_acc_;
  number_ = number;
}

MotionPlanner::Mark MotionPlanner::mark() const {
  Mark mark;
  mark.commanded_ = commanded_;
  mark.t_acc_before_ = t_acc_before_;
  mark.exact_ = exact_;
  mark.before_ = before_;
  mark.number_ = number_;
  return mark;
}

void MotionPlanner::go_back(const Mark& mark) {
  commanded_ = mark.commanded_;
  t_acc_before_ = mark.t_acc_before_;
  exact_ = mark.exact_;
  before_ = mark.before_;
  number_ = mark.number_;
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

Eigen::Vector3d MotionPlanner::tip(const JointVector& q) const noexcept {
  return place_of(tool_.position, robot_.kinematics->forward(q));
}

Pose MotionPlanner::tool_pose() const noexcept {
  const Pose flange = robot_.kinematics->forward(commanded_);
  return {place_of(tool_.position, flange), flange.orientation * tool_.orientation};
}

SegmentDescriptor MotionPlanner::segment_to(const JointVector& target, bool no_length,
                                            const Timing& timing) const noexcept {
  SegmentDescriptor segment;
  segment.target = target;
  segment.duration = timing.duration;
  segment.t_acc_before = t_acc_before_;
  segment.t_acc = timing.t_acc;
  segment.no_length = no_length;
  segment.limit = timing.limit;
  segment.profile = timing.profile;
  return segment;
}

SegmentDescriptor& MotionPlanner::commit(Tag tag, SegmentDescriptor& segment) noexcept {
  segment.tag = tag;
  segment.number = ++number_;
  segment.generation = generation_;
  commanded_ = segment.target;
  exact_ = segment.ends_at_rest();
  t_acc_before_ = segment.t_acc;
  return segment;
}

}  // namespace rob::motion
