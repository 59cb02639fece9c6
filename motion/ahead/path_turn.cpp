#include "motion/ahead/path_turn.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "motion/plan/corner.h"

namespace rob::motion {

namespace {

constexpr double kAny = std::numeric_limits<double>::infinity();

/// Slopes that differ by less, per m, are one.
constexpr double kSameSlope = 1e-9;

/// The greatest bend of a smooth corner over that of the parabola: 1.5 of Paul's quartic, 15/8 of a
/// quintic between even motions.
constexpr double kPeak = 2;

/// m: a corner that is shorter is no corner. [choice] a tenth of what any scale resolves
constexpr double kShortest = 1e-8;

struct Miss {
  double distance = 0;  ///< m, of the tip
  double angle = 0;     ///< rad, of the tool and of each rotary axis
};

Miss miss_between(const RobotModel& robot, const Pose& tip, const JointVector& q,
                  const JointVector& point) {
  Miss miss;
  const Pose a = robot.kinematics->forward(q);
  const Pose b = robot.kinematics->forward(point);
  miss.distance = (place_of(tip.position, a) - place_of(tip.position, b)).norm();
  miss.angle = a.orientation.angularDistance(b.orientation);
  if (robot.tool_coordinates) return miss;
  for (int i = 0; i < robot.axis_count(); ++i) {
    if (robot.axes[static_cast<std::size_t>(i)].kind == AxisKind::Rotary)
      miss.angle = std::max(miss.angle, std::abs(q[i] - point[i]));
  }
  return miss;
}

/// By how much to shrink a corner that misses so much; 1 and more: not at all.
double shrinking(const Miss& miss, double distance, double angle) {
  double factor = kAny;
  if (miss.distance > 0) factor = std::min(factor, distance / miss.distance);
  if (miss.angle > 0) factor = std::min(factor, angle / miss.angle);
  return factor;
}

JointVector turn_of(const ShapedLeg& in, const ShapedLeg& out) {
  return out.at(0).qd - in.at(in.length()).qd;
}

/// The greatest |d²σ-free acceleration| of a corner per unit of turn: min A_i/|Δq'_i|.
double turning_reserve(const ShapedLeg& in, const ShapedLeg& out, const JointVector& turn) {
  double least = kAny;
  for (int i = 0; i < turn.size(); ++i) {
    const double most = std::min(in.acceleration[i], out.acceleration[i]);
    if (std::abs(turn[i]) * least > most) least = most / std::abs(turn[i]);
  }
  return least;
}

bool straight(const ShapedLeg& in, const ShapedLeg& out) {
  return in.motion.path == nullptr && out.motion.path == nullptr;
}

/// So long that the axes keep the greatest speed of both legs in it.
double half_for_speed(const RobotModel& robot, const ShapedLeg& in, const ShapedLeg& out) {
  const JointVector turn = turn_of(in, out);
  const double reserve = turning_reserve(in, out, turn);
  const double speed =
      std::max(greatest_rate(robot, in, in.at(in.length())), greatest_rate(robot, out, out.at(0)));
  const double peak = straight(in, out) && !robot.tool_coordinates ? 1 : kPeak;
  return peak * speed * speed / (2 * reserve);
}

double half_for_zone(const ShapedLeg& in, const ShapedLeg& out) {
  const LegBounds& bounds = in.segment.ahead;
  double half = std::min({bounds.lead, bounds.last, out.segment.ahead.first});
  if (bounds.share < 1)
    half = std::min(half, bounds.share / 2 * std::min(in.length(), out.length()));
  return half;
}

/// The parabola's middle lies Δq'·half/4 from the point.
Miss parabola_miss(const RobotModel& robot, const ShapedLeg& in, const JointVector& turn,
                   double half) {
  const JointVector& point = in.segment.target;
  return miss_between(robot, in.segment.ahead.tip, point + turn * (half / 4), point);
}

double half_for_miss(const RobotModel& robot, const ShapedLeg& in, const JointVector& turn,
                     double half, double distance, double angle) {
  constexpr int kTries = 6;
  for (int i = 0; i < kTries; ++i) {
    const double factor = shrinking(parabola_miss(robot, in, turn, half), distance, angle);
    if (factor >= 1) break;
    half *= factor * (1 - 1e-9);
  }
  return half;
}

/// What the mean moves a corner inwards is taken off its zone, half of that at most: beyond it the
/// corner is passed more slowly.
struct Moved {
  double part = 1;      ///< of the zone that is left
  double turns = kAny;  ///< σ'²/2·half that it admits, 1/(1/q') of the turn
};

/// The mean of what accelerates evenly lies a·T²/24 beside it.
Moved moved_by_mean(const RobotModel& robot, const ShapedLeg& in, const ShapedLeg& out,
                    const JointVector& turn, double average) {
  const double moved = average * average / 24;
  if (moved == 0) return {};
  const LegBounds& zone = in.segment.ahead;
  const Miss pace = parabola_miss(robot, in, turn, 4);  // of a turn at unit acceleration
  const double reach = std::min(pace.distance > 0 ? zone.miss / pace.distance : kAny,
                                pace.angle > 0 ? zone.turn / pace.angle : kAny);
  const double asked = turning_reserve(in, out, turn) * moved;
  // Of a curve's own bends as much is left to the mean as they may ever need.
  const double used = straight(in, out) ? std::min(asked, reach / 2) : reach / 2;
  return {reach < kAny ? 1 - used / reach : 1, used < asked ? used / moved : kAny};
}

std::optional<Turn> make_parabola(const RobotModel& robot, const ShapedLeg& in,
                                  const ShapedLeg& out, const TurnBounds& bounds) {
  const JointVector turn = turn_of(in, out);
  const LegBounds& zone = in.segment.ahead;
  const Moved moved = moved_by_mean(robot, in, out, turn, bounds.average);
  Turn made;
  made.half = half_for_miss(robot, in, turn, bounds.longest, zone.miss * moved.part,
                            zone.turn * moved.part);
  if (!(made.half >= kShortest)) return std::nullopt;
  made.fastest = std::sqrt(moved.turns * 2 * made.half);
  return made;
}

bool within_limits(const RobotModel& robot, const JointPath& axes) {
  bool within = true;
  axes.survey(8, [&](double, const PathPoint& place) {
    for (int i = 0; i < robot.axis_count(); ++i) {
      const Axis& axis = robot.axes[static_cast<std::size_t>(i)];
      within = within && place.q[i] >= axis.min - 1e-9 && place.q[i] <= axis.max + 1e-9;
    }
  });
  return within;
}

std::optional<Turn> make_curve(const RobotModel& robot, const ShapedLeg& in, const ShapedLeg& out,
                               const TurnBounds& bounds) {
  constexpr int kTries = 16;
  const LegBounds& zone = in.segment.ahead;
  const CornerTask task{in.motion, out.motion, zone.line, out.segment.ahead.line, zone.tip};
  const Moved moved =
      moved_by_mean(robot, in, out, turn_of(in, out), bounds.of_sigma ? 0 : bounds.average);
  Turn made;
  made.half = bounds.longest;
  for (int i = 0; i < kTries && made.half >= kShortest; ++i) {
    double factor = 0.5;
    if (auto axes = corner_axes(robot, task, made.half); axes && within_limits(robot, *axes)) {
      const JointVector middle = axes->at(0).q;
      Miss miss = miss_between(robot, zone.tip, middle, in.segment.target);
      miss.distance = std::min(miss.distance, corner_miss_of(robot, task, *axes));
      factor = shrinking(miss, zone.miss * moved.part, zone.turn * moved.part);
      if (factor >= 1) {
        made.axes = std::move(*axes);
        made.fastest = std::sqrt(moved.turns * 2 * made.half / kPeak);
        return made;
      }
    }
    made.half *= std::clamp(factor * (1 - 1e-4), 0.05, 0.95);
  }
  return std::nullopt;
}

}  // namespace

double wanted_half(const RobotModel& robot, const ShapedLeg& in, const ShapedLeg& out) {
  const JointVector turn = turn_of(in, out);
  if (turn.cwiseAbs().maxCoeff() <= kSameSlope) return 0;
  const double half =
      std::min({half_for_zone(in, out), half_for_speed(robot, in, out), in.length(), out.length()});
  return half_for_miss(robot, in, turn, half, in.segment.ahead.miss, in.segment.ahead.turn);
}

void bound_by_mean(const RobotModel& robot, const ShapedLeg& leg, double average,
                   std::vector<Piece>& pieces) {
  constexpr double kStep = 1e-6;  // s²: moves a point by less than any zone
  const double moved = average * average / 24;
  for (Piece& piece : pieces) {
    for (const double at : {0.0, piece.length / 2, piece.length}) {
      const PathPoint point = piece.point(at);
      const Pose& tip = leg.segment.ahead.tip;
      const double unit = kStep / std::max(1.0, point.qdd.norm());
      const Miss miss = miss_between(robot, tip, point.q + unit * point.qdd, point.q);
      const double square =
          shrinking(miss, leg.beside, robot.zone_angle / 2) * unit / moved;  // of σ'
      if (!(square < piece.fastest * piece.fastest)) continue;
      piece.fastest = std::sqrt(square);
      piece.fastest_axis = -1;
    }
  }
}

std::optional<Turn> make_turn(const RobotModel& robot, const ShapedLeg& in, const ShapedLeg& out,
                              const TurnBounds& bounds) {
  TurnBounds within = bounds;
  within.longest =
      std::min({bounds.longest, half_for_zone(in, out), half_for_speed(robot, in, out)});
  const JointVector turn = turn_of(in, out);
  if (turn.cwiseAbs().maxCoeff() <= kSameSlope) return Turn{};
  if (straight(in, out) && !bounds.of_sigma) return make_parabola(robot, in, out, within);
  return make_curve(robot, in, out, within);
}

}  // namespace rob::motion
