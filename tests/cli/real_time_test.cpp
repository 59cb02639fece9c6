// What `rob run` promises in real time where the computer keeps up: run by in_time.
#include <doctest/doctest.h>

#include <chrono>
#include <cmath>
#include <csignal>
#include <string>
#include <thread>

#include "tests/support/rob_command.h"
#include "tests/support/trace_rows.h"

using nlohmann::json;
using rob::test::Process;
using rob::test::ProcessResult;
using rob::test::RobCommand;
using rob::test::wait_until_it_moves;
using namespace std::chrono_literals;

TEST_CASE("in real time a program takes the time that was foretold") {
  const ProcessResult result = RobCommand("MOVE(20,0,0)\n")("run", {"--json"});
  CHECK(result.exit_code == 0);
  const json report = json::parse(result.out);
  CHECK(report["clock"] == "system");
  CHECK(report["planned_s"] == 5.5);
  CHECK(std::abs(report["measured_s"].get<double>() - 5.5) < 0.3);
  CHECK(report["cycles"] == 550);
}

TEST_CASE("fault 15: a process that is stopped for moments loses samples, not time") {
  const RobCommand rob("MOVE(20,0,0)\n");
  const std::string trace = rob.file("t.csv");
  Process run(rob.line("run", {"--json", "--trace", trace}));
  wait_until_it_moves(trace);
  for (int stall = 0; stall < 3; ++stall) {
    run.send(SIGSTOP);
    std::this_thread::sleep_for(50ms);
    run.send(SIGCONT);
    std::this_thread::sleep_for(300ms);
  }
  const ProcessResult result = run.wait();
  CHECK(result.exit_code == 0);
  const json report = json::parse(result.out);
  CHECK(report["late_cycles"] >= 3);
  CHECK(report["cycles"] == 550);
  CHECK(std::abs(report["measured_s"].get<double>() - 5.5) < 0.3);
}
