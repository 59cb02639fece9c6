#include "motion/ahead/path_turn.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "motion/ahead/mean_shift.h"
#include "motion/ahead/miss.h"
#include "motion/ahead/overlap.h"
#include "motion/plan/corner.h"

namespace rob::motion {

namespace {

/// Slopes that differ by less, per m, are one.
constexpr double kSameSlope = 1e-9;

/// The greatest bend of a smooth corner over that of the parabola: 1.5 of Paul's quartic, 15/8 of a
/// quintic between even motions.
constexpr double kPeak = 2;

/// The greatest jerk of a smooth corner, in Δq'·σ'³/half²: of Paul's quartic between two lines of
/// the tool, and (30·max |2t − 6t² + 4t³| = 5.77)/4 of a quintic between even motions.
constexpr double kLinesJerk = 1.5;
constexpr double kAxesJerk = 1.45;

/// m: a corner that is shorter is no corner. [choice] a tenth of what any scale resolves
constexpr double kShortest = 1e-8;

JointVector turn_of(const ShapedLeg& in, const ShapedLeg& out) {
  return out.at(0).qd - in.at(in.length()).qd;
}

bool straight(const ShapedLeg& in, const ShapedLeg& out) {
  return in.motion.path == nullptr && out.motion.path == nullptr;
}

/// Where the mean is of σ the corner has a share of the jerk, too; slivers of it are parabolas,
/// which say nothing of theirs. s²/m: the greatest |Δq'|·jerk_factor/jerk of an axis, so that at σ'
/// half² >= that·σ'³.
double jerk_of(const ShapedLeg& in, const ShapedLeg& out, const JointVector& turn) {
  const bool lines = in.segment.ahead.line != nullptr && out.segment.ahead.line != nullptr;
  const JointVector least = kBendsShare * in.jerk.cwiseMin(out.jerk);
  return (lines ? kLinesJerk : kAxesJerk) * (turn.array().abs() / least.array()).maxCoeff();
}

/// So long that at the greatest speed of both legs the axes keep it, and that the mean of so even
/// a bend keeps the zone.
double half_for_speed(const RobotModel& robot, const ShapedLeg& in, const ShapedLeg& out,
                      const JointVector& turn) {
  double reserve = turning_reserve(in, out, turn);
  const double speed =
      std::max(greatest_rate(robot, in, in.at(in.length())), greatest_rate(robot, out, out.at(0)));
  const double peak = straight(in, out) && !robot.tool_coordinates ? 1 : kPeak;
  if (!robot.tool_coordinates)
    reserve = std::min(reserve, turns_in_zone(robot, in, turn, in.segment.ahead.window) / 2);
  const double half = peak * speed * speed / (2 * reserve);
  if (!robot.tool_coordinates) return half;
  return std::max(half, std::sqrt(jerk_of(in, out, turn) * speed * speed * speed));
}

/// The path may go straight on where no axis' speed changes by more than [choice] a hundredth of
/// what it can gain in a period, or the corner would be none: a turn as rounded digits make it.
/// Where the mean is of σ nothing smooths that change: the jerk counts, too.
bool goes_straight_on(const RobotModel& robot, const ShapedLeg& in, const ShapedLeg& out,
                      const JointVector& turn, const TurnBounds& bounds) {
  constexpr double kShare = 0.01;
  const double period = robot.reference_period;
  const double speed =
      std::max(greatest_rate(robot, in, in.at(in.length())), greatest_rate(robot, out, out.at(0)));
  JointVector most = kShare * period * in.acceleration.cwiseMin(out.acceleration);
  if (bounds.of_sigma)
    most = most.cwiseMin(kBendsShare * period * period * in.jerk.cwiseMin(out.jerk));
  if ((speed * turn.cwiseAbs() - most).maxCoeff() <= 0) return true;
  return !bounds.of_sigma && half_for_speed(robot, in, out, turn) < kShortest;
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

/// Drives around the corner with less than the axes have.
void calm_down(const ShapedLeg& in, const ShapedLeg& out, const JointVector& turn,
               const MeanShift& shift, double average, Turn& made) {
  if (shift.calm == 1) return;
  made.calm = shift.calm;
  const double square = shift.calm * turning_reserve(in, out, turn) * 2 * made.half;
  made.fastest = std::min(made.fastest, std::sqrt(square));
  made.calm_way = std::max(made.half, calm_way(in, out, shift.calm, average, made.fastest));
}

/// s from the middle of a corner to the middle of a leg beside it, and as fast there as can be.
double half_time(const RobotModel& robot, const ShapedLeg& leg, const PathPoint& place,
                 const Turn& made) {
  const double control = greatest_control(leg, place);
  const double full = greatest_rate(robot, leg, place);
  const double rate = std::min(made.fastest, full);
  const double half = leg.length() / 2;
  const double turns = std::min(made.half, half);
  const double calm = std::max(std::min(made.calm_way, half) - turns, 0.0);
  const double after = std::min(full, std::sqrt(rate * rate + 2 * made.calm * control * calm));
  const double rest = half - turns - calm;
  const double top = std::min(full, std::sqrt(after * after + 2 * control * rest));
  const double gains = (top * top - after * after) / (2 * control);
  return (turns > 0 ? turns / rate : 0) + (calm > 0 ? 2 * calm / (rate + after) : 0) +
         (top - after) / control + (rest - gains) / top;
}

/// s that so calm a corner costs beside a point that is passed at full speed: until full speed is
/// reached, whatever leg that is on.
double lost_around(const RobotModel& robot, const ShapedLeg& leg, const PathPoint& place,
                   const Turn& made) {
  const double control = greatest_control(leg, place);
  const double full = greatest_rate(robot, leg, place);
  const double rate = std::min(made.fastest, full);
  const double way = made.calm_way - made.half;
  const double after = std::min(full, std::sqrt(rate * rate + 2 * made.calm * control * way));
  const double around = made.half / rate + 2 * way / (rate + after);
  return around - made.calm_way / full + (full - after) * (full - after) / (2 * control * full);
}

/// s by which a stop is faster than so calm a corner on one of its sides. A leg that would stand
/// alone then is looked at up to its middle; if it has no other corner either, its end has half of
/// the run's mean with this one, and half of its own without. Else the stop costs what speeding up
/// does, and half of the mean's time.
double won_by_stop(const RobotModel& robot, const ShapedLeg& leg, const PathPoint& place,
                   const Turn& made, bool stands_alone, const TurnBounds& bounds) {
  const double average = bounds.average;
  if (stands_alone && leg.motion.path == nullptr) {
    const LegAlone stood = alone(robot, leg);
    const double end = bounds.whole_run ? (average - stood.average) / 2 : 0;
    return half_time(robot, leg, place, made) + end - stood.time / 2;
  }
  const double ramp = greatest_rate(robot, leg, place) / (2 * greatest_control(leg, place));
  return lost_around(robot, leg, place, made) - ramp - average / 2;
}

bool stops_as_fast(const RobotModel& robot, const ShapedLeg& in, const ShapedLeg& out,
                   const Turn& made, const TurnBounds& bounds) {
  const double overlap = bounds.from_rest && bounds.to_rest ? won_by_overlap(robot, in, out) : 0;
  if (made.calm == 1 && overlap == 0) return false;
  return won_by_stop(robot, in, in.at(in.length()), made, bounds.from_rest, bounds) +
             won_by_stop(robot, out, out.at(0), made, bounds.to_rest, bounds) + overlap >=
         0;
}

std::optional<Turn> make_parabola(const RobotModel& robot, const ShapedLeg& in,
                                  const ShapedLeg& out, const JointVector& turn,
                                  const TurnBounds& bounds) {
  const LegBounds& zone = in.segment.ahead;
  const MeanShift shift = mean_shift(robot, in, out, turn, bounds.average, bounds.longest);
  Turn made;
  made.half = half_for_miss(robot, in, turn, bounds.longest, zone.miss * shift.part,
                            zone.turn * shift.part);
  if (!(made.half >= kShortest)) return std::nullopt;
  made.fastest = std::sqrt(shift.turns * 2 * made.half);
  calm_down(in, out, turn, shift, bounds.average, made);
  if (stops_as_fast(robot, in, out, made, bounds)) return std::nullopt;
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

bool between_lines(const CornerTask& task) {
  return task.line_in != nullptr && task.line_out != nullptr;
}

/// None where they leave the axes' limits, or where a curve winds round the point.
std::optional<JointPath> smooth_axes(const RobotModel& robot, const CornerTask& task, double half) {
  if (!between_lines(task) && winds_round(robot, task, half)) return std::nullopt;
  auto axes = corner_axes(robot, task, half);
  return axes && within_limits(robot, *axes) ? std::move(axes) : std::nullopt;
}

Miss smooth_miss(const RobotModel& robot, const CornerTask& task, const JointPath& axes,
                 const JointVector& point) {
  Miss miss = miss_between(robot, task.tip, axes.at(0).q, point);
  miss.distance = std::min(miss.distance, corner_miss_of(robot, task, axes));
  if (!between_lines(task)) miss.distance = std::max(miss.distance, beside_ways(robot, task, axes));
  return miss;
}

std::optional<Turn> make_curve(const RobotModel& robot, const ShapedLeg& in, const ShapedLeg& out,
                               const JointVector& turn, const TurnBounds& bounds) {
  constexpr int kTries = 16;
  const LegBounds& zone = in.segment.ahead;
  const CornerTask task{in.motion, out.motion, zone.line, out.segment.ahead.line, zone.tip};
  const double average = bounds.of_sigma ? 0 : bounds.average;
  const MeanShift shift = mean_shift(robot, in, out, turn, average, bounds.longest);
  Turn made;
  made.half = bounds.longest;
  for (int i = 0; i < kTries && made.half >= kShortest; ++i) {
    double factor = 0.5;
    if (auto axes = smooth_axes(robot, task, made.half)) {
      const Miss miss = smooth_miss(robot, task, *axes, in.segment.target);
      factor = shrinking(miss, zone.miss * shift.part, zone.turn * shift.part);
      if (factor >= 1) {
        made.axes = std::move(*axes);
        made.fastest = std::sqrt(shift.turns * 2 * made.half / kPeak);
        if (bounds.of_sigma)
          made.fastest =
              std::min(made.fastest, std::cbrt(made.half * made.half / jerk_of(in, out, turn)));
        calm_down(in, out, turn, shift, average, made);
        if (stops_as_fast(robot, in, out, made, bounds)) return std::nullopt;
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
  const double half = std::min(
      {half_for_zone(in, out), half_for_speed(robot, in, out, turn), in.length(), out.length()});
  return half_for_miss(robot, in, turn, half, in.segment.ahead.miss, in.segment.ahead.turn);
}

std::optional<Turn> make_turn(const RobotModel& robot, const ShapedLeg& in, const ShapedLeg& out,
                              const TurnBounds& bounds) {
  const JointVector turn = turn_of(in, out);
  if (turn.cwiseAbs().maxCoeff() <= kSameSlope) return Turn{};
  if (goes_straight_on(robot, in, out, turn, bounds)) return Turn{};
  TurnBounds within = bounds;
  within.longest =
      std::min({bounds.longest, half_for_zone(in, out), half_for_speed(robot, in, out, turn)});
  if (straight(in, out) && !bounds.of_sigma) return make_parabola(robot, in, out, turn, within);
  return make_curve(robot, in, out, turn, within);
}

}  // namespace rob::motion
