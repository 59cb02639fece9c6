#include "tests/support/report_judge.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "tests/support/gantry.h"
#include "tests/support/published_program.h"

using namespace rob::test;
using nlohmann::json;

namespace {

/// The report of the published program; its figures are those that S1 and the law give by hand.
json faultless_report() {
  const auto line = [](int number, double starts, double planned, json decides, json miss) {
    const json corner = miss.is_null() ? json() : json{{"planned", miss}, {"measured", miss}};
    return json{{"line", number},        {"starts_s", starts},   {"planned_s", planned},
                {"measured_s", planned}, {"decides_s", decides}, {"corner_miss_mm", corner}};
  };
  return {{"status", "done"},
          {"robot", "gantry"},
          {"law", "paul"},
          {"clock", "virtual"},
          {"planned_s", 19.1},
          {"measured_s", 19.1},
          {"cycles", 1910},
          {"late_cycles", 0},
          {"lines",
           {line(1, 0, 2.75, 2.75, 4.0), line(2, 2.75, 5.0, 7.75, 9.62),
            line(3, 7.75, 4.3, 12.05, 10.31), line(4, 12.05, 4.3, 16.35, 0.0),
            line(5, 16.35, 2.75, nullptr, nullptr)}},
          {"final", {{"joints", {40.0, 40.0, 0.0}}, {"pose", {{"x", 40.0}, {"y", 40.0}}}}},
          {"output", json::array()},
          {"error", nullptr}};
}

Findings judged(const json& report) {
  return judge_report(report, published_program(), published_trace(), gantry_limits(), {});
}

}  // namespace

TEST_CASE("a faultless report of the published program is found faultless") {
  for (const std::string& finding : judged(faultless_report())) FAIL_CHECK(finding);
}

TEST_CASE("every wrong entry of a report is found") {
  struct Spoiled {
    const char* place;
    json value;
  };
  const std::vector<Spoiled> spoiled = {
      {"/status", "fault"},
      {"/planned_s", 19.101},
      {"/measured_s", 19.11},
      {"/cycles", 1911},
      {"/late_cycles", 1},
      {"/output", {"unasked"}},
      {"/error", {{"code", "E1"}}},
      {"/lines/1/starts_s", 2.76},
      {"/lines/1/planned_s", 5.01},
      {"/lines/1/measured_s", 5.01},
      {"/lines/1/decides_s", 7.74},
      {"/lines/1/corner_miss_mm/planned", 9.7},
      {"/lines/2/corner_miss_mm/measured", 10.2},
      {"/lines/4/decides_s", 19.1},
      {"/lines/4/line", 6},
      {"/final/joints/0", 41},
      {"/final/pose/y", 0},
  };
  for (const Spoiled& entry : spoiled) {
    json report = faultless_report();
    report[json::json_pointer(entry.place)] = entry.value;
    CHECK_MESSAGE(!judged(report).empty(), entry.place);
  }
}

TEST_CASE("every missing entry of a report is found") {
  for (const char* key : {"status", "robot", "law", "clock", "planned_s", "measured_s", "cycles",
                          "late_cycles", "lines", "final", "output"}) {
    json report = faultless_report();
    report.erase(key);
    CHECK_MESSAGE(!judged(report).empty(), key);
  }
  json report = faultless_report();
  report["lines"].erase(2);
  CHECK_FALSE(judged(report).empty());
}

TEST_CASE("a report that is no report is found") {
  CHECK_FALSE(judged(json::array()).empty());
  CHECK_FALSE(judged(json::object()).empty());
}
