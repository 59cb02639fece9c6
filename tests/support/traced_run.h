#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/support/process.h"
#include "tests/support/trace_file.h"

namespace rob::test {

/// What a run of `rob` on the virtual clock left behind.
struct TracedRun {
  ProcessResult process;
  nlohmann::json report;  ///< null where it printed none
  TraceFile trace;        ///< empty where it wrote none

  bool done() const { return process.exit_code == 0; }
  /// Its own words on what went wrong.
  std::string trouble() const;
};

/// Runs a program text on a robot (a name or a file): `rob run --fast --json --trace`, with what
/// else is asked for. Throws TraceError for a trace that is none.
TracedRun run_traced(const std::string& rob, const std::string& program, const std::string& robot,
                     const std::vector<std::string>& more = {});

}  // namespace rob::test
