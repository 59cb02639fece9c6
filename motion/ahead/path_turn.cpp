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

/// The mean of what accelerates evenly by a lies a·T²/24 beside it. What it moves a corner inwards
/// is taken off the zone, half of that at most: beyond it the corner is passed more slowly.
class MovedByMean {
 public:
  MovedByMean(const RobotModel& robot, const ShapedLeg& in, const ShapedLeg& out,
              const JointVector& turn, double average)
      : in_(in), out_(out), average_(average), even_(average * average / 24) {
    if (average == 0) return;
    unit_ = parabola_miss(robot, in, turn, 4);  // of a turn at unit acceleration
    reserve_ = turning_reserve(in, out, turn);
    along_ = std::max(greatest_control(in, in.at(in.length())), greatest_control(out, out.at(0)));
    bent_ =
        reserve_ + std::max(spare(in, in.at(in.length()), turn), spare(out, out.at(0), turn)) / 2;
    const LegBounds& zone = in.segment.ahead;
    reach_ = shrinking(unit_, zone.miss, zone.turn);
    // Of a curve's own bends as much is left to the mean as they may ever need.
    const double asked = straight(in, out) ? std::max(bent_, along_ / 2) * even_ : kAny;
    if (reach_ < kAny) part_ = 1 - std::min(asked / reach_, kUsual);
  }

  /// Of the zone, what is left to the corner itself.
  double part() const { return part_; }

  /// σ' in a corner of that length that bends by `peak`·|turn|/2·half at most.
  double fastest(double half, double peak) const {
    constexpr int kHalvings = 30;
    const Neighbours near = neighbours(half);
    const double room = std::min(reach_ - half / 4, shrinking(unit_, near.miss, kAny) * kUsual);
    const bool crowd = near.in || near.out;
    if (room == kAny || (crowd ? bent_ * even_ : moved(half, reserve_, bent_)) <= room) return kAny;
    double least = 2 * half / (average_ * average_);  // then it takes as long as the mean
    if (crowd || moved(half, least, least) >= room)
      return std::sqrt(room / even_ * 2 * half / peak);
    double most = reserve_;
    for (int i = 0; i < kHalvings; ++i) {
      const double middle = (least + most) / 2;
      (moved(half, middle, middle) <= room ? least : most) = middle;
    }
    return std::sqrt(least * 2 * half / peak);
  }

 private:
  static constexpr double kUsual = 0.5;  ///< [choice] of a zone

  /// σ'' that the axes have left in a corner taken as fast as can be.
  double spare(const ShapedLeg& leg, const PathPoint& place, const JointVector& turn) const {
    double most = kAny;
    for (int i = 0; i < turn.size(); ++i) {
      const double left = std::max(leg.acceleration[i] - std::abs(turn[i]) * reserve_, 0.0);
      const double slope = std::abs(place.qd[i]);
      if (slope * most > left) most = left / slope;
    }
    return most;
  }

  /// Of a corner run through at σ'² = 2·half·`turns`, with the acceleration `bent`, per unit of the
  /// turn. Where the mean lasts longer than the corner, braking before it and speeding up behind it
  /// count for a part: by half.
  double moved(double half, double turns, double bent) const {
    const double beyond = std::max(0.0, 1 - std::sqrt(2 * half / turns) / average_);
    const double part = beyond * beyond * beyond;
    return even_ * (bent * (1 - part) + along_ / 2 * part);
  }

  /// Corners at the other ends of the legs that the same mean takes in: their zones count, too,
  /// and they bend where this one does not.
  struct Neighbours {
    bool in = false;
    bool out = false;
    double miss = kAny;
  };
  Neighbours neighbours(double half) const {
    const double speed = std::sqrt(2 * half * reserve_);
    const double way = (speed + along_ * average_ / 4) * average_ / 2;
    Neighbours near{in_.length() / 2 <= way, out_.length() / 2 <= way};
    if (near.in) near.miss = std::min(near.miss, in_.before);
    if (near.out) near.miss = std::min(near.miss, out_.segment.ahead.miss);
    return near;
  }

  const ShapedLeg& in_;
  const ShapedLeg& out_;
  double average_;
  double even_;
  Miss unit_;
  double reserve_ = 0;
  double bent_ = 0;
  double along_ = 0;
  double reach_ = kAny;
  double part_ = 1;
};

std::optional<Turn> make_parabola(const RobotModel& robot, const ShapedLeg& in,
                                  const ShapedLeg& out, const TurnBounds& bounds) {
  const JointVector turn = turn_of(in, out);
  const LegBounds& zone = in.segment.ahead;
  const MovedByMean mean(robot, in, out, turn, bounds.average);
  Turn made;
  made.half = half_for_miss(robot, in, turn, bounds.longest, zone.miss * mean.part(),
                            zone.turn * mean.part());
  if (!(made.half >= kShortest)) return std::nullopt;
  if (bounds.average > 0) made.fastest = mean.fastest(made.half, 1);
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
  const double average = bounds.of_sigma ? 0 : bounds.average;
  const MovedByMean mean(robot, in, out, turn_of(in, out), average);
  Turn made;
  made.half = bounds.longest;
  for (int i = 0; i < kTries && made.half >= kShortest; ++i) {
    double factor = 0.5;
    if (auto axes = corner_axes(robot, task, made.half); axes && within_limits(robot, *axes)) {
      const JointVector middle = axes->at(0).q;
      Miss miss = miss_between(robot, zone.tip, middle, in.segment.target);
      miss.distance = std::min(miss.distance, corner_miss_of(robot, task, *axes));
      factor = shrinking(miss, zone.miss * mean.part(), zone.turn * mean.part());
      if (factor >= 1) {
        made.axes = std::move(*axes);
        if (average > 0) made.fastest = mean.fastest(made.half, kPeak);
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
  const double zone = std::min({leg.before, leg.segment.ahead.miss, robot.zone});
  for (Piece& piece : pieces) {
    for (const double at : {0.0, piece.length / 2, piece.length}) {
      const PathPoint point = piece.point(at);
      const Pose& tip = leg.segment.ahead.tip;
      const double unit = kStep / std::max(1.0, point.qdd.norm());
      const Miss miss = miss_between(robot, tip, point.q + unit * point.qdd, point.q);
      const double square =  // of σ'
          shrinking(miss, zone / 2, robot.zone_angle / 2) * unit / moved;
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
