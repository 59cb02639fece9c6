#pragma once

#include "runtime/options.h"

namespace rob::runtime {

/// `rob` without a command: statements as they are typed, or from a pipe.
ExitCode run_prompt(const Options& options);

}  // namespace rob::runtime
