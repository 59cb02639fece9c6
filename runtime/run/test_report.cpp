#include "runtime/run/test_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "lang/text/visible.h"
#include "runtime/run/json_report.h"
#include "runtime/run/text_report.h"

namespace rob::runtime {

using lang::on_one_line;
using Json = nlohmann::ordered_json;

namespace {

std::size_t failed_count(const std::vector<TestResult>& results) {
  return static_cast<std::size_t>(
      std::ranges::count_if(results, [](const TestResult& result) { return !result.passed(); }));
}

std::string details(const std::string& file, const TestResult& result) {
  std::string text;
  for (const FailedExpect& failure : result.failures) {
    text += fmt::format("        {}:{}: EXPECT {}\n", on_one_line(file), failure.line,
                        on_one_line(failure.text));
  }
  if (result.failures_left_out > 0) {
    text += fmt::format("        and {} more\n", result.failures_left_out);
  }
  if (result.error) {
    const Problem& error = *result.error;
    text += fmt::format("        {}:{}: error[{}]: {}\n", on_one_line(error.file), error.place.line,
                        error.code, on_one_line(error.message));
    if (!error.help.empty()) text += fmt::format("        help: {}\n", on_one_line(error.help));
    std::istringstream calls(calls_text(error));
    for (std::string line; std::getline(calls, line);) text += fmt::format("      {}\n", line);
  }
  for (const std::string& line : result.output)
    text += fmt::format("        printed: {}\n", on_one_line(line));
  return text;
}

}  // namespace

std::string test_text(const std::string& file, const std::vector<TestResult>& results) {
  if (results.empty()) return fmt::format("{}: no TEST\n", on_one_line(file));
  std::string text;
  for (const TestResult& result : results) {
    text += fmt::format("{:<6}  {} ({:.2f} s)\n", result.passed() ? "ok" : "FAILED",
                        on_one_line(result.name), result.time);
    if (!result.passed()) text += details(file, result);
  }
  const std::size_t failed = failed_count(results);
  return text +
         fmt::format("{}: {} ok, {} failed\n", on_one_line(file), results.size() - failed, failed);
}

Json test_json(const std::string& file, const std::vector<TestResult>& results) {
  Json tests = Json::array();
  for (const TestResult& result : results) {
    Json failures = Json::array();
    for (const FailedExpect& failure : result.failures) {
      failures.push_back({{"line", failure.line}, {"message", failure.text}});
    }
    tests.push_back({{"name", result.name},
                     {"line", result.place.line},
                     {"status", result.passed() ? "ok" : "failed"},
                     {"measured_s", std::round(result.time * 1e9) * 1e-9},
                     {"failures", failures},
                     {"output", result.output},
                     {"error", problem_json(result.error)}});
  }
  const std::size_t failed = failed_count(results);
  return {{"status", failed == 0 ? "done" : "failed"},
          {"file", file},
          {"ok", results.size() - failed},
          {"failed", failed},
          {"tests", tests}};
}

}  // namespace rob::runtime
