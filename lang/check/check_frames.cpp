#include <algorithm>

#include <fmt/core.h>

#include "lang/check/fold.h"
#include "lang/check/statement_checker.h"
#include "lang/text/ascii.h"
#include "lang/text/codes.h"
#include "lang/values/number_text.h"
#include "lang/values/pose_slots.h"

/// The parts of the checkers that know FRAME and TOOL, and poses that change their frame.
namespace rob::lang {
namespace {

PoseValue pose_of(const Constant& constant) { return load_pose(to_slots(constant).data()); }

}  // namespace

/// Of any file, where it is declared already.
const Symbol* ExpressionChecker::frame_of(const Type& pose) const {
  if (!pose.is(Type::Kind::Pose) || pose.detail == nullptr || is_free(pose)) return nullptr;
  return scopes_.frame_of(pose.detail);
}

/// Whether a place may stand where another kind of place is wanted; a pose in a frame is brought
/// to the world where that is wanted.
bool ExpressionChecker::fits_place(const Expr& expression, const Type& wanted) const {
  const Type pose = as_pose(expression.type);
  const Slots slots = slots_of(wanted);
  if (slots != slots_of(expression.type)) expression.place_slots = slots.numbers;
  if (is_free(pose) || (wanted.is(Type::Kind::Pose) && pose == wanted)) return true;
  if (wanted.is(Type::Kind::Pose) && wanted != Type::pose()) return false;
  if (wanted.is(Type::Kind::Tool)) return pose == Type::pose();
  if (pose == Type::pose()) return true;
  expression.moved_from = frame_of(pose);
  return expression.moved_from != nullptr;
}

Constant known_value(const Expr& expression) {
  if (!known(expression.constant)) return {};
  Constant value = expression.constant;
  if (expression.moved_from != nullptr) {
    const PoseValue frame = pose_of(expression.moved_from->value);
    value = constant_of(pose_math::compose(frame, pose_of(expression.constant)));
  }
  // A pose as a TOOL weighs nothing.
  auto* const slots = std::get_if<std::vector<double>>(&value);
  if (slots != nullptr && expression.place_slots != 0) {
    slots->resize(static_cast<std::size_t>(expression.place_slots));
  }
  return value;
}

/// TO_FRAME(p, f): f is the name of a FRAME, so that the frame of the result is known.
Type ExpressionChecker::check_to_frame(const Call& call) {
  const Expr& pose = *call.arguments[0];
  const Expr& frame = *call.arguments[1];
  if (!accept(pose, Type::pose(), "TO_FRAME needs")) return {};
  const auto* const name = std::get_if<Name>(&frame.node);
  if (name != nullptr && name->symbol != nullptr && frame.type.is(Type::Kind::Frame) &&
      known(name->symbol->value)) {
    return Type::pose(name->symbol->frame);
  }
  diagnostics_.error(
      code::kNoFrame, frame.place,
      fmt::format("TO_FRAME needs the name of a FRAME; this is {}", described(frame)),
      "FRAME pallet = POSE(…) declares one");
  return {};
}

Type ExpressionChecker::check_fixed(const ExprPtr& expression, bool& missed) {
  fixed_ = true;
  missed_ = false;
  const Type type = check(expression);
  fixed_ = false;
  missed = missed_;
  return type;
}

/// FRAME and TOOL are constants of the program. With a point that nobody has taught they are
/// taken as the world and the flange, and so where the value is wrong: nothing runs then.
void StatementChecker::check_frame(const Declaration& declaration, Constant& value, bool missed) {
  const Declaration::Declared& declared = declaration.names.front();
  const std::string_view word = declaration.type->is(Type::Kind::Tool) ? "TOOL" : "FRAME";
  if (declaration.value->type.known() && !known(value) && missed) {
    std::vector<double> slots(static_cast<std::size_t>(slots_of(*declaration.type).numbers), 0.0);
    slots[3] = 1;  // w of the quaternion
    value = std::move(slots);
  }
  if (declaration.value->type.known() && !known(value)) {
    diagnostics_.error(
        code::kFrameNotConstant, declaration.value->place,
        fmt::format("{} {} is fixed before the program runs, so it needs a constant value", word,
                    shortened(declared.name)),
        "no variables and nothing that is read from the robot");
  }
  const Constant mass = tool_number(declaration.mass, Type::real(kMass), "MASS needs");
  const Constant cog = tool_number(declaration.cog, Type::vec(kLength), "COG needs");
  auto* const slots = std::get_if<std::vector<double>>(&value);
  if (slots == nullptr) return;
  if (const double* const number = std::get_if<double>(&mass)) slots->at(kPoseSlots) = *number;
  if (const auto* const place = std::get_if<std::vector<double>>(&cog)) {
    std::ranges::copy(*place, slots->begin() + kPoseSlots + 1);
  }
}

/// The value of MASS or COG, which becomes part of a TOOL's; unknown where there is none.
Constant StatementChecker::tool_number(const ExprPtr& value, const Type& wanted,
                                       std::string_view needed) {
  if (value == nullptr) return {};
  expressions_.check(value);
  if (!expressions_.accept(*value, wanted, needed) || !value->type.known()) return {};
  if (!known(value->constant)) {
    diagnostics_.error(code::kFrameNotConstant, value->place,
                       fmt::format("{} a constant value here", needed), "");
  } else if (const double* const mass = std::get_if<double>(&value->constant);
             mass != nullptr && *mass < 0) {
    diagnostics_.error(code::kFrameNotConstant, value->place, "a mass is 0kg or more", "");
  }
  return value->constant;
}

/// LOAD.
void StatementChecker::check(Load& load) {
  expressions_.check(load.mass);
  const bool mass = expressions_.accept(*load.mass, Type::real(kMass), "LOAD needs");
  if (load.cog != nullptr) {
    expressions_.check(load.cog);
    expressions_.accept(*load.cog, Type::vec(kLength), "COG needs");
  }
  const auto number = constant_number(*load.mass);
  if (!mass || !number || (*number >= 0 && *number <= kMostLoad)) return;
  diagnostics_.error(code::kLoadBeyond, load.mass->place,
                     fmt::format("LOAD is 0kg or more and at most {}; this is {}",
                                 number_text(kMostLoad, kMass), number_text(*number, kMass)),
                     "LOAD 0kg lets go");
}

void StatementChecker::check_frame_uses(const Program& program) {
  for (const Program::FrameUse& use : program.frame_uses) {
    if (scopes_.frame_of(use.frame) != nullptr) continue;
    scopes_.enter_file(use.place.file);
    const Symbol* const symbol = scopes_.find_global(use.frame->name);
    if (symbol != nullptr && !symbol->type.known()) continue;
    diagnostics_.error(code::kNoFrame, use.place,
                       fmt::format("{} is no FRAME of this program", shortened(use.frame->name)),
                       fmt::format("FRAME {} = POSE(…) declares one", shortened(use.frame->name)));
  }
}

}  // namespace rob::lang
