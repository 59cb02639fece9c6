#include <algorithm>
#include <cmath>
#include <utility>

#include "motion/path/follow.h"
#include "motion/plan/local_pace.h"
#include "motion/plan/motion_planner.h"
#include "motion/plan/reach.h"
#include "motion/plan/wishes.h"

/// Member functions of MotionPlanner for motions along paths of the tool, and for corners.
namespace rob::motion {

namespace {

/// The least share of the speed asked for that a motion may be slowed down to by the axes, before
/// it is refused as singular (2 %).
constexpr double kLeastShare = 0.02;

/// [choice] A path gets a pace for each place where an even rate takes so many times as long. With
/// AT that is soon, since AT is kept elsewhere; without AT an ordinary line keeps an even rate.
constexpr double kWorthWithPace = 1.05;
constexpr double kWorthFree = 1.5;

/// m, rad: two poses that differ by less are one.
constexpr double kSamePose = 1e-9;

Pose flange_of(const Pose& pose, const Pose& tool) {
  const Eigen::Quaterniond turned = pose.orientation * tool.orientation.conjugate();
  return {pose.position - turned * tool.position, turned};
}

bool same(const Pose& a, const Pose& b) {
  return (a.position - b.position).norm() <= kSamePose &&
         a.orientation.angularDistance(b.orientation) <= kSamePose;
}

LegDemand demand_of(const ToolPath& path, const JointPath& axes) {
  LegDemand demand;
  demand.path = &axes;
  const bool even = dynamic_cast<const ToolLine*>(&path) != nullptr;
  const bool stands = path.axes() != nullptr && path.way() <= kSamePose;  // the axes alone turn
  if (!even && !stands) demand.uneven = &path;
  demand.rates = greatest_rates(axes);
  demand.way = path.way();
  demand.turn = path.turn();
  demand.pace_way = path.greatest_speed();
  demand.pace_turn = path.greatest_turning();
  demand.farthest = path.way();
  demand.leaving = path.greatest_speed();
  demand.first_point = (path.first_point() - path.begin()) / (path.end() - path.begin());
  demand.last_point = (path.last_point() - path.begin()) / (path.end() - path.begin());
  return demand;
}

/// Along a path that the axes lead.
Followed led_by(const JointPath& axes) {
  Followed led{axes, std::nullopt};
  if (axes.nodes().size() > kMostNodes)
    led.trouble = PathTrouble{PathTrouble::Kind::TooLong, axes.begin(), -1};
  return led;
}

}  // namespace

PlanOutcome MotionPlanner::plan(const MotionRequest& request, const ToolPath& path) {
  if (const auto refusal = check_wishes(request)) return *refusal;
  Draft draft{commanded_};
  draft.no_length = path.way() <= kSamePose && path.turn() <= kSamePose;
  if (draft.no_length) {
    draft.demand = straight_demand(draft.target);
    return take(request, std::move(draft));
  }
  Followed followed =
      path.axes() != nullptr ? led_by(*path.axes()) : follow(robot_, path, tool_, commanded_);
  if (const auto refusal = judge(request, path, followed)) return *refusal;
  draft.leg = std::make_shared<PlannedLeg>();
  draft.target = followed.axes.nodes().back().q;
  draft.demand = demand_of(path, followed.axes);
  const double paced = pace_time(robot_, draft.demand, request) / boost_;
  draft.pace_cut = pace_cut(robot_, path, followed.axes, paced);
  if (path.axes() == nullptr) draft.leg->pace = pace(request, draft.demand);
  if (draft.leg->pace) {
    const PacedPath slowed(path, *draft.leg->pace);
    draft.leg->axes = slowed.paced(followed.axes);
    draft.demand = demand_of(slowed, *draft.leg->axes);
    draft.demand.uneven = nullptr;  // only the look-ahead law asks, and `slowed` ends here
  } else {
    draft.leg->axes = std::move(followed.axes);
    draft.demand.path = &*draft.leg->axes;
    if (const auto* const line = dynamic_cast<const ToolLine*>(&path)) draft.leg->line = *line;
  }
  return take(request, std::move(draft));
}

/// Under Paul's law the tool goes along a path at an even rate. Where that would take much longer
/// than what its slowest places cost, it is slowed down at these alone.
std::optional<PaceLaw> MotionPlanner::pace(const MotionRequest& request,
                                           const LegDemand& demand) const {
  if (robot_.law != Law::Paul || request.profile != ProfileShape::None) return std::nullopt;
  const bool by_share = request.pace == MotionRequest::Pace::Share;
  PaceWish wish;
  wish.share = by_share ? std::min(1.0, request.pace_value * boost_) : 1;
  const double paced = by_share ? 0 : pace_time(robot_, demand, request);
  const double asked = std::max(paced, request.at_least) / boost_;
  wish.rate = 1 / asked;
  const double t_acc = std::max(least_t_acc_, corner_time(demand, asked, request));
  wish.change = 0.75 / std::min(t_acc_before_, t_acc) + braking_;
  int axis = 0;
  const double axes_time = named_axes_time(robot_, demand, MotionRequest::Pace::Share);
  const double bends_time = least_time(robot_, *demand.path, wish.change, axis);
  const double evenly = std::max({asked, axes_time / wish.share, bends_time});
  const double worth = asked > 0 ? kWorthWithPace : kWorthFree;
  const double corners = t_acc_before_ + t_acc;  // it takes no less
  auto law = local_pace(robot_, *demand.path, wish);
  return law && evenly > worth * std::max(law->duration(), corners) ? law : std::nullopt;
}

/// The first thing on the way that cannot be: an axis beyond its limits or too fast, or the end of
/// what can be followed.
std::optional<Refusal> MotionPlanner::judge(const MotionRequest& request, const ToolPath& path,
                                            const Followed& followed) const {
  const auto& trouble = followed.trouble;
  std::optional<Refusal> first;
  if (trouble) first = placed(refusal_for(*trouble, path, followed.axes), path);
  if (followed.axes.nodes().empty()) return first;
  if (const auto beyond = first_beyond(robot_, followed.axes)) {
    first = placed(*beyond, path);
    first->other = path.axes() == nullptr && reachable_otherwise(path);
  }
  if (path.axes() != nullptr) return first;  // singular places do no harm to them
  // Where the reach ends the arm is stretched: that says more than how fast it would have to be.
  const bool out = trouble && trouble->kind == PathTrouble::Kind::OutOfReach;
  const auto slow = out ? std::nullopt : too_slow(request, path, followed.axes);
  return slow && (!first || slow->at < first->at) ? slow : first;
}

Refusal MotionPlanner::refusal_for(const PathTrouble& trouble, const ToolPath& path,
                                   const JointPath& axes) const {
  Refusal refusal;
  refusal.axis = trouble.axis;
  refusal.at = trouble.at;
  refusal.q = axes.nodes().empty() ? commanded_ : axes.nodes().back().q;
  refusal.kind = trouble.kind == PathTrouble::Kind::TooLong ? Refusal::Kind::PathTooLong
                                                            : Refusal::Kind::PathSingular;
  if (trouble.kind != PathTrouble::Kind::OutOfReach) return refusal;
  refusal.kind = Refusal::Kind::PathOutOfReach;
  // [choice] a ten-thousandth of the path on, where the lack can be told from rounding
  const double beyond = std::min(trouble.at + 1e-4 * (path.end() - path.begin()), path.end());
  refusal.shortfall = robot_.kinematics->shortfall(flange_of(path.at(beyond), tool_));
  return refusal;
}

/// Where the axes allow too little of the speed that is asked for, or that they allow elsewhere.
std::optional<Refusal> MotionPlanner::too_slow(const MotionRequest& request, const ToolPath& path,
                                               const JointPath& axes) const {
  const LegDemand demand = demand_of(path, axes);
  const double asked = std::max(pace_time(robot_, demand, request), request.at_least) / boost_;
  const Slowest slowest = slowest_place(robot_, path, axes, 1 / asked);
  if (slowest.share >= kLeastShare) return std::nullopt;
  Refusal refusal;
  refusal.kind = Refusal::Kind::PathSingular;
  refusal.axis = slowest.axis;
  refusal.at = slowest.at;
  refusal.q = axes.at(slowest.at).q;
  return placed(refusal, path);
}

/// Refusal::at becomes a place on the way.
Refusal MotionPlanner::placed(Refusal refusal, const ToolPath& path) const {
  refusal.turning = path.way() <= kSamePose;
  refusal.way = refusal.turning ? path.turn() : path.way();
  refusal.at = path.share_at(refusal.at) * refusal.way;
  return refusal;
}

bool MotionPlanner::reachable_otherwise(const ToolPath& path) const {
  const auto q = reach(robot_, flange_of(path.at(path.end()), tool_), commanded_);
  if (!q) return false;
  std::array<double, kMaxJoints> target{};
  std::copy(q->begin(), q->end(), target.begin());
  return !check_target(robot_, 0xff, target);
}

SegmentDescriptor MotionPlanner::joined(Draft& draft, const Timing& timing,
                                        std::uint8_t& warnings) const {
  SegmentDescriptor segment = segment_to(draft.target, draft.no_length, timing);
  if (draft.leg != nullptr && draft.leg->axes) segment.path = &*draft.leg->axes;
  if (!exact_ && !draft.no_length) join(draft, segment, warnings);
  return segment;
}

/// The corner out of the motion before, where S1's in the axes is not the one.
void MotionPlanner::join(Draft& draft, SegmentDescriptor& segment, std::uint8_t& warnings) const {
  segment.from_rest = segment.profile.present();
  if (segment.from_rest) return;
  const bool straight = segment.path == nullptr && before_.motion.path == nullptr;
  const bool bounded = robot_.tool_coordinates && std::isfinite(before_.zone);
  if (straight && !bounded) return;
  if (draft.leg == nullptr) draft.leg = std::make_shared<PlannedLeg>();
  CornerTask task;
  task.in = before_.motion;
  task.out = {segment.path, before_.motion.to, segment.target, segment.duration};
  const auto line_of = [](const PlannedLeg* leg) {
    return leg != nullptr && leg->line ? &*leg->line : nullptr;
  };
  if (same(before_.tool, tool_)) {
    task.line_in = line_of(before_.leg.get());
    task.line_out = line_of(draft.leg.get());
  }
  task.tip = tool_;
  task.longest = segment.t_acc_before;
  task.zone = before_.zone;
  task.braking = braking_;
  draft.leg->corner = make_corner(robot_, task);
  if (draft.leg->corner) {
    segment.corner = &*draft.leg->corner;
  } else {
    segment.from_rest = true;
    warnings |= PlannedSegment::kCornerExact;
  }
}

void MotionPlanner::keep(std::shared_ptr<const PlannedLeg> leg) {
  kept_[next_kept_++ % kept_.size()] = std::move(leg);
}

}  // namespace rob::motion
