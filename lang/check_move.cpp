#include <algorithm>
#include <string>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include "lang/ascii.h"
#include "lang/codes.h"
#include "lang/move_checker.h"
#include "lang/number_text.h"
#include "lang/suggest.h"
#include "lang/target.h"

namespace rob::lang {
namespace {

std::vector<std::string_view> coordinate_names(const RobotSignature& robot) {
  std::vector<std::string_view> names;
  for (const RobotSignature::Coordinate& coordinate : robot.coordinates) {
    names.push_back(coordinate.name);
  }
  return names;
}

/// Whether an expression is made of nothing but numbers without a unit.
bool only_bare_literals(const Expr& expression) {
  struct Visitor {
    bool operator()(const NumberLiteral& literal) const { return !literal.has_unit; }
    bool operator()(const Unary& unary) const { return only_bare_literals(*unary.operand); }
    bool operator()(const Binary& binary) const {
      return only_bare_literals(*binary.left) && only_bare_literals(*binary.right);
    }
    bool operator()(const Call& call) const {
      return call.routine == nullptr &&
             std::ranges::all_of(call.arguments, [](const ExprPtr& argument) {
               return only_bare_literals(*argument);
             });
    }
    bool operator()(const BoolLiteral&) const { return false; }
    bool operator()(const StringLiteral&) const { return false; }
    bool operator()(const Name&) const { return false; }
    bool operator()(const Tuple&) const { return false; }
  };
  return std::visit(Visitor{}, expression.node);
}

}  // namespace

void MoveChecker::check(const Move& move) {
  bool sound = move.target != nullptr && check_target(*move.target);
  if (move.at != nullptr) {
    expressions_.check(move.at);
    sound = check_at(*move.at) && sound;
  }
  if (move.over != nullptr) {
    expressions_.check(move.over);
    sound = check_over(*move.over) && sound;
  }
  if (sound) remember_constants(move);
}

bool MoveChecker::check_target(const Expr& target) {
  const auto* const tuple = std::get_if<Tuple>(&target.node);
  if (tuple == nullptr) {
    diagnostics_.error(
        code::kComponentCount, target.place,
        fmt::format("MOVE needs a target of {} components: ({})", robot_.coordinates.size(),
                    fmt::join(coordinate_names(robot_), ", ")));
    return false;
  }
  // Checked whatever the shape of the tuple, so that all mistakes inside are found at once.
  for (const Tuple::Element& element : tuple->elements) expressions_.check(element.value);
  if (!check_shape(*tuple, target.place)) return false;
  bool sound = true;
  const auto elements = by_coordinate(*tuple, robot_);
  for (std::size_t i = 0; i < elements.size(); ++i) {
    if (elements[i] != nullptr) sound = check_component(*elements[i], i) && sound;
  }
  return sound;
}

bool MoveChecker::check_shape(const Tuple& tuple, Place place) {
  const auto named = static_cast<std::size_t>(std::ranges::count_if(
      tuple.elements, [](const Tuple::Element& element) { return !element.name.empty(); }));
  if (named > 0) {
    if (named == tuple.elements.size()) return check_names(tuple);
    diagnostics_.error(code::kMixedComponents, place, "some components are named and some are not",
                       "name all of them, or none");
    return false;
  }
  const std::size_t wanted = robot_.coordinates.size();
  const std::size_t given = tuple.elements.size();
  // Six axes: (x, y, z) keeps the orientation.
  if (given == wanted || (wanted == 6 && given == 3)) return true;
  diagnostics_.error(
      code::kComponentCount, place,
      fmt::format("a target of {} has {} components ({}); here are {}", robot_.name, wanted,
                  fmt::join(coordinate_names(robot_), ", "), given),
      given < wanted ? "leave a place empty to keep its value, as in (140, , ), or name components"
                     : "decimals are written with a point, as in 1.5");
  return false;
}

bool MoveChecker::check_names(const Tuple& tuple) {
  std::vector<bool> given(robot_.coordinates.size(), false);
  bool sound = true;
  for (const Tuple::Element& element : tuple.elements) {
    const auto coordinate = coordinate_named(robot_, element.name);
    if (!coordinate) {
      const std::string meant = did_you_mean(suggest(element.name, coordinate_names(robot_)));
      diagnostics_.error(
          code::kUnknownComponent, element.place,
          fmt::format("{} has no coordinate {}", robot_.name, shortened(element.name)),
          meant.empty() ? fmt::format("it has {}", fmt::join(coordinate_names(robot_), ", "))
                        : meant);
      sound = false;
    } else if (given[*coordinate]) {
      diagnostics_.error(code::kComponentTwice, element.place,
                         fmt::format("{} is given twice", robot_.coordinates[*coordinate].name));
      sound = false;
    } else {
      given[*coordinate] = true;
    }
  }
  return sound;
}

bool MoveChecker::check_component(const Tuple::Element& element, std::size_t coordinate) {
  const RobotSignature::Coordinate& wanted = robot_.coordinates[coordinate];
  const Expr& value = *element.value;
  if (value.type.kind == Type::Kind::Unknown) return false;
  if (!is_bare(value.type)) {
    return expressions_.accept(value, Type::real(wanted.dimension),
                               fmt::format("{} of MOVE needs", wanted.name));
  }
  if (!known(value.constant) || constant_component(value, wanted.dimension)) return true;
  diagnostics_.error(code::kNotFinite, value.place, "this is beyond the range of numbers");
  return false;
}

bool MoveChecker::check_at(const Expr& at_expression) {
  const Type& type = at_expression.type;
  if (type.kind == Type::Kind::Unknown) return false;
  if (type == Type::integer() || (is_bare(type) && only_bare_literals(at_expression))) {
    const auto value = constant_number(at_expression);
    // A number from 1 on is a percentage or a speed without its unit; below, a share of 1.
    const double percent = value.value_or(50) < 1 ? value.value_or(0.5) * 100 : value.value_or(50);
    diagnostics_.error(
        code::kShareWithoutPercent, at_expression.place,
        fmt::format("AT needs a speed or a share; this is {}", described(at_expression)),
        fmt::format("write AT {}% or AT {}mm/s", number_text(percent, kNone),
                    number_text(value.value_or(50), kNone)));
    return false;
  }
  if (!pace_of(type)) {
    diagnostics_.error(
        type.numeric() ? code::kDimensionMismatch : code::kTypeMismatch, at_expression.place,
        fmt::format("this is {}; AT needs a speed, an angular speed or a share here",
                    described(at_expression)),
        type == Type::real(kTime) ? "a duration is given by OVER" : "as in AT 20mm/s or AT 50%");
    return false;
  }
  if (!check_positive(at_expression, "AT")) return false;
  if (is_bare(type) && constant_number(at_expression).value_or(0) > 1) {
    diagnostics_.warning(code::kAboveMaximum, at_expression.place,
                         fmt::format("{}% is more than the robot can; it moves at 100%",
                                     number_text(*constant_number(at_expression) * 100, kNone)));
  }
  return true;
}

bool MoveChecker::check_over(const Expr& over) {
  if (over.type.kind == Type::Kind::Unknown) return false;
  return expressions_.accept(over, Type::real(kTime), "OVER needs") && check_positive(over, "OVER");
}

bool MoveChecker::check_positive(const Expr& value, std::string_view word) {
  const auto number = constant_number(value);
  if (!number || *number > 0) return true;
  diagnostics_.error(code::kNotPositive, value.place,
                     fmt::format("{} needs a value above zero; this is {}", word,
                                 text_of(value.constant, value.type)));
  return false;
}

void MoveChecker::remember_constants(const Move& move) {
  ConstantTarget constant{.place = move.target->place, .command = {}};
  MoveCommand& command = constant.command;
  const auto elements = by_coordinate(std::get<Tuple>(move.target->node), robot_);
  command.count = static_cast<int>(elements.size());
  for (std::size_t i = 0; i < elements.size(); ++i) {
    if (elements[i] == nullptr) continue;
    const auto value = constant_component(*elements[i]->value, robot_.coordinates[i].dimension);
    if (!value) continue;
    command.target[i] = *value;
    command.given = static_cast<std::uint8_t>(command.given | 1U << i);
  }
  if (command.given == 0) return;
  if (move.at != nullptr && constant_number(*move.at)) {
    command.pace = *pace_of(move.at->type);
    command.pace_value = *constant_number(*move.at);
  }
  if (move.over != nullptr) command.over = constant_number(*move.over).value_or(0);
  constant_targets_.push_back(constant);
}

}  // namespace rob::lang
