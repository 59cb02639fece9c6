#pragma once

#include <string>

#include "lang/machine/move_command.h"
#include "lang/machine/robot_signature.h"
#include "lang/values/setting.h"

/// Motions, and what lies around them, as PrintingMachine writes them.
namespace rob::lang {

/// "move 40 40 0 at 50%".
std::string move_text(const RobotSignature& robot, const MoveCommand& command);
/// "via 40 40 0".
std::string via_text(const RobotSignature& robot, const MoveCommand& point);
/// "with flange in world".
std::string setting_text(const Setting& setting);
/// "press z 10N".
std::string press_text(const PressCommand& command);
/// "load 2kg".
std::string load_text(const LoadCommand& load);

}  // namespace rob::lang
