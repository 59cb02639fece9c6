#pragma once

#include "runtime/cli/options.h"

namespace rob::runtime {

/// `rob run --replay`: repeats the run of a record on the virtual clock, in a folder of its own,
/// and compares every reference and measurement. ProgramError if they differ.
ExitCode replay_record(const Options& options);

}  // namespace rob::runtime
