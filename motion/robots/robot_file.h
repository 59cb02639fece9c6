#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

#include "motion/robots/robot_model.h"

namespace rob::motion {

/// A robot file that is wrong. what() is "file:line:column: what is wrong, and the remedy".
class RobotFileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A robot file that cannot be read. what() says why, and the remedy.
class RobotFileUnreadable : public RobotFileError {
 public:
  using RobotFileError::RobotFileError;
};

/// Reads a robot file (TOML, docs/adding-a-robot.md). `file_name` is for messages only.
/// Throws RobotFileError for a missing, unknown, double, zero, negative or absurd entry, a unit
/// that does not fit, or limits that contradict each other.
RobotModel parse_robot_file(std::string_view text, std::string_view file_name);

}  // namespace rob::motion
