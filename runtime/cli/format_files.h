#pragma once

#include "runtime/cli/options.h"
#include "runtime/run/run_result.h"

namespace rob::runtime {

/// `rob fmt`: gives each file its canonical layout, or with --check names those that differ from
/// it. A file that `rob compile` refuses, and one that cannot be read or written, stays as it is;
/// the others are done all the same.
ExitCode format_files(const Options& options);

}  // namespace rob::runtime
