// HOLD, GO, STOP and OVERRIDE of a signal script: what a person does to a run, done again.
#include <doctest/doctest.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "tests/support/rob_command.h"
#include "tests/support/trace_file.h"

using nlohmann::json;
using rob::test::contains;
using rob::test::ProcessResult;
using rob::test::RobCommand;
using rob::test::run_process;
using rob::test::TraceRow;

namespace {

constexpr int kHeldState = 2;  // docs/cli.md, trace

/// A program and its signal script.
struct Scripted {
  Scripted(const std::string& program, const std::string& script) : rob(program) {
    std::ofstream(rob.file("cell.sig")) << script;
  }
  ProcessResult run(std::vector<std::string> more = {}, const std::string& command = "run") const {
    if (command == "run") more.emplace_back("--fast");
    more.insert(more.end(), {"--signals", rob.file("cell.sig")});
    return rob(command, more);
  }
  json report(std::vector<std::string> more = {}, const std::string& command = "run") const {
    more.emplace_back("--json");
    return json::parse(run(more, command).out);
  }
  std::string trace(std::vector<std::string> more = {}) const {
    more.insert(more.end(), {"--trace", rob.file("trace.csv")});
    run(more);
    return rob::test::read_whole_file(rob.file("trace.csv"));
  }

  RobCommand rob;
};

/// "3.00 hold", a line for each.
std::string interventions(const json& report) {
  std::ostringstream text;
  for (const json& event : report["events"])
    text << event["t"].get<double>() << " " << event["kind"].get<std::string>() << "\n";
  return text.str();
}

// One motion of 20 s and one of 5 s, on a straight line, so that there is one corner to be held in.
const std::string kTwoLegs = "MOVE(400, 0, 0)\nMOVE(300, 0, 0)\n";

}  // namespace

TEST_CASE("a HOLD stands still until the GO, and the run is later by just that long") {
  // Slowing down and speeding up are mirror images: of the path's time 6 s are lost.
  for (const std::string law : {"paul", "lookahead"}) {
    CAPTURE(law);
    const Scripted free(kTwoLegs, "");
    const Scripted held(kTwoLegs, "at 7s HOLD = ON\nat 13s GO = ON\n");
    const json before = free.report({"--law", law});
    const json after = held.report({"--law", law});
    CHECK(after["status"] == "done");
    CHECK(after["final"]["joints"] == json{300, 0, 0});
    // A ramp of the time scale has whole periods of 10 ms.
    const double later = after["measured_s"].get<double>() - before["measured_s"].get<double>();
    CHECK(later > 6 - 1e-6);
    CHECK(later < 6.01 + 1e-6);
    CHECK(interventions(after) == "7 hold\n13 go\n");
    int stands = 0;
    const auto rows = rob::test::parse_trace(held.trace({"--law", law})).rows;
    for (const TraceRow& row : rows) {
      if (row.t > 9 && row.t < 13) {
        CHECK(row.state == kHeldState);
        CHECK(row.qd[0] == 0);
        ++stands;
      }
      if (row.t < 7) CHECK(row.state != kHeldState);
    }
    CHECK(stands == 399);
  }
}

