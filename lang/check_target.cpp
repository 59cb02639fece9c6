#include <algorithm>
#include <string>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include "lang/codes.h"
#include "lang/move_checker.h"
#include "lang/suggest.h"
#include "lang/target.h"

/// Target tuples against the robot's coordinates.
namespace rob::lang {
namespace {

std::vector<std::string_view> coordinate_names(const RobotSignature& robot) {
  std::vector<std::string_view> names;
  for (const RobotSignature::Coordinate& coordinate : robot.coordinates) {
    names.push_back(coordinate.name);
  }
  return names;
}

}  // namespace

bool MoveChecker::check_target(const Move& move) {
  const Expr& target = *move.target;
  const auto* const tuple = std::get_if<Tuple>(&target.node);
  if (tuple == nullptr) return check_value(move);
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
  if (!known(value.constant) || constant_component(value, wanted.dimension, robot_)) return true;
  diagnostics_.error(code::kNotFinite, value.place, "this is beyond the range of numbers");
  return false;
}

}  // namespace rob::lang
