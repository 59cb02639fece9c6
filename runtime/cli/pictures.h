#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "runtime/cli/options.h"
#include "runtime/pictures/run_curves.h"
#include "runtime/pictures/tool_way.h"
#include "runtime/run/load.h"
#include "runtime/run/run_result.h"

namespace rob::runtime {

/// The pictures that a command line asks for, of one program: --report, --svg, --plot.
class Pictures {
 public:
  /// Throws UsageError if a file would overwrite what the command reads or writes, FileError if one
  /// cannot be written: before anything moves.
  Pictures(const Options& options, const std::vector<LoadedProgram>& programs);

  /// The run or its foretelling calls this for each reference period; empty if nothing is drawn.
  std::function<void(const Snapshot&)> listener(const motion::RobotModel& robot);
  /// The same for the targets of motions; after listener().
  std::function<void(const motion::JointVector&, int)> target_listener();
  /// The program has run, or was foretold: saves and prints the pictures. Throws FileError.
  void save(const RunResult& result, const LoadedProgram& program) const;

 private:
  void save_report(const RunResult& result, const LoadedProgram& program) const;

  const Options& options_;
  std::optional<RunCurves> curves_;
  std::optional<ToolWay> way_;
};

}  // namespace rob::runtime
