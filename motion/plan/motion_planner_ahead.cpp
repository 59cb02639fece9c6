#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "motion/plan/ahead_leg.h"
#include "motion/plan/motion_planner.h"
#include "motion/plan/torque_row.h"

/// Member functions of MotionPlanner for the look-ahead law. They say what a motion asks for; its
/// time is known only after its neighbours are.
namespace rob::motion {

namespace {

/// rad: of a corner that turns by less there is nothing to miss. [choice] 0.1 deg
constexpr double kStraightOn = 0.1 * std::numbers::pi / 180;

/// Only linear axes move.
bool is_linear(const RobotModel& robot, const JointVector& way) {
  for (int i = 0; i < robot.axis_count(); ++i)
    if (robot.axes[static_cast<std::size_t>(i)].kind == AxisKind::Rotary && way[i] != 0)
      return false;
  return true;
}

}  // namespace

PlanOutcome MotionPlanner::take_ahead(const MotionRequest& request, Draft draft) {
  PlannedSegment planned;
  planned.pace_cut = draft.pace_cut;
  SegmentDescriptor& segment = planned.segment;
  segment = segment_to(draft.target, false, {});
  segment.duration = robot_.reference_period;  // of a target that is the last one: it is passed
  if (draft.no_length) {
    bound_corner(robot_, request, LegBounds::kAny, segment.ahead);
  } else {
    const AheadLeg leg = ahead_leg(robot_, draft.demand, request);
    if (!(leg.alone <= kLongest)) return Refusal{Refusal::Kind::TooLong, -1, leg.alone, kLongest};
    if (const auto refusal = too_heavy(draft)) return *refusal;
    segment.ahead = leg.bounds;
    segment.ahead.mechanics = mechanics_;
    if (draft.leg && draft.leg->line) segment.ahead.line = &*draft.leg->line;
    segment.duration = leg.duration;
    segment.path = draft.demand.path;
    segment.live.unit_time = live_unit_time(robot_, draft.demand, request);
    planned.warnings = leg.warnings;
    if (!exact_) judge_zone(draft, planned);
  }
  segment.ahead.from = commanded_;
  segment.ahead.tip = tool_;
  before_ = {{segment.path, commanded_, segment.target, segment.duration}, draft.leg, tool_};
  if (request.zone == MotionRequest::Zone::Length) before_.zone = request.zone_value;
  before_.tag = request.tag;
  commit(request.tag, segment);
  planned.leg = std::move(draft.leg);
  keep(planned.leg);
  return planned;
}

/// A place of the way where a gear or a drive does not bear what the arm weighs there.
std::optional<Refusal> MotionPlanner::too_heavy(const Draft& draft) const {
  if (mechanics_ == nullptr) return std::nullopt;
  std::optional<Refusal> found;
  const auto look = [&](double s, const JointVector& q) {
    const auto heavy = found ? std::nullopt : overload(robot_, *mechanics_, q);
    if (!heavy) return;
    found = Refusal{Refusal::Kind::TooHeavy, heavy->axis, heavy->weight, heavy->limit};
    found->turning = !(draft.demand.way > 0);
    found->way = found->turning ? draft.demand.turn : draft.demand.way;
    found->at = s * found->way;
    found->q = q;
  };
  if (draft.demand.path != nullptr) {
    draft.demand.path->survey(1, [&](double s, const PathPoint& place) { look(s, place.q); });
    return found;
  }
  constexpr double kApart = 2 * std::numbers::pi / 180;  // [choice] weight hardly changes between
  const JointVector way = draft.target - commanded_;
  const int parts = 1 + static_cast<int>(way.cwiseAbs().maxCoeff() / kApart);
  for (int k = 0; k <= parts; ++k) look(double(k) / parts, commanded_ + way * (double(k) / parts));
  return found;
}

/// A parabola between two straight ways of the tip, along unit vectors u and v, which begins and
/// ends l away from their point, misses that by l·|v − u|/4.
void MotionPlanner::judge_zone(const Draft& draft, PlannedSegment& planned) const {
  const LegMotion& in = before_.motion;
  const bool straight = !robot_.tool_coordinates && in.path == nullptr &&
                        draft.demand.path == nullptr && arms_.isZero();
  if (!straight || !std::isfinite(before_.zone)) return;
  const bool merged = planned.segment.ahead.window == 0 && is_linear(robot_, in.to - in.from) &&
                      is_linear(robot_, draft.target - in.to);
  if (merged) return;  // where legs are too short for their corners they become a curve
  const Eigen::Vector3d first = tip(in.to) - tip(in.from);
  const Eigen::Vector3d second = tip(draft.target) - tip(in.to);
  if (first.isZero() || second.isZero()) return;
  const double turn = (second.normalized() - first.normalized()).norm();
  const double left = std::min(first.norm(), second.norm()) * turn / 4;
  if (turn < kStraightOn || before_.zone <= left) return;
  planned.warnings |= PlannedSegment::kZoneCut;
  planned.zone_tag = before_.tag;
  planned.zone_left = left;
}

/// Where the tip swings beside its straight way: how far it goes, by Simpson's rule, and its
/// greatest speed, by parabolas through the samples.
void MotionPlanner::measure_swing(const JointVector& target, LegDemand& demand) const {
  if (swing_to(target) == 0) return;
  constexpr double kStep = 1e-4;                           // of the leg, for differences
  constexpr double kApart = 2.5 * std::numbers::pi / 180;  // [choice] cosines bend little between
  const JointVector way = target - commanded_;
  const auto speed = [&](double s) {
    const JointVector step = way * kStep;
    const JointVector q = commanded_ + way * s;
    return (tip(q + step) - tip(q - step)).norm() / (2 * kStep);
  };
  const int half = 4 + static_cast<int>(demand.turn / kApart / 2);
  double a = 0;
  double b = 0;
  double sum = 0;
  double greatest = 0;
  for (int k = 0; k <= 2 * half; ++k) {
    const double c = speed(k / (2.0 * half));
    const bool end = k == 0 || k == 2 * half;
    sum += c * (end ? 1 : k % 2 == 1 ? 4 : 2);
    greatest = std::max(greatest, c);
    if (k >= 2 && b > a && b >= c)
      greatest = std::max(greatest, b + (a - c) * (a - c) / (8 * (2 * b - a - c)));
    a = std::exchange(b, c);
  }
  demand.way = sum / (6 * half);
  demand.pace_way = greatest;
}

}  // namespace rob::motion
