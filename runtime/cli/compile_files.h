#pragma once

#include "runtime/cli/options.h"

namespace rob::runtime {

/// `rob compile FILE…`: reports the errors of the programs, or with --listing prints their code.
/// Throws as load_program() does.
ExitCode compile_files(const Options& options);

}  // namespace rob::runtime
