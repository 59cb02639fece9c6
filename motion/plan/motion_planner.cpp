#include "motion/plan/motion_planner.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "motion/path/follow.h"
#include "motion/path/free_path.h"
#include "motion/path/paced_path.h"
#include "motion/plan/ahead_judge.h"
#include "motion/plan/ahead_leg.h"
#include "motion/plan/reach.h"
#include "motion/plan/whole_pose.h"
#include "motion/plan/wishes.h"
#include "motion/robots/time_scaling.h"

namespace rob::motion {

namespace {

/// The motion that runs, the one before it in the corner, and those of a buffer that has just been
/// given up for another one.
constexpr std::size_t kMostRunning = 8;

LastTarget standing_at(const JointVector& q, double t_acc) {
  LastTarget last;
  last.q = q;
  last.t_acc = t_acc;
  return last;
}

/// Along a path that the axes lead.
Followed led_by(const JointPath& axes) {
  Followed led{axes, std::nullopt};
  if (axes.nodes().size() > kMostNodes)
    led.trouble = PathTrouble{PathTrouble::Kind::TooLong, axes.begin(), -1};
  return led;
}

}  // namespace

MotionPlanner::MotionPlanner(const RobotModel& robot, const JointVector& start) noexcept
    : robot_(robot),
      carrying_(robot.mechanics),
      mechanics_(carrying_.with({})),
      tip_(robot),
      timing_(robot, tip_, last_),
      segments_(robot, tip_, last_, timing_),
      drives_(robot, last_, timing_, segments_),
      paths_(robot, tip_, last_, timing_),
      kept_(static_cast<std::size_t>(most_ahead(robot)) + kMostRunning),
      boxes_(robot) {
  last_ = standing_at(start, timing_.usual_t_acc());
}

PlanOutcome MotionPlanner::plan(const MotionRequest& request) {
  const std::array<double, kMaxJoints> wanted = absolute(request);
  if (const auto refusal = check_target(robot_, request.given, wanted)) return *refusal;
  if (const auto refusal = check_wishes(request)) return *refusal;
  MotionDraft draft{complete(request.given, wanted)};
  draft.no_length = (draft.target - last_.q).cwiseAbs().maxCoeff() <= kLimitTolerance;
  if (draft.no_length) draft.target = last_.q;
  draft.demand = tip_.demand(last_.q, draft.target);
  return take(request, std::move(draft));
}

PlanOutcome MotionPlanner::plan(const MotionRequest& request, const ToolPath& path) {
  const bool choose = request.free && robot_.kinematics->freedom() == Freedom::None;
  if (!choose || path.axes() != nullptr) return plan_along(request, path);
  return plan_along(request, choose_turn(robot_, path, tip_.pose(), *request.free, last_.q));
}

/// The axes along a path of the tip. `alone`: set where who follows it anew would choose anew.
Followed MotionPlanner::axes_along(const MotionRequest& request, const ToolPath& path,
                                   bool& alone) const {
  if (path.axes() != nullptr) return led_by(*path.axes());
  const Pose& tip = tip_.pose();
  const auto other = request.free ? leaving(robot_, *request.free, tip) : std::nullopt;
  const auto whole = request.whole ? upright_along(robot_, path) : std::nullopt;
  const auto tipped = other || whole ? other : tip_as_flange(robot_, tip);
  if (!tipped) {
    bool chosen = false;
    Followed followed = follow_choosing(whole ? *whole : robot_, path, tip, last_.q, chosen);
    alone = alone || chosen;
    return followed;
  }
  alone = true;
  return motion::follow(*tipped, path, {}, last_.q);
}

PlanOutcome MotionPlanner::plan_along(const MotionRequest& request, const ToolPath& path) {
  if (const auto refusal = check_wishes(request)) return *refusal;
  const bool hand = brings_gripper(request);
  const std::array<double, kMaxJoints> wanted = absolute(request);
  if (const auto refusal = check_target(robot_, hand ? request.given : 0, wanted)) return *refusal;
  MotionDraft draft{last_.q};
  draft.no_length = path.way() <= kSamePose && path.turn() <= kSamePose;
  if (draft.no_length && hand) return plan(request);
  if (draft.no_length) {
    draft.demand = tip_.demand(last_.q, draft.target);
    return take(request, std::move(draft));
  }
  bool alone = hand;
  Followed followed = axes_along(request, path, alone);
  if (const auto refusal = paths_.judge(request, path, followed)) return *refusal;
  if (hand) followed.axes.bring(robot_.gripper, complete(request.given, wanted)[robot_.gripper]);
  draft.leg = std::make_shared<PlannedLeg>();
  draft.target = followed.axes.nodes().back().q;
  if (request.near && !is_branch_of(robot_, draft.target, *request.near)) {
    Refusal refusal{Refusal::Kind::OtherBranch};
    refusal.q = draft.target;
    return refusal;
  }
  draft.demand = demand_along(path, followed.axes);
  const double paced = pace_time(robot_, draft.demand, request) / timing_.boost();
  draft.pace_cut = pace_cut(robot_, path, followed.axes, paced);
  if (path.axes() == nullptr) draft.leg->pace = timing_.pace(request, draft.demand);
  if (draft.leg->pace) {
    const PacedPath slowed(path, *draft.leg->pace);
    draft.leg->axes = slowed.paced(followed.axes);
    draft.demand = demand_along(slowed, *draft.leg->axes);
    draft.demand.uneven = nullptr;  // only the look-ahead law asks, and `slowed` ends here
  } else {
    draft.leg->axes = std::move(followed.axes);
    draft.demand.path = &*draft.leg->axes;
    // Such lines may be joined to others; who follows one anew would choose anew.
    const auto* const line = alone ? nullptr : dynamic_cast<const ToolLine*>(&path);
    if (line != nullptr) draft.leg->line = *line;
  }
  return take(request, std::move(draft));
}

/// A profile has its own time under both laws.
PlanOutcome MotionPlanner::take(const MotionRequest& request, MotionDraft draft) {
  const bool profiled = request.profile != Profile::Unspecified && !draft.no_length;
  const bool timed = robot_.law == Law::Paul || profiled;
  if (robot_.law == Law::LookAhead && draft.demand.path == nullptr && !draft.no_length)
    tip_.measure_swing(last_.q, draft.target, draft.demand);
  return timed ? take_timed(request, std::move(draft)) : take_ahead(request, std::move(draft));
}

PlanOutcome MotionPlanner::take_timed(const MotionRequest& request, MotionDraft draft) {
  Timing timing = timing_.time(draft, request);
  if (mechanics_ != nullptr && !draft.no_length) drives_.suit(*mechanics_, request, draft, timing);
  if (!(timing.duration <= kLongest))
    return Refusal{Refusal::Kind::TooLong, -1, timing.duration, kLongest};
  PlannedSegment planned;
  planned.warnings = timing.warnings;
  planned.pace_cut = draft.pace_cut;
  if (draft.pace_cut.axis >= 0) planned.warnings |= PlannedSegment::kPaceCut;
  if (draft.pace_cut.asked > 0) {
    const double asked = std::max(draft.pace_cut.asked, request.at_least / timing_.boost());
    planned.pace_cut.longer = std::max(0.0, timing.duration - asked);
  }
  SegmentDescriptor& segment = planned.segment;
  segment = segments_.joined(draft, timing, planned.warnings);
  if (mechanics_ != nullptr && !drives_.corner_fits(*mechanics_, segment)) {
    segment.from_rest = true;
    planned.warnings |= PlannedSegment::kCornerExact;
  }
  segment.live.unit_time = live_unit_time(robot_, draft.demand, request);
  segment.reserve = axis_reserve(robot_, draft.demand.rates / segment.duration);
  leave(request, std::move(draft), planned);
  return planned;
}

/// Its time is known only after its neighbours are.
PlanOutcome MotionPlanner::take_ahead(const MotionRequest& request, MotionDraft draft) {
  PlannedSegment planned;
  planned.pace_cut = draft.pace_cut;
  SegmentDescriptor& segment = planned.segment;
  segment = segments_.segment_to(draft.target, false, {});
  segment.duration = robot_.reference_period;  // of a target that is the last one: it is passed
  if (draft.no_length) {
    bound_corner(robot_, request, LegBounds::kAny, segment.ahead);
  } else {
    const AheadLeg leg = ahead_leg(robot_, draft.demand, request);
    if (!(leg.alone <= kLongest)) return Refusal{Refusal::Kind::TooLong, -1, leg.alone, kLongest};
    if (mechanics_ != nullptr)
      if (const auto refusal = too_heavy(robot_, *mechanics_, last_.q, draft)) return *refusal;
    segment.ahead = leg.bounds;
    segment.ahead.mechanics = mechanics_;
    if (draft.leg && draft.leg->line) segment.ahead.line = &*draft.leg->line;
    segment.duration = leg.duration;
    segment.path = draft.demand.path;
    segment.live.unit_time = live_unit_time(robot_, draft.demand, request);
    planned.warnings = leg.warnings;
    if (!last_.exact) judge_zone(robot_, tip_, last_, draft, planned);
  }
  segment.ahead.from = last_.q;
  segment.ahead.tip = tip_.pose();
  leave(request, std::move(draft), planned);
  return planned;
}

/// The motion is taken: what comes next leaves its target.
void MotionPlanner::leave(const MotionRequest& request, MotionDraft draft,
                          PlannedSegment& planned) {
  SegmentDescriptor& segment = planned.segment;
  LastTarget::Before before{
      {segment.path, last_.q, segment.target, segment.duration}, draft.leg, tip_.pose()};
  if (request.zone == MotionRequest::Zone::Length) before.zone = request.zone_value;
  before.tag = request.tag;
  last_.before = std::move(before);
  commit(request.tag, segment);
  planned.leg = std::move(draft.leg);
  kept_[next_kept_++ % kept_.size()] = planned.leg;
}

double MotionPlanner::way(const MotionRequest& request) const noexcept {
  const std::array<double, kMaxJoints> wanted = absolute(request);
  if (check_target(robot_, request.given, wanted)) return 0;
  return tip_.distance(last_.q, complete(request.given, wanted));
}

double MotionPlanner::swing(const MotionRequest& request) const noexcept {
  const std::array<double, kMaxJoints> wanted = absolute(request);
  if (check_target(robot_, request.given, wanted)) return 0;
  return tip_.swing(last_.q, complete(request.given, wanted));
}

std::optional<SegmentDescriptor> MotionPlanner::stop(Tag tag) noexcept {
  if (last_.exact) return std::nullopt;
  SegmentDescriptor segment =
      segments_.segment_to(last_.q, true, Timing{2 * last_.t_acc, last_.t_acc});
  return commit(tag, segment);
}

PlanOutcome MotionPlanner::jog(Tag tag, JogRates rates) noexcept {
  constexpr double kFastest = 1e3;    // m/s, rad/s. [choice] faster than any axis
  constexpr double kRounding = 1e-9;  // periods: of the quotient
  for (int i = 0; i < rates.rate.size(); ++i) {
    if (std::isfinite(rates.rate[i])) continue;
    return Refusal{Refusal::Kind::NotFinite, i, rates.rate[i], 0};
  }
  const double boost = timing_.boost();
  const double greatest = rates.rate.cwiseAbs().maxCoeff();
  rates.rate *= greatest * boost > kFastest ? kFastest / greatest : boost;
  const double periods = std::ceil(rates.lasts / boost / robot_.reference_period - kRounding);
  rates.lasts = std::max(1.0, periods) * robot_.reference_period;
  if (!(rates.lasts <= kLongest)) rates.lasts = JogRates::kAny;
  const double duration = rates.lasts < JogRates::kAny ? rates.lasts : 0;
  last_.t_acc = timing_.usual_t_acc();
  SegmentDescriptor segment =
      segments_.segment_to(last_.q, false, Timing{duration, timing_.usual_t_acc()});
  segment.jog = rates;
  commit(tag, segment);
  last_.exact = true;  // nothing needs to be made exact after it
  return PlannedSegment{segment, 0};
}

SegmentDescriptor MotionPlanner::dwell(Tag tag, double duration) noexcept {
  SegmentDescriptor segment =
      segments_.segment_to(last_.q, true, Timing{duration, timing_.usual_t_acc()});
  segment.dwell = true;
  return commit(tag, segment);
}

void MotionPlanner::retarget(const JointVector& q) noexcept {
  stand_at(q, last_.number);
  ++generation_;
}

void MotionPlanner::stand_at(const JointVector& q, std::uint32_t number) noexcept {
  last_.q = q;
  last_.exact = true;
  last_.t_acc = timing_.usual_t_acc();
  last_.number = number;
}

/// Whether a motion along a path brings the gripper elsewhere.
bool MotionPlanner::brings_gripper(const MotionRequest& request) const noexcept {
  return robot_.gripper >= 0 && request.given == 1U << static_cast<unsigned>(robot_.gripper);
}

/// The given components, measured from the origin.
std::array<double, kMaxJoints> MotionPlanner::absolute(
    const MotionRequest& request) const noexcept {
  std::array<double, kMaxJoints> target = request.target;
  if (!request.relative) return target;
  for (int i = 0; i < robot_.axis_count(); ++i) target[static_cast<std::size_t>(i)] += last_.q[i];
  return target;
}

JointVector MotionPlanner::complete(std::uint8_t given,
                                    const std::array<double, kMaxJoints>& wanted) const noexcept {
  JointVector target = last_.q;
  for (int i = 0; i < robot_.axis_count(); ++i) {
    if ((given >> i & 1) == 0) continue;
    const Axis& axis = robot_.axes[static_cast<std::size_t>(i)];
    target[i] = std::clamp(wanted[static_cast<std::size_t>(i)], axis.min, axis.max);
  }
  return target;
}

SegmentDescriptor& MotionPlanner::commit(Tag tag, SegmentDescriptor& segment) noexcept {
  segment.tag = tag;
  segment.number = ++last_.number;
  segment.generation = generation_;
  last_.q = segment.target;
  last_.exact = segment.ends_at_rest();
  last_.t_acc = segment.t_acc;
  return segment;
}

}  // namespace rob::motion
