#pragma once

#include "runtime/cli/options.h"

namespace rob::runtime {

/// `rob vars FILE`: the values that the program's PERSIST variables have kept; --reset takes one
/// out, so that the next run begins with the program's own.
ExitCode show_vars(const Options& options);

}  // namespace rob::runtime
