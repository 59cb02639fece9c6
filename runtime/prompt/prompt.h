#pragma once

#include "runtime/prompt/session.h"
#include "runtime/run/run_result.h"

namespace rob::runtime {

/// `rob` without a command: statements as they are typed, or from a pipe. Throws as Session does.
ExitCode run_prompt(SessionOptions options);

}  // namespace rob::runtime
