#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "runtime/program/run_result.h"

namespace rob::runtime {

/// The documents of `rob run --json` and `rob check --json` (docs/cli.md). Times in s, rounded to
/// 1 ns; places in mm, rounded to 1 nm; angles in deg.
nlohmann::ordered_json run_json(const RunResult& result);
nlohmann::ordered_json check_json(const RunResult& result);

/// As it is printed: UTF-8, whatever a program PRINTs, and nothing that a terminal would act on.
std::string json_text(const nlohmann::ordered_json& document);

/// An error, or null.
nlohmann::ordered_json problem_json(const std::optional<Problem>& problem);

}  // namespace rob::runtime
