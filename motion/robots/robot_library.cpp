#include "motion/robots/robot_library.h"

#include <algorithm>

#include "motion/robots/closest_name.h"
#include "motion/robots/robot_file.h"

namespace rob::motion {

std::vector<std::string_view> robot_names() {
  std::vector<std::string_view> names;
  for (const EmbeddedRobot& robot : embedded_robots()) names.push_back(robot.name);
  std::sort(names.begin(), names.end());
  return names;
}

RobotModel embedded_robot(std::string_view name) {
  for (const EmbeddedRobot& robot : embedded_robots())
    if (robot.name == name) return parse_robot_file(robot.text, std::string(name).append(".toml"));

  const std::vector<std::string_view> names = robot_names();
  const std::string_view close = closest_name(name, names);
  std::string message = "there is no robot '";
  message.append(name).append("'; ");
  if (!close.empty()) {
    message.append("did you mean '").append(close).append("'?");
  } else {
    message.append("known are");
    for (const std::string_view known : names) message.append(" ").append(known);
    message.append("; a file of your own is named with its ending, .toml");
  }
  throw RobotFileError(message);
}

}  // namespace rob::motion
