#include "motion/ahead/merge_rules.h"

#include <algorithm>
#include <cmath>

#include "motion/ahead/overlap.h"
#include "motion/ahead/path_turn.h"

namespace rob::motion {

namespace {

using Eigen::Vector3d;

/// [choice] A knot is at most so many tolerances long: so it can bend within one.
constexpr double kTolerances = 5;
/// [choice] The share of the zone that a curve may use where a mean needs the rest.
constexpr double kBesideMean = 0.5;
constexpr double kSameLength = 1e-9;  // m

}  // namespace

/// The mean over T of a motion with accelerations up to a leaves that motion by up to a·T²/24. With
/// a = s·A and T = s·W that is s³·A·W²/24.
double share_for_mean(const RobotModel& robot, const LegBounds& bounds) {
  if (bounds.window == 0) return 1;
  double squares = 0;
  for (const Axis& axis : robot.axes)
    if (axis.kind == AxisKind::Linear) squares += axis.a_max * axis.a_max;
  const double moved =
      std::sqrt(squares) * bounds.acceleration * bounds.window * bounds.window / 24;
  return std::min(1.0, std::cbrt((1 - kBesideMean) * bounds.miss / moved));
}

bool joins(const SegmentDescriptor& in, const SegmentDescriptor& out) {
  const LegBounds& before = in.ahead;
  const LegBounds& after = out.ahead;
  const bool lines = (before.line != nullptr) == (after.line != nullptr);
  return !out.from_rest && before.mechanics == after.mechanics && in.generation == out.generation &&
         lines && (after.line != nullptr || before.acceleration == after.acceleration) &&
         before.tip.position == after.tip.position &&
         before.tip.orientation.coeffs() == after.tip.orientation.coeffs();
}

std::shared_ptr<PathStretch> part_of_line(const SegmentDescriptor& segment, double from,
                                          double to) {
  auto part = std::make_shared<PathStretch>();
  part->axes = segment.path->part(from, to);
  part->line = ToolLine::between(segment.ahead.line->at(from), segment.ahead.line->at(to));
  return part;
}

void lie_on(const PathStretch& part, SegmentDescriptor& segment) {
  segment.path = &part.axes;
  segment.ahead.line = part.line ? &*part.line : nullptr;
}

MergeRules::MergeRules(const RobotModel& robot) : robot_(robot) {
  for (int i = 0; i < robot.axis_count() && linear_.size() < 3; ++i)
    if (robot.axes[static_cast<std::size_t>(i)].kind == AxisKind::Linear) linear_.push_back(i);
}

bool MergeRules::mergeable(const SegmentDescriptor& segment) const {
  const LegBounds& bounds = segment.ahead;
  if (!has_way(segment) || segment.guard.present() || segment.live.present()) return false;
  if (!(bounds.miss > 0) || !std::isfinite(bounds.miss)) return false;
  if (bounds.share < 1 || std::isfinite(bounds.lead)) return false;
  return is_straight(segment);
}

/// Linear axes, or a tool that does not turn, where its axes can follow a curve that
/// is not quite its line.
bool MergeRules::is_straight(const SegmentDescriptor& segment) const {
  constexpr double kSingular = 0.05;  // rad. [choice] more than what a zone moves any wrist
  constexpr double kTurn = 1e-9;      // rad
  const LegBounds& bounds = segment.ahead;
  if (robot_.tool_coordinates) {
    const auto regular = [&](const JointVector& q) {
      return robot_.kinematics->nearest_singularity(q, kSingular) == SingularPlace::None;
    };
    return bounds.line != nullptr && segment.path != nullptr && bounds.line->turn() <= kTurn &&
           std::abs(bounds.line->way() - bounds.length) <= kSameLength && regular(bounds.from) &&
           regular(segment.target);
  }
  if (linear_.empty() || segment.path != nullptr) return false;
  const double way = (segment.target - bounds.from).norm();
  const double linear = (place(segment.target) - place(bounds.from)).norm();
  return std::abs(way - linear) <= kSameLength && std::abs(linear - bounds.length) <= kSameLength;
}

Vector3d MergeRules::begin_of(const SegmentDescriptor& segment) const {
  const ToolLine* const line = segment.ahead.line;
  return line != nullptr ? line->at(0).position : place(segment.ahead.from);
}

Vector3d MergeRules::end_of(const SegmentDescriptor& segment) const {
  const ToolLine* const line = segment.ahead.line;
  return line != nullptr ? line->at(1).position : place(segment.target);
}

Vector3d MergeRules::place(const JointVector& q) const {
  Vector3d at = Vector3d::Zero();
  for (std::size_t k = 0; k < linear_.size(); ++k) at[static_cast<Eigen::Index>(k)] = q[linear_[k]];
  return at;
}

JointVector MergeRules::axes_at(const JointVector& like, const Vector3d& place) const {
  JointVector q = like;
  for (std::size_t k = 0; k < linear_.size(); ++k)
    q[linear_[k]] = place[static_cast<Eigen::Index>(k)];
  return q;
}

Vector3d MergeRules::direction(const SegmentDescriptor& segment) const {
  return (end_of(segment) - begin_of(segment)).normalized();
}

double MergeRules::speed_on(const SegmentDescriptor& segment) const {
  const ShapedLeg leg = shaped_leg(robot_, segment, 0);
  return greatest_rate(robot_, leg, leg.at(0));
}

double MergeRules::soon(const SegmentDescriptor& segment) const {
  return few_periods(robot_) * speed_on(segment);
}

/// The mean of a curve takes a share s of the accelerations, on straight legs of its run, too: it
/// costs them the less the nearer s is to 1. [choice] of 1/(1 − s), and of 24 knots, which CurveFit
/// solves at once.
double MergeRules::longest_between(const SegmentDescriptor& crowd,
                                   const SegmentDescriptor& segment) const {
  constexpr double kKnots = 24;
  constexpr double kSame = 1e-9;
  const double speed = speed_on(crowd);
  const bool alike = crowd.ahead.miss == segment.ahead.miss &&
                     std::abs(speed - speed_on(segment)) <= kSame * speed;
  if (!alike) return soon(segment);
  const double calm = soon(segment) / (1 - share_for_mean(robot_, segment.ahead));
  return std::max(soon(segment), std::min(calm, kKnots * knots_for(segment, false).apart));
}

/// A knot is a quarter of the way in which the weakest axis leads off by the zone, at the leg's
/// speed; half of it where a mean of σ bounds the jerk, which leads off by J·t³. [choice] of the
/// latter: shorter ones cost arms up to a twentieth of the time of an arc, longer ones nothing.
MergeRules::Knots MergeRules::knots_for(const SegmentDescriptor& segment, bool by_jerk) const {
  const double zone = tolerance(segment);
  const double acceleration = strength(segment);
  const double in_acceleration = std::sqrt(zone / acceleration) / 4;
  const double in_jerk = std::cbrt(zone * segment.ahead.window / (2 * acceleration)) / 2;
  const double leads =
      speed_on(segment) * (by_jerk ? std::max(in_acceleration, in_jerk) : in_acceleration);
  const double apart = std::min(leads, kTolerances * zone);
  return {apart, leads / apart, by_jerk ? 3 : 2};
}

double MergeRules::tolerance(const SegmentDescriptor& segment) const {
  const bool mean = segment.ahead.window > 0 && !robot_.tool_coordinates;
  return (mean ? kBesideMean : 1) * segment.ahead.miss;
}

/// m/s²: of a tool along the line, of a table that of its weakest axis.
double MergeRules::strength(const SegmentDescriptor& segment) const {
  if (segment.ahead.line != nullptr) {
    const ShapedLeg leg = shaped_leg(robot_, segment, 0);
    return greatest_control(leg, leg.at(0));
  }
  double weakest = Piece::kAny;
  for (const Eigen::Index i : linear_)
    weakest = std::min(weakest, robot_.axes[static_cast<std::size_t>(i)].a_max);
  return weakest * segment.ahead.acceleration * share_for_mean(robot_, segment.ahead);
}

/// A corner that misses by e and turns a direction by d has a radius of 8·e/d².
bool MergeRules::sooner_on_curve(const SegmentDescriptor& segment,
                                 const SegmentDescriptor& out) const {
  const double turn = (direction(out) - direction(segment)).norm();
  const double control = strength(segment);
  const double full = speed_on(segment);
  const double way = segment.ahead.length;
  const double corner = std::min(full, std::sqrt(8 * control * tolerance(segment)) / turn);
  const double top = std::min(full, std::sqrt(corner * corner + control * way));
  const double ramps = (top * top - corner * corner) / control;
  const double time = 2 * (top - corner) / control + (way - ramps) / top;
  const ShapedLeg leg = shaped_leg(robot_, segment, 0);
  const double overlap = won_by_overlap(robot_, leg, shaped_leg(robot_, out, leg.end()));
  return time < alone(robot_, leg).time - overlap;
}

/// m/s that a motion from rest to rest reaches on the leg.
double MergeRules::reachable_speed(const SegmentDescriptor& segment) const {
  const ShapedLeg leg = shaped_leg(robot_, segment, 0);
  return std::min(speed_on(segment), 2 * leg.length() / alone(robot_, leg).time);
}

/// To change the speed by Δv a jerk J takes √(Δv/J), and leads off by √(Δv³/J) or so meanwhile.
double MergeRules::led_off_by_jerk(const SegmentDescriptor& segment,
                                   const SegmentDescriptor& out) const {
  const double turn = (direction(out) - direction(segment)).norm();
  const double change = std::min(reachable_speed(segment), reachable_speed(out)) * turn;
  const double jerk = 2 * strength(segment) / segment.ahead.window;
  return std::sqrt(change * change * change / jerk);
}

/// An arc through the ends of legs of length ℓ that turn by θ lies ℓ·θ/8 beside them. [choice] of
/// the parts: 113 random programs on five arms with ZONE 0.2 to 10 mm were never slower with them
/// than with stops.
bool MergeRules::bends_gently(const SegmentDescriptor& segment,
                              const SegmentDescriptor& out) const {
  constexpr double kMostTurn = 0.5;  // of a direction
  constexpr double kPart = 0.3;
  if (!robot_.tool_coordinates || segment.ahead.window == 0) return false;
  if (!mergeable(segment) || !mergeable(out)) return false;
  const double turn = (direction(out) - direction(segment)).norm();
  if (turn > kMostTurn || beside_arc(segment, out) > tolerance(segment)) return false;
  return tolerance(segment) > kPart * led_off_by_jerk(segment, out);
}

double MergeRules::beside_arc(const SegmentDescriptor& segment,
                              const SegmentDescriptor& out) const {
  const double length = std::max(segment.ahead.length, out.ahead.length);
  return length * (direction(out) - direction(segment)).norm() / 8;
}

bool MergeRules::nearly_straight(const SegmentDescriptor& segment,
                                 const SegmentDescriptor& out) const {
  constexpr double kPart = 0.01;  // [choice] rounded digits leave less
  return beside_arc(segment, out) < kPart * tolerance(segment);
}

double MergeRules::corner_half(const SegmentDescriptor& in, const SegmentDescriptor& out) const {
  if (out.from_rest || in.guard.present()) return 0;
  return wanted_half(robot_, shaped_leg(robot_, in, 0), shaped_leg(robot_, out, 0));
}

/// From knot to knot a cubic, which a quintic between its ends is, too.
JointPath MergeRules::axes_of_table(const CurveFit& fit, const CurvePart& part,
                                    const JointVector& like) const {
  constexpr double kSliver = 1e-6;  // of a knot
  std::vector<JointPath::Node> nodes;
  const double begin = part.begin;
  const double end = part.end;
  const double scale = end - begin;
  const JointVector still = JointVector::Zero(like.size());
  const auto add = [&](double u) {
    const CurveFit::Place place = fit.at(u);
    nodes.push_back({(u - begin) / scale, axes_at(like, place.place),
                     axes_at(still, scale * place.first),
                     axes_at(still, scale * scale * place.second)});
  };
  add(begin);
  for (double u = std::floor(begin + kSliver) + 1; u < end - kSliver; ++u) add(u);
  add(end);
  return JointPath(std::move(nodes));
}

}  // namespace rob::motion
