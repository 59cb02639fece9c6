#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include "lang/check/symbols.h"
#include "lang/machine/move_command.h"
#include "lang/machine/reading.h"
#include "lang/machine/robot_signature.h"
#include "lang/syntax/ast.h"
#include "lang/values/builtins.h"

/// The meaning of the parts of a checked program, which both the checker and the compiler need.
namespace rob::lang {

// Expressions

/// A constant INT or REAL as a double.
std::optional<double> constant_number(const Expr& expression);
/// Whether it is a plain number: in a target it is taken in UNITS.
bool is_bare(const Type& type);

/// Calls `visit` for the parts that an expression is directly made of, in their order.
template <typename Visit>
void each_part(const Expr& expression, const Visit& visit) {
  const auto go = [&](const ExprPtr& part) {
    if (part != nullptr) visit(*part);
  };
  std::visit(
      [&]<typename Node>(const Node& node) {
        if constexpr (std::is_same_v<Node, Unary>) {
          go(node.operand);
        } else if constexpr (std::is_same_v<Node, Binary>) {
          go(node.left);
          go(node.right);
        } else if constexpr (std::is_same_v<Node, Call>) {
          for (const ExprPtr& argument : node.arguments) go(argument);
        } else if constexpr (std::is_same_v<Node, Tuple>) {
          for (const Tuple::Element& element : node.elements) go(element.value);
        } else if constexpr (std::is_same_v<Node, List>) {
          for (const ExprPtr& element : node.elements) go(element);
        } else if constexpr (std::is_same_v<Node, Member>) {
          go(node.object);
        } else if constexpr (std::is_same_v<Node, Chain>) {
          go(node.first);
          for (const Chain::Step& step : node.steps) go(step.term);
        } else if constexpr (std::is_same_v<Node, Index>) {
          go(node.object);
          go(node.index);
        }
      },
      expression.node);
}

/// The reading of the robot that a call of a built-in function makes: JOINTS(), WRENCH().
std::optional<Reading> reading_of(const Call& call);

/// Whether a call looks for a file: EXISTS("x").
bool asks_for_file(const Call& call);

/// How many observations of the world a checked expression can make; what is constant makes none.
/// Where it is known already that a TASK changes a global, reading it is one.
int observations(const Expr& expression);

/// The globals in an expression that TASKs change, each once.
std::vector<const Symbol*> observed_globals(const Expr& expression);
/// Whether it reads a variable of the top level.
bool reads_global(const Expr& expression);

/// The one that a call with checked arguments means: of those that take so many, the one for texts,
/// poses, arrays or values of an ENUM if the first argument is one.
const Builtin* find_builtin(const Call& call);
/// Whether a checked call computes with INT slots: all its arguments are INT, and the function has
/// such a case. Otherwise its arguments are converted to REAL.
bool computes_whole(const Builtin& builtin, const Call& call);

// Calls of routines

/// One parameter of a routine, and the group it was written in.
struct Parameter {
  const Routine::Parameters* group;
  const Declaration::Declared* declared;
};

inline std::vector<Parameter> parameters_of(const Routine& routine) {
  std::vector<Parameter> parameters;
  for (const Routine::Parameters& group : routine.parameters) {
    for (const Declaration::Declared& declared : group.names) {
      parameters.push_back({&group, &declared});
    }
  }
  return parameters;
}

/// Whether computing an expression calls a routine, which may change variables.
bool calls_routine(const Expr& expression);

// Target tuples and clauses

/// Coordinates or axes of a robot.
using Coordinates = std::vector<RobotSignature::Coordinate>;

/// The element of a well-formed tuple for each coordinate, in the robot's order; null where the
/// coordinate was left out.
std::vector<const Tuple::Element*> by_coordinate(const Tuple& tuple,
                                                 const Coordinates& coordinates);

/// The index of a coordinate by its name in any case, or nothing.
std::optional<std::size_t> coordinate_named(const Coordinates& coordinates, std::string_view name);

/// The coordinates or axes that the rates of a JOG belong to.
inline const Coordinates& jogged(JogFrame frame, const RobotSignature& robot) {
  return frame == JogFrame::Joint ? robot.axes : robot.coordinates;
}

/// The unit of bare numbers of a dimension in targets: that of UNITS in the file, else mm or deg.
Unit default_unit(Dimension dimension, const RobotSignature& robot, std::uint32_t file);

/// A bare number in a target takes the UNITS of its place: si = number / divisor * factor, in two
/// steps since 40 / 1000 is the double nearest to 0.04, which 40 * 0.001 need not be.
struct BareUnit {
  double divisor = 1;
  double factor = 1;
};
BareUnit bare_unit(Dimension dimension, const RobotSignature& robot, const Place& place);

/// The quantity of a constant component. A bare literal is read as though its unit stood after
/// it, so that 0.3 and 0.3mm are the same bits; other bare values are converted as computed ones
/// are. Nothing if it is not constant, or beyond the range of numbers.
std::optional<double> constant_component(const Expr& component, Dimension dimension,
                                         const RobotSignature& robot);

/// The pace that an AT of this type bounds; nothing if AT takes no such type.
std::optional<MoveCommand::Pace> pace_of(const Type& type);

/// The bound that an ACCEL, a JERK or a ZONE of this type gives; nothing if it takes no such type.
std::optional<MoveCommand::Bound> accel_of(const Type& type);
std::optional<MoveCommand::Bound> jerk_of(const Type& type);
std::optional<MoveCommand::Zone> zone_of(const Type& type);

/// The POINT that is by itself the target of a MOVE, which goes to where the joints stood when it
/// was taught, if they still bring the tool to it; null for all other motions. With NEAR or FREE
/// the pose counts.
const Symbol* bare_point(const Move& move);

/// z, in the world, of the frame that the target of a motion says it is in; none where IN, or the
/// world without it, says that.
std::optional<Vector3> frame_axis(const Move& move);

/// Whether axes all have one dimension.
bool alike(const std::vector<RobotSignature::Coordinate>& axes);

}  // namespace rob::lang
