#include <algorithm>
#include <string>

#include <fmt/core.h>

#include "lang/codes.h"
#include "lang/move_checker.h"
#include "lang/target.h"
#include "lang/watch_checker.h"

namespace rob::lang {

void MoveChecker::check(const Header& header) {
  if (header.law && header.look_ahead)
    checked_.features.push_back({*header.law, MotionFeature::LookAhead});
}

void MoveChecker::check(const Move& move, Place place) {
  bool sound =
      move.axis != nullptr ? check_joint(move) : move.target != nullptr && check_target(move);
  sound = clauses_.check(move.clauses, place) && sound;
  remember_features(move.clauses, place);
  if (sound && move.clauses.live) {
    WatchChecker(expressions_, diagnostics_).check_live(*move.clauses[Clause::At]);
  }
  if (sound) remember_constants(move);
}

void MoveChecker::remember_features(const Clauses& clauses, Place place) {
  const ExprPtr& accel = clauses[Clause::Accel];
  const ExprPtr& jerk = clauses[Clause::Jerk];
  if (accel) checked_.features.push_back({accel->place, MotionFeature::Accel});
  if (jerk) checked_.features.push_back({jerk->place, MotionFeature::Jerk});
  if (clauses.live) checked_.features.push_back({clauses.live_place, MotionFeature::LivePace});
  if (clauses.profile != Profile::Unspecified)
    checked_.features.push_back({place, MotionFeature::Profile});
}

/// MOVE JOINT: which axis has to be known, unless all take values of one dimension.
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
  const auto axis = number == nullptr ? 0 : static_cast<std::size_t>(*number - 1);
  return move.target->type.kind != Type::Kind::Unknown &&
         expressions_.accept(*move.target, Type::real(robot_.axes[axis].dimension),
                             fmt::format("axis {} needs", robot_.axes[axis].name));
}

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
    } else if (next != nullptr && std::holds_alternative<Stop>(next->node)) {
      warn_of_zone(zone, "STOP", next->place);
    } else if (next != nullptr && std::holds_alternative<Wait>(next->node)) {
      warn_of_zone(zone, "WAIT", next->place);
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

void MoveChecker::remember_constants(const Move& move) {
  if (!move.by && move.axis == nullptr && !std::holds_alternative<Tuple>(move.target->node)) {
    return remember_value(move);
  }
  if (move.by || (move.axis != nullptr && constant_number(*move.axis) == std::nullopt)) return;
  ConstantTarget constant{.place = move.target->place, .command = {}};
  MoveCommand& command = constant.command;
  const auto keep = [&](std::size_t i, const Expr& value, Dimension dimension) {
    const auto known = constant_component(value, dimension, robot_);
    if (!known) return;
    command.target[i] = *known;
    command.given = static_cast<std::uint8_t>(command.given | 1U << i);
  };
  if (move.axis != nullptr) {
    command.means = MoveCommand::Target::Axes;
    command.count = static_cast<int>(robot_.axes.size());
    const auto axis = static_cast<std::size_t>(*constant_number(*move.axis) - 1);
    keep(axis, *move.target, robot_.axes[axis].dimension);
  } else {
    const auto elements = by_coordinate(std::get<Tuple>(move.target->node), robot_);
    command.count = static_cast<int>(elements.size());
    for (std::size_t i = 0; i < elements.size(); ++i) {
      if (elements[i] != nullptr) keep(i, *elements[i]->value, robot_.coordinates[i].dimension);
    }
  }
  if (command.given != 0) checked_.constant_targets.push_back(constant);
}

}  // namespace rob::lang
