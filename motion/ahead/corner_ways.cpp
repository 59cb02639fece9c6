#include "motion/ahead/corner_ways.h"

#include <algorithm>

#include "motion/ahead/path_turn.h"
#include "motion/path/paul_transition.h"

namespace rob::motion {

namespace {

constexpr int kWays = 12;    // [choice] from short to long
constexpr int kPlaces = 16;  // [choice] of each

std::vector<JointVector> pauls_way(const LastTarget& before, const SegmentMotion& out) {
  constexpr int kOfPaul = 64;  // [choice] between two the way is straight but for micrometres
  std::vector<JointVector> way;
  if (out.corner != nullptr) {
    out.corner->axes.survey(kPlaces, [&](double, const PathPoint& at) { way.push_back(at.q); });
    return way;
  }
  const double half = before.t_acc;
  const LegMotion& in = before.before.motion;
  const JointVector from = in.at(in.duration - half).q;
  const PaulTransition law(from, before.q, out.target, out.duration, half);
  for (int i = 0; i <= kOfPaul; ++i) way.push_back(law.sample(half * (2.0 * i / kOfPaul - 1)).q);
  return way;
}

ShapedLeg twice_as_fast(const RobotModel& robot, const SegmentMotion& motion) {
  SegmentDescriptor segment;
  static_cast<SegmentMotion&>(segment) = motion;
  segment.ahead.speed *= 2;
  return shaped_leg(robot, segment, 0);
}

/// m of σ before and after the point within which the references may leave the two motions.
double reach_of(const RobotModel& robot, const SegmentMotion& in, const SegmentMotion& out) {
  const ShapedLeg leg = twice_as_fast(robot, in);
  const ShapedLeg next = twice_as_fast(robot, out);
  const double speed = std::max(greatest_rate(robot, leg, leg.at(leg.length())),
                                greatest_rate(robot, next, next.at(0)));
  const double mean = whole_periods(robot, std::max(in.ahead.window, out.ahead.window));
  return wanted_half(robot, leg, next) + speed * mean / 2;
}

/// By how much each axis is beside the straight way between two shares of a motion, at most.
JointVector bulge(const LegMotion& leg, double from, double to) {
  constexpr int kParts = 8;
  const JointVector begin = leg.along(from, 0, 0).q;
  const JointVector way = leg.along(to, 0, 0).q - begin;
  JointVector most = JointVector::Zero(begin.size());
  for (int i = 1; i < kParts; ++i) {
    const double share = static_cast<double>(i) / kParts;
    const JointVector at = leg.along(from + share * (to - from), 0, 0).q;
    most = most.cwiseMax((at - begin - share * way).cwiseAbs());
  }
  return most;
}

std::vector<JointVector> parabola(const JointVector& from, const JointVector& point,
                                  const JointVector& to) {
  std::vector<JointVector> way;
  for (int i = 0; i <= kPlaces; ++i) {
    const double t = static_cast<double>(i) / kPlaces;
    way.push_back((1 - t) * (1 - t) * from + 2 * t * (1 - t) * point + t * t * to);
  }
  return way;
}

CornerWays parabolas(const RobotModel& robot, const LastTarget& before, const SegmentMotion* in,
                     const SegmentMotion& out) {
  const LegMotion into = in == nullptr
                             ? before.before.motion
                             : LegMotion{in->path, in->ahead.from, in->target, in->duration};
  const LegMotion out_of{out.path, before.q, out.target, out.duration};
  double share_in = 1;
  double share_out = 1;
  if (in != nullptr) {
    const double reach = reach_of(robot, *in, out);
    share_in = std::min(1.0, reach / in->ahead.length);
    share_out = std::min(1.0, reach / out.ahead.length);
  }
  CornerWays all;
  for (int k = 1; k <= kWays; ++k) {
    const double part = static_cast<double>(k) / kWays;
    all.ways.push_back(parabola(into.along(1 - part * share_in, 0, 0).q, before.q,
                                out_of.along(part * share_out, 0, 0).q));
  }
  const std::vector<JointVector>& longest = all.ways.back();
  const JointVector bend = longest.front() - 2 * before.q + longest.back();
  all.beside =
      bend.cwiseAbs() / (4 * kWays) + bulge(into, 1 - share_in, 1) + bulge(out_of, 0, share_out);
  return all;
}

}  // namespace

CornerWays corner_ways(const RobotModel& robot, const LastTarget& before, const SegmentMotion* in,
                       const SegmentMotion& out) {
  if (before.exact || out.from_rest || out.ends_at_rest()) return {};
  if (robot.law == Law::LookAhead)
    return out.ahead.length > 0 ? parabolas(robot, before, in, out) : CornerWays{};
  return {{pauls_way(before, out)}, JointVector::Zero(before.q.size())};
}

}  // namespace rob::motion
