#pragma once

#include "runtime/cli/options.h"

namespace rob::runtime {

/// `rob test FILE…`: runs the TESTs of all files and reports them. ProgramError if one failed or a
/// file does not compile.
ExitCode test_files(const Options& options);

}  // namespace rob::runtime
