#include "motion/ahead/path_shape.h"

#include <algorithm>
#include <cmath>

#include "base/unit_factors.h"
#include "motion/space/quintic.h"

namespace rob::motion {

namespace {

/// [choice] rad that an axis turns in a piece at most: what a piece has as one stretch of even σ''
/// is then as good as the time-optimal within a part in a thousand (tests/motion/ahead).
constexpr double kMostTurn = kDegree;
/// [choice] The same of its direction: what a circle's axes ask for between the ends of a piece is
/// 1 − cos of half of this above what they ask for there, a third of a thousandth.
constexpr double kMostBend = 0.05;

/// [choice] In a corner, on each side: enough for the speed to change on the way.
constexpr int kMostCornerPieces = 8;

/// [choice] On each side of a corner that is no parabola: with 16 no axis passes its acceleration
/// by 2 % between the ends of pieces, where it is held (time_optimal_test).
constexpr int kTurnPieces = 16;

/// Half of the σ' at which a bend takes all that the axes have: three quarters are left to brake.
double half_speed(const Piece& piece) {
  double square = Piece::kAny;
  for (const double at : {0.0, piece.length / 2, piece.length}) {
    const JointVector bend = piece.point(at).qdd;
    for (int i = 0; i < bend.size(); ++i) {
      if (std::abs(bend[i]) * square > piece.acceleration[i])
        square = piece.acceleration[i] / std::abs(bend[i]);
    }
  }
  return std::sqrt(square) / 2;
}

Piece piece_of(const ShapedLeg& leg, double begin, double length) {
  Piece piece;
  piece.begin = begin;
  piece.length = length;
  piece.pace = leg.segment.ahead.speed;
  piece.acceleration = leg.acceleration;
  return piece;
}

/// Through place, slope and bend at both of its ends. For a sliver, as rounding leaves between two
/// nodes, those at its beginning say all: its higher terms would be rounding divided by next to
/// nothing.
void fill_quintic(Piece& piece, const PathPoint& a, const PathPoint& b) {
  constexpr double kSliver = 1e-6;  // m. [choice] on which no axis leaves the parabola by 1e-12
  const double l = piece.length;
  if (l < kSliver) {
    piece.count = 3;
    piece.terms[0] = a.q;
    piece.terms[1] = a.qd;
    piece.terms[2] = a.qdd / 2;
    return;
  }
  const JointVector way = b.q - a.q;
  const JointVector v0 = a.qd * l;
  const JointVector v1 = b.qd * l;
  const JointVector a0 = a.qdd * (l * l);
  const JointVector a1 = b.qdd * (l * l);
  piece.count = 6;
  piece.terms[0] = a.q;
  piece.terms[1] = a.qd;
  piece.terms[2] = a.qdd / 2;
  piece.terms[3] = (10 * way - 6 * v0 - 4 * v1 - 1.5 * a0 + 0.5 * a1) / (l * l * l);
  piece.terms[4] = (-15 * way + 8 * v0 + 7 * v1 + 1.5 * a0 - a1) / (l * l * l * l);
  piece.terms[5] = (6 * way - 3 * v0 - 3 * v1 - 0.5 * a0 + 0.5 * a1) / (l * l * l * l * l);
}

/// At even speed σ' a quintic needs the jerk σ'³ times its third derivative. Only a mean of σ needs
/// this bound: a mean of the axes bounds their jerk on any path.
void bound_jerk(const ShapedLeg& leg, Piece& piece) {
  if (piece.count < 6) return;
  double cube = Piece::kAny;  // of σ'
  for (const double at : {0.0, piece.length / 2, piece.length}) {
    const JointVector third = third_derivative(piece, at);
    for (int i = 0; i < third.size(); ++i)
      cube = std::min(cube, kBendsShare * leg.jerk[i] / std::abs(third[i]));
  }
  const double fastest = std::cbrt(cube);
  if (!(fastest < piece.fastest)) return;
  piece.fastest = fastest;
  piece.fastest_axis = -1;
}

/// `at(way)` gives the path's places, from `from` to `to` in even parts.
template <typename At>
void append_curve(const RobotModel& robot, const ShapedLeg& leg, double begin, double from,
                  double to, int parts, At&& at, std::vector<Piece>& pieces) {
  PathPoint a = at(from);
  for (int k = 0; k < parts; ++k) {
    const double start = from + (to - from) * k / parts;
    const double stop = k + 1 == parts ? to : from + (to - from) * (k + 1) / parts;
    const PathPoint b = at(stop);
    Piece piece = piece_of(leg, begin + (start - from), stop - start);
    fill_quintic(piece, a, b);
    bound_speed(robot, a.qd, piece);
    bound_speed(robot, piece.point(piece.length / 2).qd, piece);
    bound_speed(robot, b.qd, piece);
    if (robot.tool_coordinates) bound_jerk(leg, piece);
    pieces.push_back(piece);
    a = b;
  }
}

/// `longest`: m that a part may have.
/// `a`, `b`: the ends of a stretch that is one polynomial.
int parts_of(const RobotModel& robot, const PathPoint& a, const PathPoint& b, double length,
             double longest) {
  constexpr double kShortest = 1e-6;  // m. [choice] below what any scale resolves
  constexpr double kMost = 64;        // [choice] a stretch that asks for more is no curve of a tool
  const double slope = std::max(a.qd.norm(), b.qd.norm());
  // A bend counts at its ends, too: within, it may turn there and back.
  const double turned =
      std::max((b.qd - a.qd).norm(), length * std::max(a.qdd.norm(), b.qdd.norm()));
  double wanted = slope > 0 ? turned / slope / kMostBend : 1;
  for (int i = 0; i < robot.axis_count(); ++i) {
    if (robot.axes[static_cast<std::size_t>(i)].kind == AxisKind::Rotary)
      wanted = std::max(wanted, std::abs(b.q[i] - a.q[i]) / kMostTurn);
  }
  wanted = std::max(std::min(wanted, kMost), length / longest);
  return static_cast<int>(std::clamp(std::ceil(wanted), 1.0, std::max(1.0, length / kShortest)));
}

/// Node by node: between two the axes are one polynomial.
template <typename At>
void append_nodes(const RobotModel& robot, const ShapedLeg& leg, const JointPath& path,
                  double scale, double begin, double from, double to, double longest, At&& at,
                  std::vector<Piece>& pieces) {
  const std::vector<JointPath::Node>& nodes = path.nodes();
  double start = from;
  for (std::size_t i = 0; i + 1 < nodes.size() && start < to; ++i) {
    const bool last = i + 2 == nodes.size();
    const double stop = last ? to : std::min(to, nodes[i + 1].time * scale);
    if (stop - start <= 1e-12 * (to - from)) continue;
    const int parts = parts_of(robot, at(start), at(stop), stop - start, longest);
    append_curve(robot, leg, begin + (start - from), start, stop, parts, at, pieces);
    start = stop;
  }
}

/// Whether motion within the axes' limits can overload gears or drives at all. Where each place
/// acts alone, bends can at most double σ''.
bool torque_binds(const Piece& piece) {
  const PathPoint begin = piece.point(0);
  const PathPoint end = piece.point(piece.length);
  double control = Piece::kAny;
  for (int i = 0; i < piece.acceleration.size(); ++i) {
    const double slope = std::max(std::abs(begin.qd[i]), std::abs(end.qd[i]));
    if (slope * control > piece.acceleration[i]) control = piece.acceleration[i] / slope;
  }
  return !(piece.torque.slope * 2 * control + piece.torque.bend * piece.fastest * piece.fastest <=
           1);
}

/// The torques at the ends of a curve's piece, which is short, and at places on a straight one.
void bound_torque(const RobotModel& robot, const ShapedLeg& leg, Piece& piece) {
  const ArmMechanics* const arm = leg.segment.ahead.mechanics;
  if (arm == nullptr) return;
  constexpr double kMostParts = 90;  // [choice] two degrees of half a turn
  int parts = 1;
  if (piece.straight()) {
    const double turned = piece.terms[1].cwiseAbs().maxCoeff() * piece.length;
    parts = static_cast<int>(std::clamp(std::ceil(turned / kMostTurn), 1.0, kMostParts));
  }
  for (int k = 0; k <= parts; ++k)
    piece.torque.take(
        torque_row(robot, *arm, piece.point(piece.length * k / parts), piece.fastest));
  if (piece.torque.fastest < piece.fastest) {
    piece.fastest = piece.torque.fastest;
    piece.fastest_axis = -1;
  }
  if (leg.segment.ahead.window == 0 && !torque_binds(piece)) piece.torque = {};
}

/// The tool is as fast as the motions on a piece ask for, not σ: a curve cuts corners, and has
/// knots that lie closer.
void pace_merged(const ShapedLeg& leg, std::size_t first, std::vector<Piece>& pieces) {
  constexpr double kLeastSlope = 0.25;  // [choice] where the curve nearly stands, σ does not race
  const std::vector<PathStretch::Member>& members = leg.stretch->members;
  std::size_t at = 0;
  for (std::size_t i = first; i < pieces.size(); ++i) {
    Piece& piece = pieces[i];
    const double begin = piece.begin - leg.begin;
    const double end = begin + piece.length;
    while (at + 1 < members.size() && members[at].end <= begin) ++at;
    double pace = Piece::kAny;
    for (std::size_t k = at; k < members.size() && members[k].begin < end; ++k)
      pace = std::min(pace, members[k].segment.ahead.speed);
    const double slope = std::max(leg.stretch->greatest_slope(begin, end), kLeastSlope);
    piece.pace = pace / slope;
  }
}

}  // namespace

JointVector third_derivative(const Piece& piece, double at) {
  if (piece.count < 6) return JointVector::Zero(piece.terms[0].size());
  return 6 * piece.terms[3] + at * (24 * piece.terms[4] + at * 60 * piece.terms[5]);
}

void bound_speed(const RobotModel& robot, const JointVector& slopes, Piece& piece) {
  for (int i = 0; i < robot.axis_count(); ++i) {
    const double slope = std::abs(slopes[i]);
    const double most = robot.axes[static_cast<std::size_t>(i)].v_max;
    if (slope * piece.fastest <= most) continue;
    piece.fastest = most / slope;
    piece.fastest_axis = i;
  }
}

ShapedLeg shaped_leg(const RobotModel& robot, const SegmentDescriptor& segment, double begin) {
  const LegBounds& bounds = segment.ahead;
  ShapedLeg leg;
  leg.segment = segment;
  leg.motion = {segment.path, bounds.from, segment.target, bounds.length};
  leg.begin = begin;
  leg.acceleration.resize(robot.axis_count());
  for (int i = 0; i < robot.axis_count(); ++i)
    leg.acceleration[i] = robot.axes[static_cast<std::size_t>(i)].a_max * bounds.acceleration;
  leg.jerk = bounds.window > 0 ? JointVector(2 / bounds.window * leg.acceleration)
                               : JointVector::Constant(robot.axis_count(), Piece::kAny);
  return leg;
}

ShapedLeg shaped_leg(const RobotModel& robot, const PathItem& item, double begin) {
  ShapedLeg leg = shaped_leg(robot, item.segment, begin);
  leg.stretch = item.stretch;
  return leg;
}

double greatest_rate(const RobotModel& robot, const ShapedLeg& leg, const PathPoint& place) {
  double most = leg.segment.ahead.speed;
  for (int i = 0; i < robot.axis_count(); ++i) {
    const double v_max = robot.axes[static_cast<std::size_t>(i)].v_max;
    if (std::abs(place.qd[i]) * most > v_max) most = v_max / std::abs(place.qd[i]);
  }
  return most;
}

double greatest_control(const ShapedLeg& leg, const PathPoint& place) {
  double most = Piece::kAny;
  for (int i = 0; i < place.qd.size(); ++i) {
    if (std::abs(place.qd[i]) * most > leg.acceleration[i])
      most = leg.acceleration[i] / std::abs(place.qd[i]);
  }
  return most;
}

double turning_reserve(const ShapedLeg& in, const ShapedLeg& out, const JointVector& turn) {
  double least = Piece::kAny;
  for (int i = 0; i < turn.size(); ++i) {
    const double most = std::min(in.acceleration[i], out.acceleration[i]);
    if (std::abs(turn[i]) * least > most) least = most / std::abs(turn[i]);
  }
  return least;
}

/// With accelerations a = s·u and a mean of T = s·W it takes d/v + v/a + T where it reaches its
/// speed; that is least where v/a = T. Else it takes 2·√(d/a) + T; that is least where d/a = T².
static LegAlone alone_without_pause(const ShapedLeg& leg, double control, double speed) {
  LegAlone made;
  const double way = leg.length();
  if (const double window = leg.segment.ahead.window; window > 0) {
    made.share = std::min(
        {1.0, std::sqrt(speed / (control * window)), std::cbrt(way / (control * window * window))});
    made.average = made.share * window;
  }
  const double a = made.share * control;
  const double ramp = speed / a;
  made.time = (way >= speed * ramp ? way / speed + ramp : 2 * std::sqrt(way / a)) + made.average;
  return made;
}

/// With accelerations a = s·u and a mean of T = s·W/2 it takes d/v + v/a + T where it reaches its
/// speed; that is least where v/a = T. Else it speeds up for t, t·(t + T)·a = d, and takes
/// 2·(t + T); that is least where t = T.
LegAlone alone(const RobotModel& robot, const ShapedLeg& leg) {
  const PathPoint begin = leg.at(0);
  const double control = greatest_control(leg, begin);
  const double speed = greatest_rate(robot, leg, begin);
  if (robot.mechanics || leg.motion.path != nullptr)
    return alone_without_pause(leg, control, speed);
  const double way = leg.length();
  const LegBounds& bounds = leg.segment.ahead;
  LegAlone made;
  made.pauses = true;
  if (const double window = bounds.window; window > 0) {
    made.share =
        std::min({bounds.full / bounds.acceleration, std::sqrt(2 * speed / (control * window)),
                  std::cbrt(2 * way / (control * window * window)), 2.0});
    made.average = made.share * window / 2;
  }
  const double a = made.share * control;
  const double ramp = speed / a + made.average;
  const double half = made.average / 2;
  made.time =
      way >= speed * ramp ? way / speed + ramp : 2 * (half + std::sqrt(half * half + way / a));
  return made;
}

void append_leg(const RobotModel& robot, const ShapedLeg& leg, double from, double to,
                double longest, std::vector<Piece>& pieces) {
  if (!(to > from)) return;
  const auto at = [&](double way) { return leg.at(way); };
  const std::size_t first = pieces.size();
  if (leg.motion.path != nullptr) {
    append_nodes(robot, leg, *leg.motion.path, leg.length(), leg.begin + from, from, to,
                 Piece::kAny, at, pieces);
    if (leg.merged()) pace_merged(leg, first, pieces);
    for (std::size_t i = first; i < pieces.size(); ++i) bound_torque(robot, leg, pieces[i]);
    return;
  }
  const double parts = std::max(1.0, std::ceil((to - from) / longest));
  for (double k = 0; k < parts; ++k) {
    const double start = from + (to - from) * (k / parts);
    const double stop = k + 1 < parts ? from + (to - from) * ((k + 1) / parts) : to;
    const PathPoint place = leg.at(start);
    Piece piece = piece_of(leg, leg.begin + start, stop - start);
    piece.count = 2;
    piece.terms[0] = place.q;
    piece.terms[1] = place.qd;
    bound_speed(robot, place.qd, piece);
    bound_torque(robot, leg, piece);
    pieces.push_back(piece);
  }
}

void append_turn(const RobotModel& robot, const ShapedLeg& in, const ShapedLeg& out,
                 const Turn& turn, std::vector<Piece>& pieces) {
  const std::size_t first = pieces.size();
  const double half = turn.half;
  if (!turn.axes.nodes().empty()) {
    const auto at = [&](double way) { return turn.axes.at(way); };
    // The axes' accelerations are held at the ends of pieces alone, and bends rise and fall here.
    // On an arm nothing is seen of what is passed in a part of a period.
    constexpr int kLeastPieces = 4;  // [choice] on each side
    const double pace = std::min({in.segment.ahead.speed, out.segment.ahead.speed, turn.fastest});
    const double unseen = robot.tool_coordinates ? pace * robot.reference_period / 4 : 0;
    const double longest = std::clamp(unseen, half / kTurnPieces, half / kLeastPieces);
    append_nodes(robot, in, turn.axes, 1, in.end() - half, -half, 0, longest, at, pieces);
    append_nodes(robot, out, turn.axes, 1, out.begin, 0, half, longest, at, pieces);
  } else {
    const JointVector before = in.at(in.length()).qd;
    const JointVector after = out.at(0).qd;
    const JointVector bend = (after - before) / (2 * half);
    const PathPoint start = in.at(in.length() - half);
    const double pace = std::min({in.segment.ahead.speed, out.segment.ahead.speed, 1e3});
    const int parts =
        std::clamp(static_cast<int>(half / (pace * robot.reference_period)), 1, kMostCornerPieces);
    for (int k = 0; k < 2 * parts; ++k) {
      const ShapedLeg& leg = k < parts ? in : out;
      const double way = half * k / parts;
      Piece piece = piece_of(leg, in.end() - half + way, half / parts);
      piece.count = 3;
      piece.terms[0] = start.q + before * way + bend * (way * way / 2);
      piece.terms[1] = before + bend * way;
      piece.terms[2] = bend / 2;
      bound_speed(robot, piece.point(0).qd, piece);
      bound_speed(robot, piece.point(piece.length).qd, piece);
      pieces.push_back(piece);
    }
  }
  const bool guarded = out.segment.guard.present();
  for (std::size_t i = first; i < pieces.size(); ++i) {
    const bool before = pieces[i].begin + pieces[i].length / 2 < in.end();
    bound_torque(robot, before ? in : out, pieces[i]);
    const double fastest = std::min(turn.fastest, guarded ? half_speed(pieces[i]) : Piece::kAny);
    if (fastest >= pieces[i].fastest) continue;
    pieces[i].fastest = fastest;
    pieces[i].fastest_axis = -1;
  }
}

}  // namespace rob::motion
