#pragma once

#include "runtime/prompt/command.h"

/// The commands that keep the program in memory in files.
namespace rob::runtime::command {

void save(Session& session, const Words& words);
void save_over(Session& session, const Words& words);
void load(Session& session, const Words& words);
void archive(Session& session, const Words& words);
void compare(Session& session, const Words& words);
void restore(Session& session, const Words& words);

}  // namespace rob::runtime::command