TEST_CASE("a program and its script give the same trace, bit for bit") {
  const std::string script =
      "at 2s OVERRIDE = 40%\nwhen DOUT[1] == ON after 0.5s : HOLD = ON\nat 30s GO = ON\n"
      "at 31s OVERRIDE = 100%\nat 40s STOP = ON\n";
  const std::string program = "MOVE(60, 0, 0)\nDOUT[1] = ON\nMOVE(60, 60, 0)\nMOVE(0, 0, 90)\n";
  for (const std::string law : {"paul", "lookahead"}) {
    CAPTURE(law);
    const std::string first = Scripted(program, script).trace({"--law", law});
    CHECK(first.size() > 10'000);
    CHECK(first == Scripted(program, script).trace({"--law", law}));
  }
}

TEST_CASE("an OVERRIDE scales the run from its cycle on") {
  // 20 s at 20 mm/s after the first half; what the change itself takes is far below 0.5 s.
  const json before = Scripted(kTwoLegs, "").report();
  const json after = Scripted(kTwoLegs, "at 10s OVERRIDE = 50%\n").report();
  const double free = before["measured_s"];
  CHECK(after["measured_s"].get<double>() < 10 + 2 * (free - 10) + 1e-6);
  CHECK(after["measured_s"].get<double>() > 10 + 2 * (free - 10) - 0.5);
  CHECK(interventions(after) == "10 override\n");
  CHECK(contains(after["events"][0]["text"], "50%"));
  // What is planned counts with it, as with an OVERRIDE of the program.
  CHECK(after["planned_s"].get<double>() ==
        doctest::Approx(after["measured_s"].get<double>()).epsilon(0.02));
}

TEST_CASE("an OVERRIDE of the program takes the place of the script's") {
  const json report =
      Scripted("MOVE(200, 0, 0)\nSTOP\nOVERRIDE 100%\nMOVE(0, 0, 0)\n", "at 0s OVERRIDE = 50%\n")
          .report();
  const auto measured = [&](int at) { return report["lines"][at]["measured_s"].get<double>(); };
  CHECK(measured(0) > 1.9 * 10);        // 200 mm at 10 mm/s
  CHECK(measured(2) < 1.1 * (10 + 3));  // at 20 mm/s
}

TEST_CASE("a STOP ends the run on its path, as Ctrl-C does") {
  const Scripted stopped(
      "SIGNAL torch = DOUT[1] SAFE OFF\ntorch = ON\nMOVE(400, 0, 0)\nPRINT \"never\"\n",
      "when torch == ON after 5s : STOP = ON\n");
  const ProcessResult result = stopped.run({"--json"});
  CHECK(result.exit_code == 130);
  const json report = json::parse(result.out);
  CHECK(report["status"] == "interrupted");
  CHECK(report["error"] == nullptr);
  CHECK(report["output"].empty());
  CHECK(report["dropped_effects"] == 1);
  CHECK(report["lines"][0]["ended"] == "brake");
  // The torch is seen ON by the cycle at 0.01 s.
  CHECK(interventions(report) == "5.01 stop\n5.01 safe\n");
  CHECK(report["signals"].back()["value"] == false);
  // At 20 mm/s after a ramp of 2.75 s; it brakes in 0.37 s at the soonest (docs/language.md).
  const double x = report["final"]["joints"][0];
  CHECK(x > 20 * (5 - 2.75));
  CHECK(x < 20 * (5 + 2));
  CHECK(report["measured_s"].get<double>() > 5.3);
  CHECK(report["measured_s"].get<double>() < 7);
}

TEST_CASE("a GO that ends a hold is for no HALT") {
  const std::string program = "MOVE(100, 0, 0)\nHALT \"load\"\nMOVE(0, 0, 0)\n";
  const Scripted both(program, "at 1s HOLD = ON\nat 2s GO = ON\nat 20s GO = ON\n");
  const json report = both.report();
  CHECK(report["status"] == "done");
  CHECK(interventions(report).starts_with("1 hold\n2 go\n"));
  CHECK(report["events"].back()["kind"] == "answer");
  CHECK(report["events"].back()["t"].get<double>() >= 20);
  const json one = Scripted(program, "at 1s HOLD = ON\nat 2s GO = ON\n").report();
  CHECK(one["error"]["code"] == "E342");
  CHECK(contains(one["error"]["message"], "HALT waits"));
}

TEST_CASE("a HOLD that nothing ends is an error, and the robot stands where it was held") {
  const Scripted held(kTwoLegs, "at 3s GO = ON\nat 7s HOLD = ON\n");
  const ProcessResult result = held.run({"--json"});
  CHECK(result.exit_code == 70);
  const json report = json::parse(result.out);
  CHECK(report["error"]["code"] == "E342");
  CHECK(report["error"]["line"] == 1);
  CHECK(contains(report["error"]["help"], "GO = ON"));
  CHECK(report["final"]["joints"][0].get<double>() < 20 * 9);
  CHECK(held.run({}, "check").exit_code == 65);
  // A STOP ends it, too.
  CHECK(Scripted(kTwoLegs, "at 7s HOLD = ON\nat 9s STOP = ON\n").run().exit_code == 130);
}

TEST_CASE("rob check foretells what a script does to the run") {
  const std::string script = "at 7s HOLD = ON\nat 13s GO = ON\nat 15s STOP = ON\n";
  const Scripted scripted(kTwoLegs, script);
  const ProcessResult result = scripted.run({}, "check");
  CHECK(result.exit_code == 0);
  CHECK(contains(result.err, "the signal script stops the robot"));
  const json report = scripted.report({}, "check");
  CHECK(report["status"] == "interrupted");
  CHECK(report["planned_s"] == scripted.report()["measured_s"]);
}

TEST_CASE("the prompt keeps a trace of all that is done at it") {
  const RobCommand rob("");
  const ProcessResult result = run_process(
      {"/bin/sh", "-c",
       "printf 'MOVE(40, 0, 0)\\nMOVE(40, 40, 0)\\nSTOP\\nMOVE(0, 0, 0)\\n' | '" ROB_BINARY
       "' --fast --trace '" +
           rob.file("prompt.csv") + "'"});
  CHECK(result.exit_code == 0);
  const auto rows = rob::test::parse_trace(rob::test::read_whole_file(rob.file("prompt.csv"))).rows;
  double most_x = 0;
  double most_y = 0;
  for (const TraceRow& row : rows) {
    most_x = std::max(most_x, row.q[0]);
    most_y = std::max(most_y, row.q[1]);
  }
  CHECK(most_x == doctest::Approx(40));
  CHECK(most_y == doctest::Approx(40));
  CHECK(rows.back().q[0] == doctest::Approx(0));
}
