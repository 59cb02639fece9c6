#include "runtime/cli/records.h"

#include "runtime/files/files.h"
#include "runtime/record/recorded_run.h"

namespace rob::runtime {

namespace {

RecordedOptions recorded(const Options& options) {
  RecordedOptions result;
  result.robot = options.robot;
  if (options.law) result.law = motion::law_name(*options.law);
  result.seed = options.seed;
  result.cell = options.cell;
  result.override_share = options.override_share;
  result.date = options.date.value_or(WallTime{});
  result.virtual_clock = options.fast;
  return result;
}

}  // namespace

std::optional<RunRecord> open_record(const Options& options, const LoadedProgram& program) {
  if (options.mcap.empty()) return std::nullopt;
  if (program.file == kStandardInput)
    throw UsageError("--mcap records a program that is in a file, not standard input");
  const bool own_file = options.robot.ends_with(".toml");
  return std::optional<RunRecord>(
      std::in_place, options.mcap, program.robot, program.file, used_names(program),
      files_of_run(program, recorded(options), own_file ? options.robot : "", options.signals));
}

}  // namespace rob::runtime
