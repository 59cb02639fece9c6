#include <algorithm>
#include <string>
#include <vector>

#include <fmt/core.h>

#include "lang/codes.h"
#include "lang/fold.h"
#include "lang/move_checker.h"
#include "lang/target.h"

/// Targets that are values: poses, and VECs behind BY.
namespace rob::lang {

bool MoveChecker::check_value(const Move& move) {
  const Expr& target = *move.target;
  const Type type = expressions_.check(move.target);
  if (!type.known()) return false;
  const std::string_view word = word_of(move.kind);
  if (type.is_place() && !move.by) {
    if (const Symbol* const point = bare_point(move)) {
      checked_.symbols[point->id].moved_to = true;
    }
    return expressions_.accept(target, Type::pose(), fmt::format("{} needs", word));
  }
  if (type == Type::vec(kLength) && move.by) return true;
  if (type.is(Type::Kind::Joints) && !move.by && move.kind == MotionKind::Joint) return true;
  report_no_target(move, type);
  return false;
}

void MoveChecker::report_no_target(const Move& move, const Type& type) {
  const std::string_view word = word_of(move.kind);
  if (type.is(Type::Kind::Joints)) {
    diagnostics_.error(
        code::kNoTarget, move.target->place,
        fmt::format("{}{} does not take a value for each joint", word, move.by ? " BY" : ""),
        move.by ? "MOVE j + k goes to the sum of two"
                : fmt::format("MOVE j goes to the joints j, {} FORWARD(j) to the "
                              "place that they bring the tool to",
                              word));
    return;
  }
  if (move.by) {
    diagnostics_.error(code::kNoTarget, move.target->place,
                       fmt::format("{} BY needs components or a VEC of lengths; this is {}", word,
                                   described(*move.target)),
                       type.is_place()
                           ? fmt::format("{} p * q goes to the pose q as seen from p", word)
                           : fmt::format("{} BY (20mm, 0mm, 0deg)", word));
    return;
  }
  diagnostics_.error(code::kNoTarget, move.target->place,
                     fmt::format("{} needs components in parentheses or a pose; this"
                                 " is {}",
                                 word, described(*move.target)),
                     type.is(Type::Kind::Vec)
                         ? fmt::format("{} BY v shifts the tool by a VEC", word)
                         : fmt::format("{}(140, 40, 0)", word));
}

/// A target that is known beforehand is looked at before anything moves.
void MoveChecker::remember_value(const Move& move) {
  const Expr& target = *move.target;
  const Symbol* const point = bare_point(move);
  const bool by_joints = point != nullptr && known(point->value) && !point->joints.empty();
  const Constant value = by_joints ? Constant(point->joints) : known_value(target);
  const auto* const slots = std::get_if<std::vector<double>>(&value);
  if (slots == nullptr) return;
  ConstantTarget constant{.place = target.place, .command = {}};
  MoveCommand& command = constant.command;
  const bool axes = by_joints || target.type.is(Type::Kind::Joints);
  command.means = axes ? MoveCommand::Target::Axes : MoveCommand::Target::Pose;
  command.count = static_cast<int>(slots->size());
  command.given = given_all(command.count);
  std::ranges::copy(*slots, command.target.begin());
  checked_.constant_targets.push_back(constant);
}

}  // namespace rob::lang
