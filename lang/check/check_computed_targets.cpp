#include <algorithm>
#include <string>
#include <vector>

#include <fmt/core.h>

#include "lang/check/fold.h"
#include "lang/check/move_checker.h"
#include "lang/check/target.h"
#include "lang/text/codes.h"

/// Targets that are values: poses, and VECs behind BY.
namespace rob::lang {

bool MoveChecker::check_value(const Move& move, const ExprPtr& point) {
  const Expr& target = *point;
  const Type type = expressions_.check(point);
  if (!type.known()) return false;
  const std::string_view word = word_of(move.kind);
  if (type.is_place() && !move.by) {
    const Symbol* const taught = bare_point(move);
    if (taught != nullptr) checked_.symbols[taught->id].moved_to = true;
    if (taught == nullptr && move.kind == MotionKind::Joint && !known(known_value(target)))
      checked_.features.push_back({target.place, MotionFeature::Lead});
    return expressions_.accept(target, Type::pose(), fmt::format("{} needs", word)) &&
           check_frame(move, target);
  }
  if (type == Type::vec(kLength) && move.by) return true;
  const bool in_axes = move.kind == MotionKind::Joint || move.kind == MotionKind::Spline;
  if (type.is(Type::Kind::Joints) && !move.by && in_axes) return true;
  report_no_target(move, target);
  return false;
}

/// A pose that has a frame keeps it: IN must not name another.
bool MoveChecker::check_frame(const Move& move, const Expr& target) {
  const Surroundings& around = move.clauses.surroundings;
  const Type pose = as_pose(target.type);
  if (!around.has_frame() || is_free(pose)) return true;
  if (around.frame != nullptr) {
    const auto& name = std::get<Name>(around.frame->node);
    const Symbol* const symbol = expressions_.find(name.text);
    const bool world = symbol != nullptr && symbol->kind == Symbol::Kind::BuiltIn;
    if (symbol == nullptr || !symbol->type.is(Type::Kind::Frame)) return true;  // told elsewhere
    if (world ? pose == Type::pose() : symbol->frame != nullptr && symbol->frame == pose.detail) {
      return true;
    }
  }
  diagnostics_.error(code::kFrames, target.place,
                     fmt::format("this is {}, and IN names another frame", described(target)),
                     "leave IN out, or give components, or a POSE(…) without a frame");
  return false;
}

void MoveChecker::report_no_target(const Move& move, const Expr& target) {
  const Type& type = target.type;
  const std::string_view word = word_of(move.kind);
  if (type.is(Type::Kind::Joints)) {
    diagnostics_.error(
        code::kNoTarget, target.place,
        fmt::format("{}{} does not take a value for each joint", word, move.by ? " BY" : ""),
        move.by ? "MOVE j + k goes to the sum of two"
                : fmt::format("MOVE j goes to the joints j, {} FORWARD(j) to the "
                              "place that they bring the tool to",
                              word));
    return;
  }
  if (move.by) {
    diagnostics_.error(code::kNoTarget, target.place,
                       fmt::format("{} BY needs components or a VEC of lengths; this is {}", word,
                                   described(target)),
                       type.is_place()
                           ? fmt::format("{} p * q goes to the pose q as seen from p", word)
                           : fmt::format("{} BY (20mm, 0mm, 0deg)", word));
    return;
  }
  const bool shift = type.is(Type::Kind::Vec) && move.via.empty();
  diagnostics_.error(code::kNoTarget, target.place,
                     fmt::format("{} needs components in parentheses or a pose; this is {}", word,
                                 described(target)),
                     shift ? fmt::format("{} BY v shifts the tool by a VEC", word)
                           : fmt::format("{}(140, 40, 0)", move.via.empty() ? word : "MOVE"));
}

/// `point`: where the target is a bare POINT.
void MoveChecker::judge_value(const Expr& target, const Symbol* point) {
  const bool by_joints = point != nullptr && known(point->value) && point->flange_joints;
  const Constant value = by_joints ? Constant(point->joints) : known_value(target);
  const auto* const slots = std::get_if<std::vector<double>>(&value);
  if (slots == nullptr) return;
  MoveCommand command;
  const bool axes = by_joints || target.type.is(Type::Kind::Joints);
  command.means = axes ? MoveCommand::Target::Axes : MoveCommand::Target::Pose;
  command.count = static_cast<int>(slots->size());
  command.given = given_all(command.count);
  std::ranges::copy(*slots, command.target.begin());
  judge(command, target.place);
}

}  // namespace rob::lang
