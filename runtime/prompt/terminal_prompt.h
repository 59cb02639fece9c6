#pragma once

#include <atomic>

#include "runtime/prompt/session.h"

namespace rob::runtime {

/// A person at the terminal that is standard input and output. `options.requests` is not needed.
ExitCode talk(SessionOptions options);

}  // namespace rob::runtime
