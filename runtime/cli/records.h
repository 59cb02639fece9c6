#pragma once

#include <optional>

#include "runtime/cli/options.h"
#include "runtime/record/run_record.h"
#include "runtime/run/load.h"

/// `rob run --mcap`.
namespace rob::runtime {

/// The record that the command line asks for, open, with the files of the program as they are
/// before it runs. Throws FileError.
std::optional<RunRecord> open_record(const Options& options, const LoadedProgram& program);

}  // namespace rob::runtime
