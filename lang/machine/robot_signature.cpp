#include "lang/machine/robot_signature.h"

#include <fmt/core.h>

namespace rob::lang {

std::string shown_name(const RobotSignature::Signal& signal) {
  if (!signal.name.empty()) return signal.name;
  return fmt::format("{}[{}]", channel_word(signal.output, signal.analog), signal.channel);
}

std::vector<RobotSignature::Coordinate> elements_of(const RobotSignature& robot) {
  std::vector<RobotSignature::Coordinate> elements = robot.coordinates;
  elements.insert(elements.end(), robot.grippers.begin(), robot.grippers.end());
  return elements;
}

}  // namespace rob::lang
