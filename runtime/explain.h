#pragma once

#include <string>

#include "runtime/program/run_result.h"

namespace rob::runtime {

/// What there is to say of a word of the language, a unit or a code; empty: nothing.
std::string explanation_of(const std::string& word);

/// `rob help WORD`: what a word of the language, a unit or a code means.
ExitCode explain(const std::string& word);

}  // namespace rob::runtime
