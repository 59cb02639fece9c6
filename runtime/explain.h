#pragma once

#include <string>

#include "runtime/program/run_result.h"

namespace rob::runtime {

/// `rob help WORD`: what a word of the language, a unit or a code means.
ExitCode explain(const std::string& word);

}  // namespace rob::runtime
