#include "runtime/words/signature.h"

#include <algorithm>

namespace rob::runtime {

namespace {

/// The channels of one kind that the robot file gives no name.
void add_unnamed(lang::RobotSignature& signature, bool output, bool analog, int count) {
  for (int channel = 1; channel <= count; ++channel) {
    const bool named = std::ranges::any_of(signature.signals, [&](const auto& signal) {
      return signal.output == output && signal.analog == analog && signal.channel == channel;
    });
    if (!named) signature.signals.push_back({"", output, channel, analog});
  }
}

std::vector<lang::RobotSignature::Coordinate> tool_coordinates(const std::vector<int>& named) {
  const std::vector<lang::RobotSignature::Coordinate> all{
      {"x", lang::kLength}, {"y", lang::kLength}, {"z", lang::kLength},
      {"a", lang::kAngle},  {"b", lang::kAngle},  {"c", lang::kAngle}};
  std::vector<lang::RobotSignature::Coordinate> coordinates;
  for (const int i : named) coordinates.push_back(all[static_cast<std::size_t>(i)]);
  return coordinates;
}

}  // namespace

lang::RobotSignature signature_of(const motion::RobotModel& robot) {
  lang::RobotSignature signature;
  signature.name = robot.name;
  for (const motion::Axis& axis : robot.axes) {
    const bool linear = axis.kind == motion::AxisKind::Linear;
    signature.axes.push_back({axis.name, linear ? lang::kLength : lang::kAngle});
  }
  signature.coordinates =
      robot.tool_coordinates ? tool_coordinates(robot.coordinates) : signature.axes;
  if (robot.gripper >= 0) {
    if (!robot.tool_coordinates) signature.coordinates.pop_back();
    signature.grippers.push_back(signature.axes.back());
  }
  signature.force_sensor = robot.force_sensor;
  for (const motion::RobotSignal& signal : robot.signals) {
    signature.signals.push_back({signal.name, signal.output, signal.channel + 1});
  }
  for (const motion::Body& body : robot.collision.bodies) signature.bodies.push_back(body.name);
  for (const motion::Obstacle& obstacle : robot.collision.obstacles)
    if (!obstacle.of_program) signature.obstacles.push_back(obstacle.name);
  static_assert(lang::kMostVolts == motion::kAnalogRange);
  add_unnamed(signature, false, false, robot.inputs);
  add_unnamed(signature, true, false, robot.outputs);
  add_unnamed(signature, false, true, robot.analog_inputs);
  add_unnamed(signature, true, true, robot.analog_outputs);
  return signature;
}

}  // namespace rob::runtime
