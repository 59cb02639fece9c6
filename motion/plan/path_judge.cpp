#include "motion/plan/path_judge.h"

#include <algorithm>
#include <array>

#include "motion/plan/leg_demand.h"
#include "motion/plan/reach.h"

namespace rob::motion {

namespace {

/// The least share of the speed asked for that a motion may be slowed down to by the axes, before
/// it is refused as singular (2 %).
constexpr double kLeastShare = 0.02;

/// Refusal::at becomes a place on the way.
Refusal placed(Refusal refusal, const ToolPath& path) {
  refusal.turning = path.way() <= kSamePose;
  refusal.way = refusal.turning ? path.turn() : path.way();
  refusal.at = path.share_at(refusal.at) * refusal.way;
  return refusal;
}

}  // namespace

std::optional<Refusal> PathJudge::judge(const MotionRequest& request, const ToolPath& path,
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
  // Where the reach ends the arm is stretched: that says more than how fast it must be.
  const bool out = trouble && trouble->kind == PathTrouble::Kind::OutOfReach;
  const auto slow = out ? std::nullopt : too_slow(request, path, followed.axes);
  return slow && (!first || slow->at < first->at) ? slow : first;
}

Refusal PathJudge::refusal_for(const PathTrouble& trouble, const ToolPath& path,
                               const JointPath& axes) const {
  Refusal refusal;
  refusal.axis = trouble.axis;
  refusal.at = trouble.at;
  refusal.q = axes.nodes().empty() ? last_.q : axes.nodes().back().q;
  refusal.kind = trouble.kind == PathTrouble::Kind::TooLong ? Refusal::Kind::PathTooLong
                                                            : Refusal::Kind::PathSingular;
  if (trouble.kind != PathTrouble::Kind::OutOfReach) return refusal;
  refusal.kind = Refusal::Kind::PathOutOfReach;
  // [choice] a ten-thousandth of the path on, where the lack is greater than rounding
  const double beyond = std::min(trouble.at + 1e-4 * (path.end() - path.begin()), path.end());
  const Pose flange = composed(path.at(beyond), inverse(tip_.pose()));
  refusal.shortfall = robot_.kinematics->shortfall(flange);
  if (const auto closest = robot_.kinematics->closest(flange, refusal.q))
    refusal.nearest = tip_.pose_at(*closest);
  return refusal;
}

/// Where the axes allow too little of the speed that is asked for, or that they allow elsewhere.
std::optional<Refusal> PathJudge::too_slow(const MotionRequest& request, const ToolPath& path,
                                           const JointPath& axes) const {
  const LegDemand demand = demand_along(path, axes);
  const double asked =
      std::max(pace_time(robot_, demand, request), request.at_least) / timing_.boost();
  const Slowest slowest = slowest_place(robot_, path, axes, 1 / asked);
  if (slowest.share >= kLeastShare) return std::nullopt;
  Refusal refusal;
  refusal.kind = Refusal::Kind::PathSingular;
  refusal.axis = slowest.axis;
  refusal.at = slowest.at;
  refusal.q = axes.at(slowest.at).q;
  return placed(refusal, path);
}

bool PathJudge::reachable_otherwise(const ToolPath& path) const {
  const auto q = reach(robot_, composed(path.at(path.end()), inverse(tip_.pose())), last_.q);
  if (!q) return false;
  std::array<double, kMaxJoints> target{};
  std::copy(q->begin(), q->end(), target.begin());
  return !check_target(robot_, 0xff, target);
}

}  // namespace rob::motion
