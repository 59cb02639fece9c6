#pragma once

#include "runtime/prompt/command.h"

/// The commands that ask where the robot is, and how it moves.
namespace rob::runtime::command {

void where(Session& session, const Words& words);
void signals(Session& session, const Words& words);
void override_speed(Session& session, const Words& words);
void hold(Session& session, const Words& words);
void resume(Session& session, const Words& words);
void stop(Session& session, const Words& words);
void reset(Session& session, const Words& words);
void guide(Session& session, const Words& words);
void home(Session& session, const Words& words);
void robot(Session& session, const Words& words);
void law(Session& session, const Words& words);
void jog(Session& session, const Words& words);

}  // namespace rob::runtime::command
