#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "lang/check/expression_checker.h"
#include "lang/check/target.h"
#include "lang/text/ascii.h"
#include "lang/text/codes.h"

/// Member functions of ExpressionChecker for JOINTS: one value for each axis of the robot.
namespace rob::lang {
namespace {

std::string axis_names(const RobotSignature& robot) {
  std::vector<std::string_view> names;
  for (const RobotSignature::Coordinate& axis : robot.axes) names.push_back(axis.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace

bool ExpressionChecker::has_sensor(Reading reading, Place place) {
  if (!needs_sensor(reading) || robot_.force_sensor) return true;
  diagnostics_.error(
      code::kNoForceSensor, place,
      fmt::format("{} has no force sensor: it cannot read {}", robot_.name, name_of(reading)),
      "`rob robots` tells which robot has one");
  return false;
}

/// JOINTS() · JOINTS(q1, …, qn) · JOINTS(p) · JOINTS(p, near: j)
Type ExpressionChecker::check_joints(const Call& call, Expr& expression) {
  const std::size_t given = call.arguments.size();
  if (given > 0 && call.arguments.front()->type.is_place()) return check_inverse(call);
  if (std::ranges::any_of(call.names, [](const std::string& name) { return !name.empty(); })) {
    diagnostics_.error(code::kArgumentName, expression.place,
                       "the values of JOINTS have no names: they stand in the order of the axes",
                       fmt::format("the axes are {}", axis_names(robot_)));
    return {};
  }
  if (given == 0) return joints();
  if (given != robot_.axes.size()) {
    diagnostics_.error(code::kArgumentCount, expression.place,
                       fmt::format("JOINTS needs a value for each axis of {} ({}); here are {}",
                                   robot_.name, axis_names(robot_), given));
    return {};
  }
  std::vector<double> values;
  for (std::size_t i = 0; i < given; ++i) {
    const Expr& value = *call.arguments[i];
    const RobotSignature::Coordinate& axis = robot_.axes[i];
    if (!accept(value, Type::real(axis.dimension), fmt::format("axis {} needs", axis.name))) {
      return {};
    }
    if (const auto known = constant_number(value)) values.push_back(*known);
  }
  if (values.size() == given) expression.constant = std::move(values);
  return joints();
}

/// The axis values that bring the tool to a pose: the robot computes them while the program runs.
Type ExpressionChecker::check_inverse(const Call& call) {
  const bool named = call.names.size() > 1 && !call.names[1].empty();
  const bool sound = call.arguments.size() <= 2 && (call.names.empty() || call.names[0].empty()) &&
                     (!named || same_word(call.names[1], "near"));
  if (!sound) {
    diagnostics_.error(code::kArgumentName, call.arguments.back()->place,
                       "JOINTS of a pose takes the pose, and perhaps the joints to stay near to",
                       "as in JOINTS(p, near: JOINTS())");
    return {};
  }
  if (!accept(*call.arguments[0], Type::pose(), "JOINTS needs")) return {};
  const bool near = call.arguments.size() == 2;
  return !near || accept(*call.arguments[1], joints(), "near needs") ? joints() : Type{};
}

/// What `j[i]` is: it must be known which axis is meant, unless all take values of one dimension.
Type ExpressionChecker::axis_type(const Index& index, const Type& whole) {
  const std::vector<Dimension>& axes = whole.detail->axes;
  const auto* const number = std::get_if<std::int64_t>(&index.index->constant);
  if (number != nullptr) {
    const bool there = *number >= 1 && *number <= static_cast<std::int64_t>(axes.size());
    return there ? Type::real(axes[static_cast<std::size_t>(*number - 1)]) : Type{};
  }
  if (alike(robot_.axes)) return Type::real(axes.front());
  diagnostics_.error(code::kAxisNotConstant, index.index->place,
                     fmt::format("the axes of {} are of different kinds: which one is meant has to "
                                 "be a constant",
                                 robot_.name),
                     fmt::format("write a number from 1 to {}", axes.size()));
  return {};
}

}  // namespace rob::lang
