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

/// [choice] What a motion that is gone evenly takes, in parts of what it takes where each place has
/// a pace of its own: with AT it keeps AT elsewhere; without it an ordinary line stays even.
constexpr double kWorthWithPace = 1.05;
constexpr double kWorthFree = 1.5;

/// In each piece of the axes so many places are looked at for what AT cannot have. [choice]
constexpr int kCutParts = 8;

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
  draft.leg->pace = pace(request, path, followed.axes);
  draft.pace_cut = pace_cut(request, path, followed.axes);
  draft.target = followed.axes.nodes().back().q;
  if (draft.leg->pace) {
    const PacedPath paced(path, *draft.leg->pace);
    draft.leg->axes = paced.paced(followed.axes);
    draft.demand = demand_of(paced, *draft.leg->axes);
    draft.demand.uneven = nullptr;  // the look-ahead law's affair
    return take(request, std::move(draft));
  }
  draft.leg->axes = std::move(followed.axes);
  draft.demand = demand_of(path, *draft.leg->axes);
  if (const auto* const line = dynamic_cast<const ToolLine*>(&path)) draft.leg->line = *line;
  return take(request, std::move(draft));
}

/// Under Paul's law a path is gone evenly. Where that would take much longer than its slowest
/// places do, it is slowed down there alone.
std::optional<PaceLaw> MotionPlanner::pace(const MotionRequest& request, const ToolPath& path,
                                           const JointPath& axes) const {
  const bool even = robot_.law != Law::Paul || request.profile != ProfileShape::None;
  if (even || path.axes() != nullptr) return std::nullopt;
  LegDemand demand = demand_of(path, axes);
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
  const double evenly =
      std::max({asked, axes_time / wish.share, least_time(robot_, axes, wish.change, axis)});
  const double worth = asked > 0 ? kWorthWithPace : kWorthFree;
  const double corners = t_acc_before_ + t_acc;  // it takes no less
  auto law = local_pace(robot_, axes, wish);
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

/// Where what AT asks for is more than an axis can do.
PlannedSegment::PaceCut MotionPlanner::pace_cut(const MotionRequest& request, const ToolPath& path,
                                                const JointPath& axes) const {
  constexpr double kRounding = 1e-5;  // the rates along a path are known to a millionth
  PlannedSegment::PaceCut cut;
  const double asked = pace_time(robot_, demand_of(path, axes), request) / boost_;
  if (!(asked > 0)) return cut;
  cut.asked = std::max(asked, request.at_least / boost_);
  double most = asked * (1 + kRounding);
  std::optional<double> from;
  double to = 0;
  axes.survey(kCutParts, [&](double s, const PathPoint& point) {
    for (int i = 0; i < robot_.axis_count(); ++i) {
      const double needed = std::abs(point.qd[i]) / robot_.axes[static_cast<std::size_t>(i)].v_max;
      if (!(needed > asked * (1 + kRounding))) continue;
      if (!from) from = s;
      to = s;
      if (needed <= most) continue;
      most = needed;
      cut.axis = i;
    }
  });
  if (!from) return cut;
  cut.turning = path.way() <= kSamePose;
  cut.way = cut.turning ? path.turn() : path.way();
  cut.from = path.share_at(*from) * cut.way;
  cut.to = path.share_at(to) * cut.way;
  return cut;
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
