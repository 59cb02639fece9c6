#pragma once

#include <span>
#include <string>
#include <string_view>

#include "runtime/prompt/command.h"
#include "runtime/prompt/session.h"

namespace rob::runtime {

/// All colon commands, in the order of help.
std::span<const Command> commands();

/// A line for the workshop; it acts at once, also while a block is open.
bool is_command(std::string_view line);

/// What was typed: a statement, a block, a colon command, or an answer; a line at least. `last`: no
/// more lines will come. The session reports what goes wrong.
Session::Taken enter(Session& session, const std::string& text, bool last = false);

}  // namespace rob::runtime
