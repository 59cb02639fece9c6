#include "lang/check/meaning.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "lang/check/fold.h"
#include "lang/text/ascii.h"
#include "lang/values/arithmetic.h"
#include "lang/values/number_text.h"
#include "lang/values/pose_slots.h"
#include "lang/values/units.h"

namespace rob::lang {

// Expressions

std::optional<double> constant_number(const Expr& expression) {
  const Constant real = converted(expression.constant, Type::real());
  const auto* const value = std::get_if<double>(&real);
  return value == nullptr ? std::nullopt : std::optional(*value);
}

bool is_bare(const Type& type) { return type.numeric() && type.dimension.none(); }

std::optional<Reading> reading_of(const Call& call) {
  if (call.routine != nullptr || !call.arguments.empty()) return std::nullopt;
  if (same_word(call.callee, "JOINTS")) return Reading::Joints;
  if (same_word(call.callee, "WRENCH")) return Reading::Wrench;
  if (same_word(call.callee, "UNIX")) return Reading::Unix;
  if (same_word(call.callee, "NOW")) return Reading::Now;
  return std::nullopt;
}

bool asks_for_file(const Call& call) {
  if (call.routine != nullptr) return false;
  const Builtin* const builtin = find_builtin(call.callee, call.arguments.size());
  return builtin != nullptr && builtin->rule == BuiltinRule::FileExists;
}

namespace {

/// Calls `visit` for each name and each call in an expression; what is constant is not looked at.
template <typename Visit>
void each_use(const Expr& expression, const Visit& visit) {
  if (known(expression.constant)) return;
  if (const auto* const name = std::get_if<Name>(&expression.node)) visit(*name);
  if (const auto* const call = std::get_if<Call>(&expression.node)) visit(*call);
  each_part(expression, [&](const Expr& part) { each_use(part, visit); });
}

bool is_observed(const Name& name) {
  // A name that is not known is reported already; it may have been meant for a signal.
  if (name.symbol == nullptr || name.symbol->kind == Symbol::Kind::Signal) return true;
  const bool reading = name.symbol->kind == Symbol::Kind::Reading;
  return name.symbol->observed || (reading && is_observation(name.symbol->reading));
}
bool is_observed(const Call& call) { return reading_of(call) || asks_for_file(call); }

const Symbol* symbol_of(const Name& name) { return name.symbol; }
const Symbol* symbol_of(const Call& /*call*/) { return nullptr; }

}  // namespace

int observations(const Expr& expression) {
  int count = 0;
  each_use(expression, [&](const auto& use) { count += is_observed(use) ? 1 : 0; });
  return count;
}

std::vector<const Symbol*> observed_globals(const Expr& expression) {
  std::vector<const Symbol*> found;
  each_use(expression, [&](const auto& use) {
    const Symbol* const symbol = symbol_of(use);
    const bool is_new = std::ranges::find(found, symbol) == found.end();
    if (symbol != nullptr && symbol->observed && is_new) found.push_back(symbol);
  });
  return found;
}

bool reads_global(const Expr& expression) {
  bool found = false;
  each_use(expression, [&](const auto& use) {
    const Symbol* const symbol = symbol_of(use);
    found =
        found || (symbol != nullptr && symbol->global && symbol->kind == Symbol::Kind::Variable);
  });
  return found;
}

const Builtin* find_builtin(const Call& call) {
  const Builtin* const plain = find_builtin(call.callee, call.arguments.size());
  if (plain == nullptr || call.arguments.empty()) return plain;
  const Type& first = call.arguments.front()->type;
  const bool array = first.has_row();
  const bool enumeration = first.is(Type::Kind::Enum);
  if (!array && !enumeration && !first.text() && !first.is_place()) return plain;
  const auto is_for = [&](BuiltinRule rule) {
    if (enumeration) return rule == BuiltinRule::Ordinal;
    if (first.text()) return rule == BuiltinRule::Texts;
    if (!array) return rule == BuiltinRule::Places;
    return rule == BuiltinRule::ArrayLength || rule == BuiltinRule::RowNumber;
  };
  for (const Builtin& builtin : builtins()) {
    if (builtin.name == plain->name && is_for(builtin.rule) &&
        builtin.least == call.arguments.size()) {
      return &builtin;
    }
  }
  return plain;
}

bool computes_whole(const Builtin& builtin, const Call& call) {
  return builtin.integer != nullptr &&
         std::ranges::all_of(call.arguments, [](const ExprPtr& argument) {
           return argument->type.kind == Type::Kind::Int;
         });
}

// Calls of routines

bool calls_routine(const Expr& expression) {
  const auto* const call = std::get_if<Call>(&expression.node);
  if (call != nullptr && call->routine != nullptr) return true;
  bool found = false;
  each_part(expression, [&](const Expr& part) { found = found || calls_routine(part); });
  return found;
}

// Target tuples and clauses

namespace {

/// The value of `0.3` or `-0.3` with the default unit after its digits.
std::optional<double> bare_literal(const Expr& component, Dimension dimension,
                                   const RobotSignature& robot) {
  if (const auto* const unary = std::get_if<Unary>(&component.node)) {
    const auto value = bare_literal(*unary->operand, dimension, robot);
    if (!value || unary->op != UnaryOp::Negate) return value;
    return 0 - *value;
  }
  const auto* const literal = std::get_if<NumberLiteral>(&component.node);
  if (literal == nullptr || literal->has_unit) return std::nullopt;
  const std::string digits =
      literal->is_integer ? std::to_string(literal->integer) : number_text(literal->value, kNone);
  return quantity_of(digits, default_unit(dimension, robot, component.place.file));
}

}  // namespace

Unit default_unit(Dimension dimension, const RobotSignature& robot, std::uint32_t file) {
  if (file < robot.units.size()) {
    for (const Unit& unit : robot.units[file]) {
      if (unit.dimension == dimension) return unit;
    }
  }
  return find_unit(unit_text(dimension)).value_or(Unit{.dimension = dimension});
}

std::optional<std::size_t> coordinate_named(const Coordinates& coordinates, std::string_view name) {
  for (std::size_t i = 0; i < coordinates.size(); ++i) {
    if (same_word(coordinates[i].name, name)) return i;
  }
  return std::nullopt;
}

std::vector<const Tuple::Element*> by_coordinate(const Tuple& tuple,
                                                 const Coordinates& coordinates) {
  std::vector<const Tuple::Element*> elements(coordinates.size(), nullptr);
  for (std::size_t i = 0; i < tuple.elements.size(); ++i) {
    const Tuple::Element& element = tuple.elements[i];
    if (element.value == nullptr) continue;
    const std::size_t place =
        element.name.empty() ? i : coordinate_named(coordinates, element.name).value_or(i);
    if (place < elements.size()) elements[place] = &element;
  }
  return elements;
}

BareUnit bare_unit(Dimension dimension, const RobotSignature& robot, const Place& place) {
  const Unit unit = default_unit(dimension, robot, place.file);
  const double shift = std::pow(10.0, std::abs(unit.exponent10));
  return unit.exponent10 < 0 ? BareUnit{.divisor = shift * unit.divisor, .factor = unit.factor}
                             : BareUnit{.divisor = unit.divisor, .factor = shift * unit.factor};
}

std::optional<double> constant_component(const Expr& component, Dimension dimension,
                                         const RobotSignature& robot) {
  const auto number = constant_number(component);
  if (!number || !is_bare(component.type)) return number;
  if (const auto literal = bare_literal(component, dimension, robot)) return literal;
  const BareUnit unit = bare_unit(dimension, robot, component.place);
  double quantity = 0;
  if (arithmetic::divide(*number, unit.divisor, quantity) != ArithmeticError::None ||
      arithmetic::multiply(quantity, unit.factor, quantity) != ArithmeticError::None) {
    return std::nullopt;
  }
  return quantity;
}

std::optional<MoveCommand::Pace> pace_of(const Type& type) {
  if (type.kind != Type::Kind::Real) return std::nullopt;
  if (type.dimension == kSpeed) return MoveCommand::Pace::ToolSpeed;
  if (type.dimension == kAngularSpeed) return MoveCommand::Pace::AngularSpeed;
  if (type.dimension.none()) return MoveCommand::Pace::Share;
  return std::nullopt;
}

std::optional<MoveCommand::Bound> accel_of(const Type& type) {
  if (type == Type::real(kAcceleration)) return MoveCommand::Bound::Tool;
  if (type == Type::real(kAngularAcceleration)) return MoveCommand::Bound::Rotary;
  if (type == Type::real()) return MoveCommand::Bound::Share;
  return std::nullopt;
}

std::optional<MoveCommand::Bound> jerk_of(const Type& type) {
  if (type == Type::real(kJerk)) return MoveCommand::Bound::Tool;
  if (type == Type::real(kAngularJerk)) return MoveCommand::Bound::Rotary;
  if (type == Type::real()) return MoveCommand::Bound::Share;
  return std::nullopt;
}

std::optional<MoveCommand::Zone> zone_of(const Type& type) {
  if (type == Type::real(kLength)) return MoveCommand::Zone::Length;
  if (type == Type::real(kTime)) return MoveCommand::Zone::Time;
  if (is_bare(type)) return MoveCommand::Zone::Share;
  return std::nullopt;
}

const Symbol* bare_point(const Move& move) {
  if (move.kind != MotionKind::Joint || move.by || move.axis != nullptr) return nullptr;
  if (move.clauses.near != nullptr || move.clauses.free != FreeTurn::None) return nullptr;
  const auto* const name = std::get_if<Name>(&move.target->node);
  const bool point =
      name != nullptr && name->symbol != nullptr && name->symbol->kind == Symbol::Kind::Point;
  return point ? name->symbol : nullptr;
}

std::optional<Vector3> frame_axis(const Move& move) {
  const Expr& target = *move.target;
  if (move.by || !target.type.is_place() || is_free(as_pose(target.type))) return std::nullopt;
  const Symbol* const frame = target.moved_from;
  if (frame == nullptr) return Vector3{0, 0, 1};
  return pose_math::rotate(load_pose(to_slots(frame->value).data()).rotation, {0, 0, 1});
}

bool alike(const std::vector<RobotSignature::Coordinate>& axes) {
  return std::ranges::all_of(
      axes, [&](const auto& axis) { return axis.dimension == axes.front().dimension; });
}

}  // namespace rob::lang
