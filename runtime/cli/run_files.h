#pragma once

#include "runtime/cli/options.h"

namespace rob::runtime {

/// `rob run FILE…`: runs the programs one after the other until one of them fails. The result is
/// the first that is not Done. Throws FileError, motion::RobotFileError and motion::DriverError.
ExitCode run_files(const Options& options);

/// Runs one program; nothing is printed but what is wrong. Throws as run_files().
ExitCode run_silently(const Options& options);

}  // namespace rob::runtime
