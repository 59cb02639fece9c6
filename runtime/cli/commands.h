#pragma once

#include "runtime/cli/options.h"

namespace rob::runtime {

/// `rob robot import`; see import_files().
using ImportCommand = ExitCode (*)(const ImportRequest& request);

/// Carries out one command line: results to stdout, messages for people to stderr. `import`: null
/// where this program reads no URDFs. Throws FileError, motion::RobotFileError and
/// motion::DriverError.
ExitCode carry_out(const Options& options, ImportCommand import);

}  // namespace rob::runtime
