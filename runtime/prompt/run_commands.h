#pragma once

#include "runtime/prompt/command.h"

/// The commands that run and foretell the program in memory.
namespace rob::runtime::command {

void run(Session& session, const Words& words);
void step(Session& session, const Words& words);
void back(Session& session, const Words& words);
void breakpoints(Session& session, const Words& words);
void check(Session& session, const Words& words);
void time(Session& session, const Words& words);

}  // namespace rob::runtime::command
