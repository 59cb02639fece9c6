#pragma once

#include "runtime/prompt/session.h"

namespace rob::runtime {

/// `:jog`: turns the terminal on standard input and output into a pendant, until it is left, the
/// terminal is gone or `session` is over. The terminal is then as it was; and so after a crash.
void run_pendant(Session& session);

}  // namespace rob::runtime
