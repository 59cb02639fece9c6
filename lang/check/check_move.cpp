#include <algorithm>
#include <string>

#include <fmt/core.h>

#include "lang/check/move_checker.h"
#include "lang/check/target.h"
#include "lang/check/watch_checker.h"
#include "lang/text/codes.h"

namespace rob::lang {

void MoveChecker::check(const Move& move, Place place, bool guarded) {
  bool sound = check_way(move, place, guarded);
  sound = clauses_.check(move.clauses, place) && check_clauses_of(move) && sound;
  remember_features(move, place);
  if (sound && move.clauses.live) {
    WatchChecker(expressions_, diagnostics_).check_live(*move.clauses[Clause::At]);
  }
  if (sound) judge_constants(move);
}

/// What lies between where the motion begins and where it ends.
bool MoveChecker::check_way(const Move& move, Place place, bool guarded) {
  switch (move.kind) {
    case MotionKind::Arc:
    case MotionKind::Spline:
      return check_curve(move);
    case MotionKind::Spiral:
      return check_spiral(move);
    case MotionKind::Jog:
      return check_jog(move, place, guarded);
    case MotionKind::Joint:
    case MotionKind::Line:
      break;
  }
  if (move.axis != nullptr) return check_joint(move);
  return move.target != nullptr && check_target(move, move.target);
}

void MoveChecker::remember_features(const Move& move, Place place) {
  const bool joints = move.kind == MotionKind::Spline && move.target != nullptr &&
                      move.target->type.is(Type::Kind::Joints);
  const bool in_axes = move.kind == MotionKind::Jog ? move.jog == JogFrame::Joint
                                                    : move.kind == MotionKind::Joint || joints;
  if (!in_axes) checked_.features.push_back({place, MotionFeature::Lead});
  const Clauses& clauses = move.clauses;
  const ExprPtr& accel = clauses[Clause::Accel];
  const ExprPtr& jerk = clauses[Clause::Jerk];
  if (accel) checked_.features.push_back({accel->place, MotionFeature::Accel});
  if (jerk) checked_.features.push_back({jerk->place, MotionFeature::Jerk});
}

/// MOVE JOINT: which axis must be known, unless all take values of one dimension.
bool MoveChecker::check_joint(const Move& move) {
  const Type type = expressions_.check(move.axis);
  expressions_.check(move.target);
  if (type.kind == Type::Kind::Unknown ||
      !expressions_.accept(*move.axis, Type::integer(), "the axis of MOVE JOINT has to be")) {
    return false;
  }
  const auto* const number = std::get_if<std::int64_t>(&move.axis->constant);
  const auto count = static_cast<std::int64_t>(robot_.axes.size());
  if (number == nullptr && !alike(robot_.axes)) {
    diagnostics_.error(
        code::kAxisNotConstant, move.axis->place,
        fmt::format("the axes of {} are of different kinds: which one is meant has to"
                    " be a constant",
                    robot_.name),
        fmt::format("write a number from 1 to {}", count));
    return false;
  }
  if (number != nullptr && (*number < 1 || *number > count)) {
    diagnostics_.error(code::kNoSuchAxis, move.axis->place,
                       fmt::format("{} has no axis {}", robot_.name, *number),
                       fmt::format("it has axes 1 to {}", count));
    return false;
  }
  const auto& axis =
      number == nullptr ? robot_.axes.front() : robot_.axes[static_cast<std::size_t>(*number - 1)];
  return move.target->type.kind != Type::Kind::Unknown &&
         expressions_.accept(
             *move.target, Type::real(axis.dimension),
             number == nullptr ? "each axis needs" : fmt::format("axis {} needs", axis.name));
}

namespace {

struct BarrierWord {
  std::string_view operator()(const Stop&) const { return "STOP"; }
  std::string_view operator()(const Wait&) const { return "WAIT"; }
  std::string_view operator()(const Halt&) const { return "HALT"; }
  std::string_view operator()(const Ask&) const { return "ASK"; }
  std::string_view operator()(const Teach&) const { return "TEACH"; }
  std::string_view operator()(const ZeroForce&) const { return "ZERO"; }
  std::string_view operator()(const Move& move) const {  // one with a profile begins at rest
    return move.clauses.profile == Profile::Unspecified ? "" : "PROFILE";
  }
  std::string_view operator()(const WatchedMotion& watched) const {
    return std::visit(*this, watched.motion.front().node);
  }
  std::string_view operator()(const auto& /*leaves the corner*/) const { return {}; }
};

/// The word of a statement that makes the motion before it exact; empty for all others.
std::string_view barrier(const Statement& statement) {
  return std::visit(BarrierWord{}, statement.node);
}

}  // namespace

void MoveChecker::warn_of_zones(const Block& block) {
  for (std::size_t i = 0; i < block.size(); ++i) {
    const auto* const watched = std::get_if<WatchedMotion>(&block[i].node);
    const bool guarded = watched != nullptr && watched->until != nullptr;
    const Statement& statement = watched != nullptr ? watched->motion.front() : block[i];
    const auto* const move = std::get_if<Move>(&statement.node);
    if (move == nullptr || move->clauses[Clause::Zone] == nullptr) continue;
    const Expr& zone = *move->clauses[Clause::Zone];
    const Statement* const next = i + 1 < block.size() ? &block[i + 1] : nullptr;
    if (constant_number(zone) == 0.0) continue;
    if (guarded) {
      warn_of_zone(zone, "UNTIL", statement.place);
    } else if (move->clauses.profile != Profile::Unspecified) {
      warn_of_zone(zone, "PROFILE", statement.place);
    } else if (next != nullptr && !barrier(*next).empty()) {
      warn_of_zone(zone, barrier(*next), next->place);
    }
  }
}

void MoveChecker::warn_of_zone(const Expr& zone, std::string_view word, Place place) {
  diagnostics_.warning(
      code::kZoneWithoutCorner, zone.place,
      fmt::format("the {} of line {} makes this target exact: ZONE has no corner to bound", word,
                  place.line),
      "leave ZONE out, or write FINE");
}

/// With another tool or frame a constant target is not a place that is known here, and a routine
/// may be called with any.
bool MoveChecker::places_are_known() const {
  return surroundings_ == 0 && !(in_routine_ && checked_.program.surroundings);
}

void MoveChecker::judge_constants(const Move& move) {
  if (!places_are_known() || !move.clauses.surroundings.none()) return;
  if (move.by || move.target == nullptr || move.kind == MotionKind::Jog) return;
  if (move.axis == nullptr) {
    for (const ExprPtr& point : move.via) judge_target(*point, nullptr);
    return judge_target(*move.target, bare_point(move));
  }
  const auto number = constant_number(*move.axis);
  if (!number) return;
  const auto axis = static_cast<std::size_t>(*number - 1);
  MoveCommand command;
  command.means = MoveCommand::Target::Axes;
  command.count = static_cast<int>(robot_.axes.size());
  keep_component(command, axis, *move.target, robot_.axes[axis].dimension);
  if (command.given != 0) judge(command, move.target->place);
}

void MoveChecker::judge_target(const Expr& target, const Symbol* point) {
  const auto* const tuple = std::get_if<Tuple>(&target.node);
  if (tuple == nullptr) return judge_value(target, point);
  MoveCommand command;
  const auto elements = by_coordinate(*tuple, robot_.coordinates);
  command.count = static_cast<int>(elements.size());
  for (std::size_t i = 0; i < elements.size(); ++i) {
    if (elements[i] == nullptr) continue;
    keep_component(command, i, *elements[i]->value, robot_.coordinates[i].dimension);
  }
  if (command.given != 0) judge(command, target.place);
}

void MoveChecker::keep_component(MoveCommand& command, std::size_t i, const Expr& value,
                                 Dimension dimension) const {
  const auto known = constant_component(value, dimension, robot_);
  if (!known) return;
  command.target[i] = *known;
  command.given = static_cast<std::uint8_t>(command.given | 1U << i);
}

/// A target that is known beforehand is looked at before anything moves.
void MoveChecker::judge(const MoveCommand& command, Place place) {
  const auto refusal = judge_ ? judge_(command) : std::nullopt;
  if (refusal) diagnostics_.error(refusal->code, place, refusal->message, refusal->help);
}

}  // namespace rob::lang
