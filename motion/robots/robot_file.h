#pragma once

#include <string_view>

#include "motion/robots/robot_file_error.h"
#include "motion/robots/robot_model.h"

namespace rob::motion {

/// Reads a robot file (TOML, docs/adding-a-robot.md). `file_name` is for messages only.
/// Throws RobotFileError for a missing, unknown, double, zero, negative or absurd entry, a unit
/// that does not fit, or limits that contradict each other.
RobotModel parse_robot_file(std::string_view text, std::string_view file_name);

}  // namespace rob::motion
