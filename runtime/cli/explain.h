#pragma once

#include <string>

#include "runtime/run/run_result.h"

namespace rob::runtime {

/// `rob help WORD`: the meaning of a word of the language, a unit or a code.
ExitCode explain(const std::string& word);

}  // namespace rob::runtime
