#include "motion/plan/ahead_judge.h"

#include <algorithm>
#include <cmath>

#include "base/unit_factors.h"
#include "motion/plan/torque_row.h"

namespace rob::motion {

namespace {

/// rad: of a corner that turns by less there is nothing to miss. [choice] 0.1 deg
constexpr double kStraightOn = 0.1 * kDegree;

/// Only linear axes move.
bool is_linear(const RobotModel& robot, const JointVector& way) {
  for (int i = 0; i < robot.axis_count(); ++i)
    if (robot.axes[static_cast<std::size_t>(i)].kind == AxisKind::Rotary && way[i] != 0)
      return false;
  return true;
}

}  // namespace

std::optional<Refusal> too_heavy(const RobotModel& robot, const ArmMechanics& mechanics,
                                 const JointVector& from, const MotionDraft& draft) {
  std::optional<Refusal> found;
  const auto look = [&](double s, const JointVector& q) {
    const auto heavy = found ? std::nullopt : overload(robot, mechanics, q);
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
  constexpr double kApart = 2 * kDegree;  // [choice] weight hardly changes between
  const JointVector way = draft.target - from;
  const int parts = 1 + static_cast<int>(way.cwiseAbs().maxCoeff() / kApart);
  for (int k = 0; k <= parts; ++k) look(double(k) / parts, from + way * (double(k) / parts));
  return found;
}

/// A parabola between two straight ways of the tip, along unit vectors u and v, which begins and
/// ends l away from their point, misses that by l·|v − u|/4.
void judge_zone(const RobotModel& robot, const ToolTip& tip, const LastTarget& last,
                const MotionDraft& draft, PlannedSegment& planned) {
  const LegMotion& in = last.before.motion;
  const bool straight = !robot.tool_coordinates && in.path == nullptr &&
                        draft.demand.path == nullptr && !tip.swings();
  if (!straight || !std::isfinite(last.before.zone)) return;
  const bool merged = planned.segment.ahead.window == 0 && is_linear(robot, in.to - in.from) &&
                      is_linear(robot, draft.target - in.to);
  if (merged) return;  // where legs are too short for their corners they become a curve
  const Eigen::Vector3d first = tip.place_at(in.to) - tip.place_at(in.from);
  const Eigen::Vector3d second = tip.place_at(draft.target) - tip.place_at(in.to);
  if (first.isZero() || second.isZero()) return;
  const double turn = (second.normalized() - first.normalized()).norm();
  const double left = std::min(first.norm(), second.norm()) * turn / 4;
  if (turn < kStraightOn || last.before.zone <= left) return;
  planned.warnings |= PlannedSegment::kZoneCut;
  planned.zone_tag = last.before.tag;
  planned.zone_left = left;
}

}  // namespace rob::motion
