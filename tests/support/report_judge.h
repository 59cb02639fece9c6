#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/support/paul_model.h"
#include "tests/support/trace_file.h"
#include "tests/support/trace_judge.h"

namespace rob::test {

/// What `rob run --json` must say of a run on the virtual clock: the totals, each line's start,
/// durations, decision point and corner miss, where the axes stand at the end, what was printed.
/// Times are held to 1e-6 s, misses to 0.05 mm; a measured corner is held to what the trace says.
/// `output`: the lines that the program prints.
Findings judge_report(const nlohmann::json& report, const PaulModel& model, const TraceFile& trace,
                      const RunLimits& limits, const std::vector<std::string>& output);

}  // namespace rob::test
