#pragma once

#include <nlohmann/json.hpp>

#include "runtime/program/run_result.h"

namespace rob::runtime {

/// The documents of `rob run --json` and `rob check --json` (docs/cli.md). Times in s, rounded to
/// 1 ns; places in mm, rounded to 1 nm; angles in deg.
nlohmann::ordered_json run_json(const RunResult& result);
nlohmann::ordered_json check_json(const RunResult& result);

/// An error, or null.
nlohmann::ordered_json problem_json(const std::optional<Problem>& problem);

}  // namespace rob::runtime
