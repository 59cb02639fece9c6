#include "lang/check/checker.h"

#include <algorithm>
#include <string>
#include <utility>

#include <fmt/core.h>

#include "lang/check/statement_checker.h"
#include "lang/code/chunk.h"
#include "lang/syntax/keywords.h"
#include "lang/text/ascii.h"
#include "lang/text/codes.h"

namespace rob::lang {
namespace {

bool is_constant(const ExprPtr& condition, bool value) {
  if (condition == nullptr) return false;
  const bool* const constant = std::get_if<bool>(&condition->constant);
  return constant != nullptr && *constant == value;
}

bool is_definition(Symbol::Kind kind) {
  return kind == Symbol::Kind::Routine || kind == Symbol::Kind::Record;
}

}  // namespace

/// Variables of more slots than that may not all find registers beside what is computed.
bool StatementChecker::take_memory_use() {
  const auto [numbers, texts] = std::exchange(inside_.most_declared, Slots{});
  inside_.declared = {};
  const bool many = std::max(numbers, texts) > kVariableRegisters / 2;
  return expressions_.take_memory_use() || many;
}

void StatementChecker::warn_of_name(Symbol::Kind kind, const std::string& name, Place place) {
  if (const Symbol* const earlier = scopes_.find_innermost(name)) {
    if (may_be_anew(kind, *earlier)) return;
    diagnostics_.error(
        code::kDeclaredTwice, place,
        fmt::format("{} is already declared, in line {}", shortened(name), earlier->place.line),
        is_definition(kind) || is_definition(earlier->kind)
            ? "give one of them another name"
            : "to give it another value, write it without VAR");
  } else if (const auto files = scopes_.files_with(name);
             scopes_.at_top_level() && !files.empty()) {
    warn_of_hiding(name, place, files.front());
  } else if (scopes_.provided(name) || find_builtin(name, 0) != nullptr) {
    diagnostics_.warning(
        code::kHidesBuiltIn, place,
        fmt::format("{} hides what the language or the robot calls so", shortened(name)),
        "give it another name");
  }
}

const Symbol* StatementChecker::declare(Symbol::Kind kind, const std::string& name, Place place,
                                        Type type, Constant value) {
  warn_of_name(kind, name, place);
  if (!is_definition(kind) && elements_of(type) && is_channel_word(name)) {
    diagnostics_.error(
        code::kReservedName, place,
        fmt::format("{0}[1] is a channel of the robot; {0} cannot have elements", to_upper(name)),
        "choose another name");
  }
  Symbol symbol;
  symbol.kind = kind;
  symbol.name = name;
  symbol.type = type;
  symbol.place = place;
  symbol.global = scopes_.at_top_level() && !is_definition(kind);
  // What is known lives in the code.
  const bool takes_slots = !is_definition(kind) && !known(value);
  if (takes_slots) inside_.declared = inside_.declared + slots_of(type);
  inside_.most_declared = {std::max(inside_.most_declared.numbers, inside_.declared.numbers),
                           std::max(inside_.most_declared.texts, inside_.declared.texts)};
  symbol.value = std::move(value);
  const Symbol* const declared = scopes_.declare(std::move(symbol));
  if (declared->global) uses_.declared(*declared);
  return declared;
}

/// The value is checked before the names are known: VAR x = x + 1 means an earlier x.
void StatementChecker::check(Declaration& declaration) {
  const bool fixed =
      declaration.constant && declaration.type &&
      (declaration.type->is(Type::Kind::Frame) || declaration.type->is(Type::Kind::Tool));
  bool missed = false;
  const std::size_t told = diagnostics_.error_count();
  Type type = fixed ? expressions_.check_fixed(declaration.value, missed)
                    : expressions_.check(declaration.value);
  Constant value;
  bool accepted = true;
  if (declaration.type) {
    if (!expressions_.complete(*declaration.type, declaration.names.front().place)) {
      declaration.type = Type{};
    }
    type = *declaration.type;
    if (declaration.value != nullptr) {
      accepted =
          expressions_.accept(*declaration.value, type,
                              fmt::format("{} needs", shortened(declaration.names.front().name)));
    } else if (!has_default(type)) {
      diagnostics_.error(code::kValueNeeded, declaration.names.front().place,
                         fmt::format("{} needs a value: it is {}",
                                     shortened(declaration.names.front().name), in_words(type)));
    }
  }
  type = settled(type);
  // A constant text lives in a register: each use of it in the tree would be a copy.
  if (declaration.constant && declaration.value != nullptr && accepted && type != Type::string()) {
    value = converted(known_value(*declaration.value), type);
  }
  if (fixed && type.known() && declaration.value != nullptr) {
    check_frame(declaration, value, missed || diagnostics_.error_count() > told);
  }
  const auto kind = declaration.constant ? Symbol::Kind::NamedConstant : Symbol::Kind::Variable;
  for (Declaration::Declared& declared : declaration.names) {
    declared.symbol = declare(kind, declared.name, declared.place, type, value);
    if (declaration.frame != nullptr) scopes_.frame(*declared.symbol, declaration.frame);
  }
}

void StatementChecker::check(Assign& assign) {
  expressions_.check(assign.value);
  expressions_.check(assign.target);
  const Name* const root = root_of(*assign.target);
  if (root == nullptr) {
    diagnostics_.error(code::kNotAssignable, assign.target->place,
                       "only a variable, or a part of one, can be assigned");
    return;
  }
  if (const auto* const member = std::get_if<Member>(&assign.target->node);
      member != nullptr && angle_of(member->object->type, member->field)) {
    diagnostics_.error(code::kAngleAssigned, assign.target->place,
                       "an angle of a pose cannot be changed alone",
                       "build the pose anew: POSE(p.x, p.y, p.z, a, b, c)");
    return;
  }
  if (root->symbol == nullptr || !assignable(*root->symbol, assign.target->place)) return;
  uses_.written(*root->symbol);
  if (assign.value == nullptr) return;
  expressions_.accept(*assign.value, assign.target->type,
                      fmt::format("{} needs", shortened(root->symbol->name)));
}

bool StatementChecker::assignable(const Symbol& symbol, Place place) {
  const auto refuse = [&](std::string_view what, std::string help) {
    diagnostics_.error(code::kNotAssignable, place,
                       fmt::format("{} {}", shortened(symbol.name), what), std::move(help));
    return false;
  };
  switch (symbol.kind) {
    case Symbol::Kind::Variable:
      return true;
    case Symbol::Kind::NamedConstant:
      return refuse("is a constant", fmt::format("declare it with VAR in {} to change it",
                                                 diagnostics_.line_of(symbol.place, place)));
    case Symbol::Kind::LoopVariable:
      return refuse("is the variable of a FOR, which alone changes it",
                    "use a variable of its own, or WHILE");
    case Symbol::Kind::Signal:
      return symbol.output || refuse("is an input of the robot and can only be read", "");
    case Symbol::Kind::Point:
      return refuse("is a point, which TEACH alone changes",
                    "give the value to a variable, or TEACH it where the robot stands");
    case Symbol::Kind::Routine:
      return refuse("is a routine, not a variable", "");
    case Symbol::Kind::Record:
      return refuse("is a record, not a variable", "");
    case Symbol::Kind::BuiltIn:
    case Symbol::Kind::Reading:
      return refuse("belongs to the language and cannot be changed", "");
  }
  return false;
}

void StatementChecker::check_guarded(Block& block, bool unreached) {
  if (unreached) expressions_.enter_unreached();
  check(block);
  if (unreached) expressions_.leave_unreached();
}

void StatementChecker::check(If& conditional) {
  bool settled = false;
  for (If::Branch& branch : conditional.branches) {
    if (settled) expressions_.enter_unreached();
    expressions_.check_condition(branch.condition, "IF");
    if (settled) expressions_.leave_unreached();
    check_guarded(branch.body, settled || is_constant(branch.condition, false));
    settled = settled || is_constant(branch.condition, true);
  }
  check_guarded(conditional.otherwise, settled);
}

void StatementChecker::check(While& loop) {
  expressions_.check_condition(loop.condition, "WHILE");
  ++inside_.loops;
  check_guarded(loop.body, is_constant(loop.condition, false));
  --inside_.loops;
}

void StatementChecker::check(For& loop) {
  const Type type = check_range(loop);
  const Slots declared = inside_.declared;
  scopes_.enter();
  loop.symbol = declare(Symbol::Kind::LoopVariable, loop.variable, loop.variable_place, type, {});
  check_body(loop.body);
  scopes_.leave();
  inside_.declared = declared;
}

/// The type of the loop variable: what first value, last value and step have in common.
Type StatementChecker::check_range(For& loop) {
  Type type;
  for (const ExprPtr* part : {&loop.from, &loop.to, &loop.step}) {
    const Type next = expressions_.check(*part);
    if (*part == nullptr || next.kind == Type::Kind::Unknown) continue;
    if (!next.numeric()) {
      diagnostics_.error(code::kTypeMismatch, (*part)->place,
                         "FOR counts with numbers; this is " + described(**part));
      return {};
    }
    const Type common = common_type(type, next);
    if (!common.numeric()) {
      diagnostics_.error(
          code::kDimensionMismatch, (*part)->place,
          fmt::format("this is {}; the FOR began with {}", described(**part), in_words(type)),
          "first value, last value and STEP need the same unit");
      return {};
    }
    type = common;
  }
  if (loop.step == nullptr && !type.dimension.none()) {
    diagnostics_.error(code::kStepMissing, loop.variable_place,
                       fmt::format("a FOR over {} needs a STEP", in_words(type)),
                       "for example STEP " + example_of(type.dimension));
    return type;
  }
  check_constant_range(loop, type);
  return type;
}

void StatementChecker::check_constant_range(For& loop, const Type& type) {
  if (loop.from == nullptr || loop.to == nullptr || !expressions_.reached()) return;
  const Constant step = loop.step == nullptr ? Constant(std::int64_t{1}) : loop.step->constant;
  if (!known(step) || type.kind == Type::Kind::Unknown) return;
  // The step alone can be wrong even where the range is not known.
  const bool range_known = known(loop.from->constant) && known(loop.to->constant);
  const Constant zero(std::int64_t{0});
  const Slot first = to_slot(converted(range_known ? loop.from->constant : zero, type));
  const Slot last = to_slot(converted(range_known ? loop.to->constant : zero, type));
  const Slot stride = to_slot(converted(step, type));
  std::int64_t turns = 0;
  const ArithmeticError error =
      type.kind == Type::Kind::Int
          ? arithmetic::turns(first.integer, last.integer, stride.integer, turns)
          : arithmetic::turns(first.real, last.real, stride.real, turns);
  loop.turns = range_known && error == ArithmeticError::None && turns > 0;
  if (error == ArithmeticError::None) return;
  const ArithmeticErrorText text = describe(error);
  diagnostics_.error(text.code, loop.step == nullptr ? loop.variable_place : loop.step->place,
                     std::string(text.message), std::string(text.help));
}

CheckedProgram check(Program program, const RobotSignature& robot, const PointTable& points,
                     const TargetJudge& judge, Diagnostics& diagnostics, KnownNames known) {
  CheckedProgram checked{
      .program = std::move(program), .symbols = {}, .features = {}, .missing_points = {}};
  TypeDetail& joints = *checked.program.types->joints;
  if (joints.axes.empty()) {  // else it is that of an earlier entry of the prompt
    for (const RobotSignature::Coordinate& axis : robot.axes) joints.axes.push_back(axis.dimension);
    joints.slots.numbers = static_cast<int>(joints.axes.size());
  }
  StatementChecker(checked, robot, points, judge, diagnostics).check(checked.program, known);
  return checked;
}

}  // namespace rob::lang
