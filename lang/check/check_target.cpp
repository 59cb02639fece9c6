#include <algorithm>
#include <string>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include "lang/check/move_checker.h"
#include "lang/check/target.h"
#include "lang/text/codes.h"
#include "lang/text/suggest.h"

/// Target tuples against the robot's coordinates.
namespace rob::lang {
namespace {

std::vector<std::string_view> names_of(const Coordinates& coordinates) {
  std::vector<std::string_view> names;
  for (const RobotSignature::Coordinate& coordinate : coordinates) {
    names.push_back(coordinate.name);
  }
  return names;
}

}  // namespace

bool MoveChecker::check_target(const Move& move, const ExprPtr& point) {
  const Expr& target = *point;
  const auto* const tuple = std::get_if<Tuple>(&target.node);
  if (tuple == nullptr) return check_value(move, point);
  // Checked whatever the shape of the tuple, so that all mistakes inside are found at once.
  for (const Tuple::Element& element : tuple->elements) expressions_.check(element.value);
  if (!check_shape(*tuple, robot_.coordinates, target.place)) return false;
  bool sound = true;
  const auto elements = by_coordinate(*tuple, robot_.coordinates);
  for (std::size_t i = 0; i < elements.size(); ++i) {
    if (elements[i] == nullptr) continue;
    sound = check_component(word_of(move.kind), *elements[i], i) && sound;
  }
  return sound;
}

bool MoveChecker::check_shape(const Tuple& tuple, const Coordinates& coordinates, Place place) {
  const auto named = static_cast<std::size_t>(std::ranges::count_if(
      tuple.elements, [](const Tuple::Element& element) { return !element.name.empty(); }));
  if (named > 0) {
    if (named == tuple.elements.size()) return check_names(tuple, coordinates);
    diagnostics_.error(code::kMixedComponents, place, "some components are named and some are not",
                       "name all of them, or none");
    return false;
  }
  const std::size_t wanted = coordinates.size();
  const std::size_t given = tuple.elements.size();
  // Six axes: (x, y, z) keeps the orientation.
  if (given == wanted || (wanted == 6 && given == 3)) return true;
  diagnostics_.error(
      code::kComponentCount, place,
      fmt::format("a target of {} has {} components ({}); here are {}", robot_.name, wanted,
                  fmt::join(names_of(coordinates), ", "), given),
      given == 1
          ? "a pose stands without parentheses, as in MOVE pick; one component, as in (140, , )"
      : given < wanted
          ? "leave a place empty to keep its value, as in (140, , ), or name components"
          : "decimals are written with a point, as in 1.5");
  return false;
}

bool MoveChecker::check_names(const Tuple& tuple, const Coordinates& coordinates) {
  std::vector<bool> given(coordinates.size(), false);
  bool sound = true;
  for (const Tuple::Element& element : tuple.elements) {
    const auto coordinate = coordinate_named(coordinates, element.name);
    if (!coordinate) {
      const std::string meant = did_you_mean(suggest(element.name, names_of(coordinates)));
      diagnostics_.error(
          code::kUnknownComponent, element.place,
          fmt::format("{} has no coordinate {}", robot_.name, shortened(element.name)),
          meant.empty() ? fmt::format("it has {}", fmt::join(names_of(coordinates), ", ")) : meant);
      sound = false;
    } else if (given[*coordinate]) {
      diagnostics_.error(code::kComponentTwice, element.place,
                         fmt::format("{} is given twice", coordinates[*coordinate].name));
      sound = false;
    } else {
      given[*coordinate] = true;
    }
  }
  return sound;
}

bool MoveChecker::check_component(std::string_view word, const Tuple::Element& element,
                                  std::size_t coordinate) {
  const RobotSignature::Coordinate& wanted = robot_.coordinates[coordinate];
  const Expr& value = *element.value;
  if (value.type.kind == Type::Kind::Unknown) return false;
  if (!is_bare(value.type)) {
    return expressions_.accept(value, Type::real(wanted.dimension),
                               fmt::format("{} of {} needs", wanted.name, word));
  }
  if (!known(value.constant) || constant_component(value, wanted.dimension, robot_)) return true;
  diagnostics_.error(code::kNotFinite, value.place, "this is beyond the range of numbers");
  return false;
}

}  // namespace rob::lang
