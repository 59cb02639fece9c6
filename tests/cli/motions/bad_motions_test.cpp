// Motions under the look-ahead law that ask for what cannot be, or for next to nothing.
#include <doctest/doctest.h>

#include <cmath>

#include "tests/support/rob_command.h"
#include "tests/support/trace_file.h"

using nlohmann::json;
using rob::test::contains;
using rob::test::ProcessResult;
using rob::test::RobCommand;

namespace {

const std::string kXy = std::string(ROB_SOURCE_DIR) + "/tests/bench/xy.toml";
const std::string kAhead = "LAW LOOKAHEAD\n";

/// Refused by check and by run, before anything has moved.
void refuses_motion(const std::string& text, const std::string& message) {
  const RobCommand rob(text);
  for (const auto& command : {std::vector<std::string>{"check", "--json"},
                              std::vector<std::string>{"run", "--fast", "--json"}}) {
    const ProcessResult result = rob(command[0], {command.begin() + 1, command.end()});
    CAPTURE(text);
    CAPTURE(result.err);
    CHECK((result.exit_code == 65 || result.exit_code == 70));
    CHECK(contains(result.err, message));
    CHECK(json::parse(result.out)["lines"].empty());
  }
}

/// Ends well under check and run, which agree; the report of the run.
json runs(const std::string& text, const std::vector<std::string>& more = {}) {
  const RobCommand rob(text);
  std::vector<std::string> options = more;
  options.emplace_back("--json");
  const ProcessResult checked = rob("check", options);
  options.emplace_back("--fast");
  const ProcessResult result = rob("run", options);
  CAPTURE(text);
  CAPTURE(result.err);
  CHECK(checked.exit_code == 0);
  REQUIRE(result.exit_code == 0);
  json report = json::parse(result.out);
  CHECK(json::parse(checked.out)["planned_s"].get<double>() ==
        doctest::Approx(report["measured_s"].get<double>()).epsilon(1e-9));
  return report;
}

void ends_at(const json& report, const std::vector<double>& joints) {
  for (std::size_t i = 0; i < joints.size(); ++i)
    CHECK(report["final"]["joints"][i].get<double>() == doctest::Approx(joints[i]).epsilon(1e-9));
}

}  // namespace

TEST_CASE("a target on the limits is reached, the next one beyond is refused") {
  ends_at(runs(kAhead + "MOVE(400, 300, 180)\nMOVE(0, 0, -180)\n"), {0, 0, -180});
  refuses_motion(kAhead + "MOVE(10, 0, 0)\nMOVE(400.0001, 0, 0)\n", "400.0001 mm is beyond 400 mm");
  refuses_motion(kAhead + "MOVE(10, 0, 0)\nMOVE(0, -0.0001, 0)\n", "-0.0001 mm is below 0 mm");
  refuses_motion(kAhead + "MOVE(10, 0, 0)\nMOVE(0, 0, 180.001)\n", "180.001 deg is beyond 180 deg");
}

TEST_CASE("a joint target of an arm on its limits is reached, the next one beyond is refused") {
  const std::string arm = "ROBOT \"irb120\"\n" + kAhead;
  ends_at(runs(arm + "MOVE JOINTS(165deg, 0deg, 0deg, 0deg, 90deg, 0deg)\n"),
          {165, 0, 0, 0, 90, 0});
  refuses_motion(arm + "MOVE JOINTS(165.001deg, 0deg, 0deg, 0deg, 90deg, 0deg)\n",
                 "165.001 deg is beyond 165 deg");
}

TEST_CASE("a path event beyond its motion is refused, the ends of the way are not") {
  const std::string head = kAhead + "MOVE(100, 0, 0) DO\n";
  const std::string tail = " : DOUT[1] = ON\nENDMOVE\n";
  for (const char* place : {"AFTER 100.001mm", "BEFORE 100.001mm"})
    refuses_motion(head + place + tail, "is beyond this motion, whose way is 100 mm long");
  refuses_motion(head + "AFTER 1mm LEAD 0.6s" + tail, "LEAD is 0s to 0.5s");
  refuses_motion(head + "AFTER -1mm" + tail, "from 0mm on");
  refuses_motion(kAhead + "MOVE(0, 0, 0) DO\nAFTER 0mm" + tail, "no way to go in this motion");
  const json report = runs(head + "AFTER 0mm : DOUT[1] = ON\nBEFORE 0mm : DOUT[2] = ON\nENDMOVE\n");
  REQUIRE(report["signals"].size() == 2);
  CHECK(report["signals"][0]["t"].get<double>() == 0);
  CHECK(report["signals"][1]["t"].get<double>() ==
        doctest::Approx(report["measured_s"].get<double>()).epsilon(1e-6));
}

TEST_CASE("points given twice, ways of nothing and full turns back are gone exactly to their end") {
  ends_at(runs(kAhead + "MOVE(0, 0, 0)\nMOVE(0, 0, 0)\n"), {0, 0, 0});
  ends_at(runs(kAhead + "MOVE(100, 0, 0)\nMOVE(100, 0, 0)\nMOVE(100, 0, 0)\nMOVE(0, 50, 0)\n"
                        "MOVE(0, 50, 0)\n"),
          {0, 50, 0});
  ends_at(runs(kAhead + "MOVE(50, 0, 0)\nMOVE(50.0000001, 0, 0)\nMOVE(50, 1e-9, 0)\n"
                        "MOVE(100, 0, 0)\n"),
          {100, 0, 0});
  const json back = runs(kAhead + "MOVE(100, 0, 0) FINE\nMOVE(0, 0, 0)\nMOVE(100, 0, 0)\n");
  ends_at(back, {100, 0, 0});
  // There is no way around a turn of 180 deg: three lines of d/v + v/a and the time of the mean.
  CHECK(back["measured_s"].get<double>() <= 3 * (5 + 0.2 + 0.2));
  ends_at(runs(kAhead + "MOVE(0, 0, 180)\nMOVE(0, 0, -180)\nMOVE(0, 0, 180)\n"), {0, 0, 180});
}

TEST_CASE("a ZONE that the motions are too short for is cut to what the warning tells") {
  const auto program = [](const std::string& jerk) {
    return kAhead + "MOVE(-50, 0, 0) FINE\nMOVE(50, 0, 0) AT 300mm/s ZONE 100mm" + jerk +
           "\nMOVE(50, 30, 0) AT 300mm/s ZONE 100mm" + jerk + "\nMOVE(0, 30, 0) AT 300mm/s" + jerk +
           "\n";
  };
  // The corner takes 30 mm of both legs at most: it misses by 30·√2/4 mm.
  const double left = 30 * std::sqrt(2.0) / 4;
  const auto miss = [&](const std::string& jerk) {
    const RobCommand rob(program(jerk));
    const ProcessResult result = rob("run", {"--fast", "--json", "--robot", kXy});
    const bool cut = !jerk.empty();
    CHECK(contains(result.err, "warning[W644]") == cut);
    CHECK(contains(result.err, "leave 10.606602 mm at most, and what a bound on jerk adds") == cut);
    return json::parse(result.out)["lines"][1]["corner_miss_mm"]["measured"].get<double>();
  };
  // Without a bound on jerk the legs become one curve, which can use more of the ZONE.
  CHECK(miss("") > left);
  CHECK(miss("") <= 100);
  // A mean of 2·1000/5000 s, by which an axis is up to 1000·0.4²/24 mm off.
  CHECK(miss(" JERK 5000mm/s^3") <= left + std::sqrt(2.0) * 1000 * 0.16 / 24);
}
