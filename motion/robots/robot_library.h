#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "motion/robots/robot_model.h"

namespace rob::motion {

/// A robot file carried inside the library (motion/robots/*.toml, put there by embed.cmake).
struct EmbeddedRobot {
  std::string_view name;
  std::string_view text;
};

std::span<const EmbeddedRobot> embedded_robots();

/// In alphabetical order.
std::vector<std::string_view> robot_names();

/// The robot of that name; throws RobotFileError, with a suggestion, if there is none.
RobotModel embedded_robot(std::string_view name);

/// A robot by its name, or by its file if that ends in ".toml". Throws RobotFileError for an
/// unknown name or a faulty file, RobotFileUnreadable for one that cannot be read.
RobotModel load_robot(std::string_view name_or_file);
/// The things in the file of a cell stand around the robot, too. Throws RobotFileError for a
/// faulty file, RobotFileUnreadable for one that cannot be read.
void load_cell(const std::string& file, RobotModel& robot);

}  // namespace rob::motion
