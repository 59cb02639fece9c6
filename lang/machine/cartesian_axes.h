#pragma once

#include <span>
#include <vector>

#include "lang/machine/move_command.h"
#include "lang/machine/robot_signature.h"
#include "lang/values/pose_math.h"

/// The kinematics of a robot whose coordinates are those of its tool: x, y, z move it along the
/// axes of the world; a, b, c (or theta) turn it about them. Tests use it instead of a robot.
namespace rob::lang {

/// Coordinates of other names move nothing.
PoseValue tool_of(const std::vector<RobotSignature::Coordinate>& coordinates,
                  std::span<const double> values);

/// The values that bring the tool to `pose`; false if there are none: the robot lacks a coordinate.
bool coordinates_of(const std::vector<RobotSignature::Coordinate>& coordinates,
                    const PoseValue& pose, std::span<double> values);

/// A pose with those of its parts replaced that a tuple gives or, with BY, with the tuple added.
PoseValue with_coordinates(const std::vector<RobotSignature::Coordinate>& coordinates,
                           const PoseValue& pose, const MoveCommand& command);

}  // namespace rob::lang
