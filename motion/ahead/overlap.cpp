#include "motion/ahead/overlap.h"

#include <algorithm>
#include <cmath>

#include "motion/ahead/miss.h"

namespace rob::motion {

namespace {

/// How the axes accelerate where the leg begins and ends.
JointVector rush_of(const ShapedLeg& leg) {
  const PathPoint place = leg.at(0);
  return greatest_control(leg, place) * place.qd;
}

/// s by which the ramps of both legs may overlap. In the middle of such an overlap δ both ramps are
/// mixed over δ/2 each, so the mean lies (out − in)·δ³/48·T beside the point.
double longest_overlap(const RobotModel& robot, const ShapedLeg& in, const JointVector& change,
                       double average) {
  constexpr int kTries = 4;
  const LegBounds& zone = in.segment.ahead;
  const JointVector& point = in.segment.target;
  const double most = average * average / 48;
  double moved = most;
  for (int i = 0; i < kTries; ++i) {
    const Miss miss = miss_between(robot, zone.tip, point + moved * change, point);
    const double factor = shrinking(miss, zone.miss, zone.turn);
    if (factor >= 1) break;
    moved *= factor;
  }
  return average * std::cbrt(moved / most);
}

/// s from rest to rest with a mean that is given (alone()).
double time_with(const RobotModel& robot, const ShapedLeg& leg, double share, double average) {
  const PathPoint begin = leg.at(0);
  const double a = share * greatest_control(leg, begin);
  const double speed = greatest_rate(robot, leg, begin);
  const double ramp = speed / a + average;
  const double half = average / 2;
  const double way = leg.length();
  return way >= speed * ramp ? way / speed + ramp : 2 * (half + std::sqrt(half * half + way / a));
}

}  // namespace

std::optional<Overlap> overlap_of(const RobotModel& robot, const ShapedLeg& in,
                                  const ShapedLeg& out, double average) {
  const LegBounds& zone = in.segment.ahead;
  const LegBounds& next = out.segment.ahead;
  const bool measured =
      std::isfinite(zone.miss) && zone.miss > 0 && zone.lead == LegBounds::kAny && zone.share == 1;
  if (!measured || next.window == 0 || robot.mechanics || out.motion.path != nullptr)
    return std::nullopt;
  Overlap made;
  made.share = std::min({2 * average / next.window, next.full / next.acceleration, 2.0});
  const JointVector before = rush_of(in);
  const JointVector after = made.share * rush_of(out);
  const JointVector most = average * in.jerk.cwiseMin(out.jerk);  // a mean over T changes by J·T
  constexpr double kSame = 1e-9;
  if (((before + after).cwiseAbs() - (1 + kSame) * most).maxCoeff() > 0) return std::nullopt;
  const double overlap = longest_overlap(robot, in, after - before, average);
  made.wait = average - overlap;
  made.won = alone(robot, out).time + overlap - time_with(robot, out, made.share, average);
  if (made.won <= robot.reference_period) return std::nullopt;
  return made;
}

LegAlone with_overlap(const RobotModel& robot, const ShapedLeg& in, const ShapedLeg& out,
                      const LegAlone& made) {
  constexpr double kSteps = 6;  // [choice] of a twelfth: ∛4 times as long is best for many alike
  const LegBounds& bounds = in.segment.ahead;
  if (!made.pauses || bounds.window == 0) return made;
  LegAlone best = made;
  double least = Piece::kAny;
  for (double k = 0; k <= kSteps; ++k) {
    LegAlone tried = made;
    tried.average *= 1 + k / 12;
    tried.share =
        std::min({2 * tried.average / bounds.window, bounds.full / bounds.acceleration, 2.0});
    const double average = whole_periods(robot, tried.average);
    tried.time = time_with(robot, in, tried.share, average);
    ShapedLeg first = in;
    first.acceleration *= tried.share;
    const auto overlap = overlap_of(robot, first, out, average);
    const double time = tried.time - (overlap ? overlap->won : 0);
    if (time >= least) break;
    least = time;
    best = tried;
  }
  return best;
}

double won_by_overlap(const RobotModel& robot, const ShapedLeg& in, const ShapedLeg& out) {
  if (in.motion.path != nullptr || in.segment.ahead.window == 0) return 0;
  const LegAlone made = alone(robot, in);
  if (!made.pauses) return 0;
  ShapedLeg first = in;
  const LegAlone longer = with_overlap(robot, in, out, made);
  first.acceleration *= longer.share;
  const auto overlap = overlap_of(robot, first, out, whole_periods(robot, longer.average));
  return overlap ? overlap->won - (longer.time - made.time) : 0;
}

}  // namespace rob::motion
