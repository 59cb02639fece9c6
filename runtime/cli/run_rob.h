#pragma once

#include "runtime/cli/commands.h"

namespace rob::runtime {

/// The program `rob`, from its command line to its exit code; `import`: as of carry_out().
int run_rob(int argc, char** argv, ImportCommand import);

}  // namespace rob::runtime
