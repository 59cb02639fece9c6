#pragma once

#include "runtime/prompt/command.h"

/// The commands that teach and keep points.
namespace rob::runtime::command {

void teach(Session& session, const Words& words);
void points(Session& session, const Words& words);
void rename(Session& session, const Words& words);
void forget(Session& session, const Words& words);

}  // namespace rob::runtime::command
