#include <string>

#include "lang/number_text.h"
#include "lang/pose_math.h"
#include "lang/printing_machine.h"
#include "lang/units.h"

namespace rob::lang {
namespace {

std::string pace_text(const MoveCommand& command) {
  switch (command.pace) {
    case MoveCommand::Pace::Unspecified:
      return "";
    case MoveCommand::Pace::ToolSpeed:
      return " at " + number_text(command.pace_value, kSpeed);
    case MoveCommand::Pace::AngularSpeed:
      return " at " + number_text(command.pace_value, kAngularSpeed);
    case MoveCommand::Pace::Share:
      return " at " + number_text(command.pace_value * 100, kNone) + "%";
  }
  return "";
}

std::string zone_text(const MoveCommand& command) {
  switch (command.zone) {
    case MoveCommand::Zone::Unspecified:
      return "";
    case MoveCommand::Zone::Length:
      return " zone " + number_text(command.zone_value, kLength);
    case MoveCommand::Zone::Time:
      return " zone " + number_text(command.zone_value, kTime);
    case MoveCommand::Zone::Share:
      return " zone " + number_text(command.zone_value * 100, kNone) + "%";
  }
  return "";
}

std::string bound_text(std::string_view word, MoveCommand::Bound bound, double value,
                       Dimension tool, Dimension rotary) {
  if (bound == MoveCommand::Bound::Unspecified) return "";
  return std::string(word) + number_text(value, bound == MoveCommand::Bound::Tool ? tool : rotary);
}

std::string profile_text(Profile profile) {
  if (profile == Profile::Unspecified) return "";
  std::string text(" profile ");
  for (const char c : kProfileWords[static_cast<std::size_t>(profile) - 1]) {
    text += static_cast<char>(c - 'A' + 'a');
  }
  return text;
}

/// In mm or deg, without the unit.
std::string plain(double value, Dimension dimension) {
  const std::string number = number_text(value, dimension);
  return ' ' + number.substr(0, number.size() - unit_text(dimension).size());
}

/// The components in mm and deg, without their units.
std::string components_text(const std::vector<RobotSignature::Coordinate>& components,
                            const MoveCommand& command) {
  std::string text;
  for (int i = 0; i < command.count; ++i) {
    if (!command.has(i)) {
      text += " -";
      continue;
    }
    const auto index = static_cast<std::size_t>(i);
    text += plain(command.target[index], components[index].dimension);
  }
  return text;
}

std::string pose_text(const MoveCommand& command) {
  const auto& t = command.target;
  std::string text = " pose";
  for (std::size_t i = 0; i < 3; ++i) text += plain(t[i], kLength);
  if (command.relative) return text;
  const FixedAngles angles = pose_math::to_fixed({t[3], t[4], t[5], t[6]});
  return text + plain(angles.a, kAngle) + plain(angles.b, kAngle) + plain(angles.c, kAngle);
}

std::string target_text(const RobotSignature& robot, const MoveCommand& command) {
  const std::string by = command.relative ? " by" : "";
  switch (command.means) {
    case MoveCommand::Target::Coordinates:
      return by + components_text(robot.coordinates, command);
    case MoveCommand::Target::Axes:
      return " joints" + by + components_text(robot.axes, command);
    case MoveCommand::Target::Pose:
      break;
  }
  return by + pose_text(command);
}

}  // namespace

std::string move_text(const RobotSignature& robot, const MoveCommand& command) {
  std::string text = command.kind == MotionKind::Line ? "movel" : "move";
  text += target_text(robot, command);
  text += pace_text(command);
  if (command.over > 0) text += " over " + number_text(command.over, kTime);
  text += bound_text(" accel ", command.accel, command.accel_value, kAcceleration,
                     kAngularAcceleration);
  text += bound_text(" jerk ", command.jerk, command.jerk_value, kJerk, kAngularJerk);
  text += zone_text(command);
  if (command.fine) text += " fine";
  return text + profile_text(command.profile);
}

}  // namespace rob::lang
