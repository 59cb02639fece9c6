#include "lang/check/target.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "lang/check/fold.h"
#include "lang/text/ascii.h"
#include "lang/values/arithmetic.h"
#include "lang/values/number_text.h"
#include "lang/values/units.h"

namespace rob::lang {
namespace {

/// The value of `0.3` or `-0.3` with the default unit behind its digits.
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
  return to_si(digits, default_unit(dimension, robot, component.place.file));
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
  return {.divisor = std::pow(10.0, -unit.exponent10), .factor = unit.factor};
}

bool is_bare(const Type& type) { return type.numeric() && type.dimension.none(); }

std::optional<double> constant_component(const Expr& component, Dimension dimension,
                                         const RobotSignature& robot) {
  const auto number = constant_number(component);
  if (!number || !is_bare(component.type)) return number;
  if (const auto literal = bare_literal(component, dimension, robot)) return literal;
  const BareUnit unit = bare_unit(dimension, robot, component.place);
  double si = 0;
  if (arithmetic::divide(*number, unit.divisor, si) != ArithmeticError::None ||
      arithmetic::multiply(si, unit.factor, si) != ArithmeticError::None) {
    return std::nullopt;
  }
  return si;
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
  return std::nullopt;
}

std::optional<MoveCommand::Bound> jerk_of(const Type& type) {
  if (type == Type::real(kJerk)) return MoveCommand::Bound::Tool;
  if (type == Type::real(kAngularJerk)) return MoveCommand::Bound::Rotary;
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
  const auto* const name = std::get_if<Name>(&move.target->node);
  const bool point =
      name != nullptr && name->symbol != nullptr && name->symbol->kind == Symbol::Kind::Point;
  return point ? name->symbol : nullptr;
}

bool alike(const std::vector<RobotSignature::Coordinate>& axes) {
  return std::ranges::all_of(
      axes, [&](const auto& axis) { return axis.dimension == axes.front().dimension; });
}

std::optional<double> constant_number(const Expr& expression) {
  const Constant real = converted(expression.constant, Type::real());
  const auto* const value = std::get_if<double>(&real);
  return value == nullptr ? std::nullopt : std::optional(*value);
}

}  // namespace rob::lang
