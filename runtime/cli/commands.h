#pragma once

#include "runtime/cli/options.h"

namespace rob::runtime {

/// Carries out one command line: results to stdout, messages for people to stderr.
/// Throws FileError, motion::RobotFileError and motion::DriverError.
ExitCode carry_out(const Options& options);

}  // namespace rob::runtime
