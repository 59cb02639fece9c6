#pragma once

#include "runtime/prompt/command.h"

/// The commands that write the program in memory.
namespace rob::runtime::command {

void record(Session& session, const Words& words);
void list(Session& session, const Words& words);
void edit(Session& session, const Words& words);
void insert(Session& session, const Words& words);
void erase(Session& session, const Words& words);
void undo(Session& session, const Words& words);
void redo(Session& session, const Words& words);
void begin_new(Session& session, const Words& words);
void variables(Session& session, const Words& words);

}  // namespace rob::runtime::command
