#include <doctest/doctest.h>

#include <algorithm>
#include <string>

#include "tests/support/stepped_run.h"

using rob::runtime::RunResult;
using rob::runtime::SignalChange;
using rob::test::SteppedRun;

namespace {

int safe_events(const RunResult& result) {
  return static_cast<int>(std::ranges::count(result.events, "safe", &rob::runtime::RunEvent::kind));
}

/// The last change of a signal; it has one.
const SignalChange& last(const RunResult& result, const std::string& name) {
  const SignalChange* found = nullptr;
  for (const SignalChange& change : result.signals)
    if (change.name == name) found = &change;
  REQUIRE(found != nullptr);
  return *found;
}

const std::string kSignals =
    "SIGNAL torch = DOUT[1] SAFE OFF\n"
    "SIGNAL wire: SPEED = AOUT[1] SCALE 0mm/s TO 300mm/s SAFE 30mm/s\n"
    "torch = ON\n";

}  // namespace

TEST_CASE("an error that is not caught takes the SAFE values when all before it is done") {
  // 40 mm from rest to rest: 5.5 s.
  SteppedRun run(kSignals + "MOVE(40, 40, 0)\nlift = ON\nRAISE \"x\"\n");
  const RunResult result = run.run();
  CHECK(run.task.failure().has_value());
  CHECK(safe_events(result) == 2);
  CHECK(result.dropped_effects == 0);
  CHECK(last(result, "lift").time == doctest::Approx(5.5));
  CHECK_FALSE(last(result, "torch").value);
  CHECK(last(result, "torch").line == 1);
  CHECK(last(result, "torch").time >= last(result, "lift").time);
  CHECK(last(result, "torch").time <= 5.5 + 0.03);
  CHECK(last(result, "wire").number == doctest::Approx(30));
  CHECK(run.controller.channels().outputs.load() == 1U << 8);  // the lift stays up: DOUT[9]
}

TEST_CASE("an error that is caught and a normal end leave the outputs") {
  SteppedRun run(kSignals + "TRY\n  MOVE(40, 40, 0)\n  RAISE \"x\"\nRESCUE\nENDTRY\n");
  const RunResult result = run.run();
  CHECK(result.status == "done");
  CHECK(safe_events(result) == 0);
  CHECK(last(result, "torch").value);
}

TEST_CASE("a request to stop takes the SAFE values at once, and nothing sets them any more") {
  SteppedRun run(kSignals +
                 "WHEN NOT torch : torch = ON\nMOVE(40, 40, 0)\ntorch = ON\nMOVE(90, 0, 0)\n");
  run.each_cycle = [&](double now) {
    if (now >= 2.7) run.controller.request_hold();
  };
  const RunResult result = run.run();
  CHECK(safe_events(result) == 2);
  CHECK_FALSE(last(result, "torch").value);
  CHECK(last(result, "torch").time == doctest::Approx(2.7).epsilon(0.01));
  CHECK(result.measured > last(result, "torch").time + 0.1);  // it brakes with them
}

TEST_CASE("what is given up has not gone wrong") {
  SteppedRun run(kSignals + "LOOP\n  WAIT 1s\nENDLOOP\n");
  const RunResult result = run.run(5);
  CHECK(safe_events(result) == 0);
}

TEST_CASE("a WHEN that raises without a TRY ends the program, and the SAFE values are taken") {
  SteppedRun run(kSignals +
                 "WHEN lift_up : RAISE \"up\"\nlift = ON\nMOVE(100, 0, 0)\nMOVE(200, 0, 0)\n");
  const RunResult result = run.run();
  REQUIRE(run.task.failure().has_value());
  CHECK(run.task.failure()->message == "up");
  CHECK(run.task.failure()->place.line == 4);
  CHECK(safe_events(result) == 2);
  CHECK(result.final_joints[0] < 100);
  CHECK_FALSE(last(result, "torch").value);
}
