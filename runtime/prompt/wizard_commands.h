#pragma once

#include "runtime/prompt/command.h"

/// The commands that make a FRAME or a TOOL of positions of the robot.
namespace rob::runtime::command {

void frame(Session& session, const Words& words);
void tool(Session& session, const Words& words);
/// There are positions enough: the declaration is written.
void done(Session& session, const Words& words);
/// Enter, while a wizard asks: the robot's position is the next of it.
void take_position(Session& session);
/// The positions are forgotten; false where no wizard asks.
bool leave_wizard(Session& session);

}  // namespace rob::runtime::command
