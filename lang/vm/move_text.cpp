#include "lang/vm/move_text.h"

#include "lang/values/number_text.h"
#include "lang/values/pose_math.h"
#include "lang/values/units.h"

namespace rob::lang {
namespace {

std::string pace_text(const MoveCommand& command) {
  switch (command.pace) {
    case MoveCommand::Pace::Unspecified:
      return "";
    case MoveCommand::Pace::ToolSpeed:
      return " at " + si_text(command.pace_value, kSpeed);
    case MoveCommand::Pace::AngularSpeed:
      return " at " + si_text(command.pace_value, kAngularSpeed);
    case MoveCommand::Pace::Share:
      return " at " + si_text(command.pace_value * 100, kNone) + "%";
  }
  return "";
}

std::string zone_text(const MoveCommand& command) {
  switch (command.zone) {
    case MoveCommand::Zone::Unspecified:
      return "";
    case MoveCommand::Zone::Length:
      return " zone " + si_text(command.zone_value, kLength);
    case MoveCommand::Zone::Time:
      return " zone " + si_text(command.zone_value, kTime);
    case MoveCommand::Zone::Share:
      return " zone " + si_text(command.zone_value * 100, kNone) + "%";
  }
  return "";
}

std::string zone_angle_text(const MoveCommand& command) {
  return command.zone_angle > 0 ? ' ' + si_text(command.zone_angle, kAngle) : "";
}

std::string bound_text(std::string_view word, MoveCommand::Bound bound, double value,
                       Dimension tool, Dimension rotary) {
  if (bound == MoveCommand::Bound::Unspecified) return "";
  if (bound == MoveCommand::Bound::Share)
    return std::string(word) + si_text(value * 100, kNone) + "%";
  return std::string(word) + si_text(value, bound == MoveCommand::Bound::Tool ? tool : rotary);
}

std::string profile_text(Profile profile) {
  if (profile == Profile::Unspecified) return "";
  std::string text(" profile ");
  for (const char c : kProfileWords[static_cast<std::size_t>(profile) - 1]) {
    text += static_cast<char>(c - 'A' + 'a');
  }
  return text;
}

std::string free_text(FreeTurn free) {
  if (free == FreeTurn::None) return "";
  return free == FreeTurn::C ? " free c" : " free spin";
}

/// In mm or deg, without the unit.
std::string plain(double value, Dimension dimension) {
  const std::string number = si_text(value, dimension);
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

std::string near_text(const RobotSignature& robot, const MoveCommand& command) {
  if (!command.near) return "";
  std::string text = " near";
  for (std::size_t i = 0; i < robot.axes.size(); ++i)
    text += plain((*command.near)[i], robot.axes[i].dimension);
  return text;
}

std::string vector_text(const Vector3& v) {
  return plain(v.x, kLength) + plain(v.y, kLength) + plain(v.z, kLength);
}

std::string place_text(const PoseValue& pose) {
  const FixedAngles angles = pose_math::to_fixed(pose.rotation);
  return vector_text(pose.position) + plain(angles.a, kAngle) + plain(angles.b, kAngle) +
         plain(angles.c, kAngle);
}

std::string pose_text(const MoveCommand& command) {
  const auto& t = command.target;
  const Vector3 place{t[0], t[1], t[2]};
  if (command.relative) return " pose" + vector_text(place);
  return " pose" + place_text({place, {t[3], t[4], t[5], t[6]}});
}

/// In mm/s and deg/s, without their units.
std::string rates_text(const RobotSignature& robot, const MoveCommand& command) {
  std::string text = command.jog == JogFrame::Joint   ? " joint"
                     : command.jog == JogFrame::World ? " world"
                                                      : " tool";
  const auto& rated = command.jog == JogFrame::Joint ? robot.axes : robot.coordinates;
  for (int i = 0; i < command.count; ++i) {
    const auto index = static_cast<std::size_t>(i);
    const Dimension dimension = rated[index].dimension;
    text += command.has(i) ? plain(command.target[index], dimension) : std::string(" -");
  }
  return text;
}

std::string target_text(const RobotSignature& robot, const MoveCommand& command) {
  const std::string by = command.relative ? " by" : "";
  switch (command.means) {
    case MoveCommand::Target::Coordinates:
      return by + components_text(elements_of(robot), command);
    case MoveCommand::Target::Axes:
      return " joints" + by + components_text(robot.axes, command);
    case MoveCommand::Target::Pose:
      break;
  }
  return by + pose_text(command);
}

}  // namespace

std::string move_text(const RobotSignature& robot, const MoveCommand& command) {
  std::string text;
  for (const char c : word_of(command.kind)) text += static_cast<char>(c - 'A' + 'a');
  if (command.kind == MotionKind::Spiral) {
    text += " from " + si_text(command.radius, kLength);
    text += " turns " + si_text(command.turns, kNone);
  } else if (command.kind == MotionKind::Jog) {
    text += rates_text(robot, command);
  } else {
    text += target_text(robot, command);
  }
  if (command.lasts > 0) text += " for " + si_text(command.lasts, kTime);
  text += pace_text(command);
  if (command.over > 0) text += " over " + si_text(command.over, kTime);
  text += bound_text(" accel ", command.accel, command.accel_value, kAcceleration,
                     kAngularAcceleration);
  text += bound_text(" jerk ", command.jerk, command.jerk_value, kJerk, kAngularJerk);
  text += zone_text(command) + zone_angle_text(command);
  if (command.fine) text += " fine";
  if (command.fine_within > 0) text += ' ' + si_text(command.fine_within, kLength);
  if (command.euler) text += " euler";
  text += free_text(command.free) + near_text(robot, command);
  return text + profile_text(command.profile);
}

std::string via_text(const RobotSignature& robot, const MoveCommand& point) {
  return "via" + target_text(robot, point);
}

namespace {

std::string shape_text(const ToolValue& tool) {
  std::string text;
  for (const CapsuleValue& capsule : tool.shape) {
    if (!(capsule.radius > 0)) continue;
    text += " capsule" + vector_text(capsule.from) + vector_text(capsule.to) + ' ' +
            si_text(capsule.radius, kLength);
  }
  return text;
}

std::string allowed_text(const Setting& setting) {
  std::string text;
  if (!setting.allowed) return text;
  for (const std::string& body : *setting.allowed) text += (text.empty() ? " allow " : ", ") + body;
  return text;
}

}  // namespace

std::string setting_text(const Setting& setting) {
  std::string text = "with";
  const ToolValue& tool = setting.tool;
  const std::string tip = place_text(tool.tip);
  if (tip == place_text({}) && tool.mass == 0) {
    text += " flange";
  } else {
    text += tip;
    if (tool.mass != 0) text += ' ' + si_text(tool.mass, kMass);
    if (const std::string cog = vector_text(tool.cog); cog != vector_text({})) text += " cog" + cog;
  }
  text += shape_text(tool) + " in";
  if (setting.in_tool) return text + " tool" + allowed_text(setting);
  const std::string frame = place_text(setting.frame);
  return text + (frame == place_text({}) ? std::string(" world") : frame) + allowed_text(setting);
}

std::string load_text(const LoadCommand& load) {
  std::string text = "load " + si_text(load.mass, kMass);
  if (const std::string cog = vector_text(load.cog); cog != vector_text({})) text += " cog" + cog;
  return text;
}

std::string press_text(const PressCommand& command) {
  std::string text = "press ";
  text += "xyz"[command.axis];
  text += ' ' + si_text(command.force, kForce);
  if (command.limit > 0) text += " limit " + si_text(command.limit, kSpeed);
  return text;
}

}  // namespace rob::lang
