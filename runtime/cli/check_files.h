#pragma once

#include "runtime/cli/options.h"

namespace rob::runtime {

/// `rob check FILE…`: compiles the programs and follows them without moving anything. ProgramError
/// if one of them has errors. Throws as run_files() does.
ExitCode check_files(const Options& options);

}  // namespace rob::runtime
