#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "runtime/run/test_runner.h"

/// The report of `rob test` on the TESTs of one program (docs/cli.md).
namespace rob::runtime {

/// A line for each TEST, what failed below it, and a summary.
std::string test_text(const std::string& file, const std::vector<TestResult>& results);

nlohmann::ordered_json test_json(const std::string& file, const std::vector<TestResult>& results);

}  // namespace rob::runtime
