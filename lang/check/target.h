#pragma once

#include <optional>
#include <vector>

#include "lang/check/symbols.h"
#include "lang/machine/move_command.h"
#include "lang/machine/robot_signature.h"
#include "lang/syntax/ast.h"

/// What checker and compiler both have to know of target tuples and of clauses.
namespace rob::lang {

/// Coordinates or axes of a robot.
using Coordinates = std::vector<RobotSignature::Coordinate>;

/// The element of a well-formed tuple for each coordinate, in the robot's order; null where the
/// coordinate was left out.
std::vector<const Tuple::Element*> by_coordinate(const Tuple& tuple,
                                                 const Coordinates& coordinates);

/// The index of a coordinate by its name in any case, or nothing.
std::optional<std::size_t> coordinate_named(const Coordinates& coordinates, std::string_view name);

/// What the rates of a JOG are of.
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

/// Whether a component is a bare number, to be taken in UNITS.
bool is_bare(const Type& type);

/// The value of a constant component in SI. A bare literal is read as though its unit stood behind
/// it, so that 0.3 and 0.3mm are the same bits; other bare values are converted as computed ones
/// are. Nothing if it is not constant, or beyond the range of numbers.
std::optional<double> constant_component(const Expr& component, Dimension dimension,
                                         const RobotSignature& robot);

/// What an AT of this type bounds; nothing if AT takes no such type.
std::optional<MoveCommand::Pace> pace_of(const Type& type);

/// What an ACCEL, a JERK or a ZONE of this type bounds; nothing if it takes no such type.
std::optional<MoveCommand::Bound> accel_of(const Type& type);
std::optional<MoveCommand::Bound> jerk_of(const Type& type);
std::optional<MoveCommand::Zone> zone_of(const Type& type);

/// The POINT that is by itself the target of a MOVE, which goes to where the joints stood when it
/// was taught, if they still bring the tool to it; null for all other motions.
const Symbol* bare_point(const Move& move);

/// Whether axes all have one dimension.
bool alike(const std::vector<RobotSignature::Coordinate>& axes);

/// A constant INT or REAL as a double.
std::optional<double> constant_number(const Expr& expression);

}  // namespace rob::lang
