#include "motion/ahead/mean_shift.h"

#include <algorithm>
#include <cmath>

#include "motion/ahead/miss.h"

namespace rob::motion {

namespace {

constexpr double kAny = MeanShift::kAny;

/// [choice] A corner that turns by more, of the way, is sharp: 20 degrees.
constexpr double kSharp = 0.35;

/// [choice] Of the zone, what accelerations along the legs may take around a corner: half where it
/// is sharp, and nothing else counts; else a quarter, and the bend has the other.
constexpr double kOfSharp = 0.5;
constexpr double kOfGentle = 0.25;

/// How much each effect moves a corner, as a share of what its zone admits: the bend where the axes
/// give all they have, both legs, and either together.
struct Shares {
  double bend = 0;
  double legs = 0;
  double all = 0;
  bool sharp = false;

  void take(double bend_share, double legs_share, double most) {
    bend = std::max(bend, bend_share);
    legs = std::max(legs, legs_share);
    all = std::max(all, most);
  }
};

/// How the tip moves with each axis, m per m or rad: columns of three.
using TipRates = Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, kMaxJoints>;
TipRates tip_rates(const RobotModel& robot, const Pose& tip, const JointVector& q) {
  constexpr double kStep = 1e-6;
  TipRates rates(3, q.size());
  const Eigen::Vector3d here = place_of(tip.position, robot.kinematics->forward(q));
  for (int i = 0; i < q.size(); ++i) {
    JointVector beside = q;
    beside[i] += kStep;
    rates.col(i) = (place_of(tip.position, robot.kinematics->forward(beside)) - here) / kStep;
  }
  return rates;
}

Shares shares_of(const RobotModel& robot, const ShapedLeg& in, const ShapedLeg& out,
                 const JointVector& turn, double moved, const Miss& zone) {
  const double reserve = turning_reserve(in, out, turn);
  const JointVector most = in.acceleration.cwiseMax(out.acceleration);
  const PathPoint end = in.at(in.length());
  const PathPoint begin = out.at(0);
  const JointVector rush_in = greatest_control(in, end) * end.qd;
  const JointVector rush_out = greatest_control(out, begin) * begin.qd;
  Shares shares;
  const auto tip = tip_rates(robot, in.segment.ahead.tip, in.segment.target);
  const Eigen::Vector3d bend = tip * turn;
  if (bend.norm() > 0 && zone.distance < kAny) {
    const double ways = std::max((tip * end.qd).norm(), (tip * begin.qd).norm());
    shares.sharp = bend.norm() > kSharp * ways;
    const JointVector along = (tip.transpose() * bend.normalized()).eval();
    const double share = moved / zone.distance;
    shares.take(share * reserve * bend.norm(),
                share * std::max(std::abs(along.dot(rush_in)), std::abs(along.dot(rush_out))),
                share * along.cwiseAbs().dot(most));
  }
  for (int i = 0; i < turn.size(); ++i) {
    const bool rotary = robot.axes[static_cast<std::size_t>(i)].kind == AxisKind::Rotary;
    if (!rotary || turn[i] == 0 || zone.angle == kAny) continue;
    const double share = moved / zone.angle;
    shares.take(share * reserve * std::abs(turn[i]),
                share * std::max(std::abs(rush_in[i]), std::abs(rush_out[i])), share * most[i]);
  }
  return shares;
}

/// The zone of a corner, or a stricter one of a corner beside it that is passed within T/2 of it:
/// the mean mixes this one into that. From the one before it only the distance counts.
Miss strictest_zone(const RobotModel& robot, const ShapedLeg& in, const ShapedLeg& out,
                    const JointVector& turn, double average, double longest) {
  const LegBounds& own = in.segment.ahead;
  const LegBounds& next = out.segment.ahead;
  Miss zone{own.miss, own.turn};
  const double before = in.starts ? kAny : in.before;
  const double distance = out.ends || next.miss == 0 ? kAny : next.miss;
  const double angle = out.ends || next.turn == 0 ? kAny : next.turn;
  if (before >= own.miss && distance >= own.miss && angle >= own.turn) return zone;
  const double rate = std::min(greatest_rate(robot, in, in.at(in.length())),
                               std::sqrt(2 * longest * turning_reserve(in, out, turn)));
  const double reach = calm_way(in, out, 1, average, rate);
  if (in.length() < reach) zone.distance = std::min(zone.distance, before);
  if (out.length() >= reach) return zone;
  return {std::min(zone.distance, distance), std::min(zone.angle, angle)};
}

}  // namespace

double turns_in_zone(const RobotModel& robot, const ShapedLeg& in, const JointVector& turn,
                     double average) {
  const JointVector& point = in.segment.target;
  const Miss unit = miss_between(robot, in.segment.ahead.tip, point + turn, point);
  const double moved = average * average / 24;
  return shrinking(unit, in.segment.ahead.miss, in.segment.ahead.turn) / moved;
}

/// For legs of length l the mean leaves σ'² = turns·l, where turns is as 1/T², and the
/// accelerations reserve·l, where reserve is as T.
double bend_share(const RobotModel& robot, const ShapedLeg& in, const ShapedLeg& out,
                  double average) {
  if (in.motion.path != nullptr || out.motion.path != nullptr) return 1;
  const PathPoint end = in.at(in.length());
  const JointVector turn = out.at(0).qd - end.qd;
  const double length = (in.length() + out.length()) / 2;
  const double full = greatest_rate(robot, in, end);
  if (turn.norm() > kSharp * end.qd.norm() || length > full * average) return 1;
  const double turns = turns_in_zone(robot, in, turn, average);
  const double reserve = turning_reserve(in, out, turn);
  if (turns == kAny || turns * length >= full * full) return 1;
  return std::min(1.0, std::max(std::cbrt(turns / reserve), std::sqrt(turns * length) / full));
}

MeanShift mean_shift(const RobotModel& robot, const ShapedLeg& in, const ShapedLeg& out,
                     const JointVector& turn, double average, double longest) {
  MeanShift shift;
  if (average == 0) return shift;
  const double moved = average * average / 24;
  const Miss own{in.segment.ahead.miss, in.segment.ahead.turn};
  const Shares shares = shares_of(robot, in, out, turn, moved, own);
  const double around = shares.sharp ? shares.all : std::min(shares.legs, shares.all);
  const double most = shares.sharp ? kOfSharp : kOfGentle;
  if (around > most) shift.calm = most / around;
  const Miss zone = strictest_zone(robot, in, out, turn, average, longest);
  if (zone.distance < own.distance || zone.angle < own.angle) {
    const double beside = shares_of(robot, in, out, turn, moved, zone).all;
    if (kOfSharp < shift.calm * beside) shift.calm = kOfSharp / beside;
  }

  const JointVector& point = in.segment.target;
  const Miss unit = miss_between(robot, in.segment.ahead.tip, point + turn, point);
  const double reach = shrinking(unit, in.segment.ahead.miss, in.segment.ahead.turn);
  if (reach == kAny) return shift;
  // How much the corner itself can miss, and so what is left.
  const double left = std::max(0.5, 1 - longest / 4 / reach);
  const bool curved = in.motion.path != nullptr || out.motion.path != nullptr;
  const double asked =
      shift.calm * std::min(shares.all, shares.sharp ? kAny : shares.bend + shares.legs);
  const double used = curved ? left : std::min(asked, left);
  shift.part = 1 - used;
  if (used < asked) shift.turns = (used - shift.calm * around) * reach / moved;
  return shift;
}

double calm_way(const ShapedLeg& in, const ShapedLeg& out, double calm, double average,
                double rate) {
  const double control =
      std::max(greatest_control(in, in.at(in.length())), greatest_control(out, out.at(0)));
  return average / 2 * (rate + calm * control * average / 4);
}

double longest_calm_way(const RobotModel& robot, const ShapedLeg& leg, double average) {
  if (average == 0) return 0;
  const double moved = average * average / 24;
  const LegBounds& zone = leg.segment.ahead;
  const auto tip = tip_rates(robot, zone.tip, leg.segment.target);
  const double miss = leg.starts ? zone.miss : std::min(zone.miss, leg.before);
  double most = tip.colwise().norm().dot(leg.acceleration) * moved / miss;
  for (int i = 0; i < robot.axis_count(); ++i) {
    if (robot.axes[static_cast<std::size_t>(i)].kind == AxisKind::Rotary)
      most = std::max(most, leg.acceleration[i] * moved / zone.turn);
  }
  if (!(most > kOfGentle)) return 0;
  const PathPoint end = leg.at(leg.length());
  return average / 2 * (greatest_rate(robot, leg, end) + greatest_control(leg, end) * average / 4);
}

void bound_by_mean(const RobotModel& robot, const ShapedLeg& leg, double average,
                   std::vector<Piece>& pieces) {
  constexpr double kStep = 1e-6;  // s²: moves a point by less than any zone
  const double moved = average * average / 24;
  const double own = std::min(leg.before, leg.segment.ahead.miss);
  const double zone = leg.merged() ? own : std::min(own, robot.zone.distance);
  for (Piece& piece : pieces) {
    for (const double at : {0.0, piece.length / 2, piece.length}) {
      const PathPoint point = piece.point(at);
      const Pose& tip = leg.segment.ahead.tip;
      const double unit = kStep / std::max(1.0, point.qdd.norm());
      const Miss miss = miss_between(robot, tip, point.q + unit * point.qdd, point.q);
      const double square =
          shrinking(miss, zone / 2, robot.zone.angle / 2) * unit / moved;  // of σ'
      if (!(square < piece.fastest * piece.fastest)) continue;
      piece.fastest = std::sqrt(square);
      piece.fastest_axis = -1;
    }
  }
}

}  // namespace rob::motion
