#pragma once

#include <string>
#include <string_view>

#include "lang/code/chunk.h"
#include "lang/compile/compile.h"
#include "lang/machine/machine.h"
#include "lang/machine/robot_signature.h"
#include "lang/text/diagnostic.h"
#include "lang/vm/vm.h"

/// The language for a program that embeds it: compile a text for a robot, and run it against a
/// Machine of one's own. docs/embedding.md has a complete example.
///
///     rob::lang::RobotSignature robot{"table", {{"x", rob::lang::kLength}}, {{"x",
///     rob::lang::kLength}}}; auto program = rob::lang::compile(source, robot); std::cerr <<
///     rob::lang::diagnose(program.diagnostics, "program.rob", source); if (!program.chunk) return
///     1; rob::lang::Vm vm(*program.chunk, machine); while (vm.run(1000) ==
///     rob::lang::Vm::State::Running) {}
///
/// Lengths are m, angles rad, times s. Nothing here starts a thread, opens a file or looks at a
/// clock.
namespace rob::lang {

/// All findings as a person reads them, and as `rob check` prints them: for each "file:line:col:
/// error[E101]: …", the source line with a caret under the place, and the help. Empty if there are
/// none. `file` is only shown; `source` is the text that was compiled.
std::string diagnose(const Diagnostics& diagnostics, std::string_view file,
                     std::string_view source);

}  // namespace rob::lang
