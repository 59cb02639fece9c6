#include <doctest/doctest.h>

#include <algorithm>

#include "tests/support/no_allocation.h"
#include "tests/support/stepped_run.h"

using rob::runtime::RunResult;
using rob::runtime::SignalChange;
using rob::test::SteppedRun;

// The lift of the gantry takes 0.5 s.

namespace {

/// When an output was switched, or −1.
double switched(const RunResult& result, const std::string& name, int line) {
  for (const SignalChange& change : result.signals)
    if (change.name == name && change.line == line) return change.time;
  return -1;
}

}  // namespace

TEST_CASE("a WHEN acts in the cycle in which its signal comes") {
  SteppedRun run("WHEN lift_up : DOUT[1] = ON\nlift = ON\nMOVE(100,0,0)");
  double seen = -1;
  run.each_cycle = [&](double now) {
    if (seen < 0 && (run.controller.channels().inputs >> 9 & 1) != 0) seen = now;
  };
  const RunResult result = run.run();
  REQUIRE(seen > 0);
  CHECK(switched(result, "DOUT[1]", 1) == doctest::Approx(seen).epsilon(1e-9));
  CHECK(result.dropped_effects == 0);
  CHECK(result.measured == doctest::Approx(7.75).epsilon(1e-9));
}

TEST_CASE("a WHEN is armed in motion order") {
  SteppedRun run("MOVE(100,0,0)\nWHEN lift_down : DOUT[1] = ON\nMOVE(200,0,0)");
  const RunResult result = run.run();
  CHECK(switched(result, "DOUT[1]", 2) == doctest::Approx(6.38).epsilon(1e-9));
}

TEST_CASE("a WHEN is disarmed where the motion leaves its block, and the blend is kept") {
  SteppedRun run(
      "VAR n = 1\nIF n == 1 THEN\n  WHEN lift_up : DOUT[1] = ON\n  MOVE(100,0,0)\nENDIF\n"
      "MOVE(200,0,0)\nlift = ON\nSTOP\nWAIT lift_up");
  const RunResult result = run.run();
  CHECK(switched(result, "DOUT[1]", 3) == -1);
  CHECK(result.starved == 0);
}

TEST_CASE("a WHEN is armed until the last motion has ended") {
  SteppedRun run("WHEN lift_up : DOUT[1] = ON\nMOVE(20,0,0)\nlift = ON\nMOVE(40,0,0)");
  const RunResult result = run.run();
  CHECK(switched(result, "DOUT[1]", 1) > 4);
}

TEST_CASE("the condition of a WHEN that cannot be computed is an error of the program") {
  SteppedRun run(
      "VAR n = 0\nWHEN lift_up AND 1 DIV n > 0 : DOUT[1] = ON\nlift = ON\nMOVE(100,0,0)\n"
      "PRINT \"never\"");
  const RunResult result = run.run();
  REQUIRE(run.task.failure());
  CHECK(run.task.failure()->code == "E302");
  CHECK(run.task.failure()->place.line == 2);
  CHECK(result.output.empty());
  CHECK(result.dropped_effects == 1);
  CHECK(result.measured < 1);
}

TEST_CASE("a WHEN that raises brakes at once, drops what is behind, and ends the program") {
  SteppedRun run(
      "WHEN lift_up : RAISE \"up\"\nlift = ON\nMOVE(100,0,0)\nPRINT 1\nDOUT[1] = ON\n"
      "MOVE(200,0,0)\nPRINT 2");
  const RunResult result = run.run();
  REQUIRE(run.task.failure());
  CHECK(run.task.failure()->code == "E340");
  CHECK(run.task.failure()->message == "up");
  CHECK(run.task.failure()->place.line == 1);
  CHECK(result.output.empty());
  CHECK(result.dropped_effects == 3);
  CHECK(result.measured < 1);
  CHECK(result.lines[0].ended == "brake");
}

TEST_CASE("an error that a WHEN raises is handled by the TRY around it, from the place of rest") {
  SteppedRun run(
      "TRY\n  WHEN lift_up : RAISE \"up\"\n  lift = ON\n  MOVE(100,0,0)\n  MOVE(200,0,0)\n"
      "RESCUE why\n  PRINT why\n  MOVE(0,40,0)\nENDTRY\nPRINT \"on\"");
  const RunResult result = run.run();
  CHECK(!run.task.failure());
  REQUIRE(result.output.size() == 2);
  CHECK(result.output[0] == "up");
  CHECK(result.output[1] == "on");
  CHECK(result.final_joints[0] == doctest::Approx(0));
  CHECK(result.final_joints[1] == doctest::Approx(40));
  double most_x = 0;
  for (const auto& row : run.rows) most_x = std::max(most_x, 1000 * row.sample.reference.q[0]);
  CHECK(most_x < 5);
}

TEST_CASE("a WHEN raises even while the program waits, computes or has nothing left to do") {
  const std::string when = "WHEN lift_up : RAISE \"up\"\nlift = ON\n";
  for (const char* rest : {"WAIT 100s", "WAIT lift_down AND lift_up", "LOOP\nENDLOOP",
                           "MOVE(100,0,0) UNTIL gripper_closed", "MOVE(100,0,0)"}) {
    SteppedRun run(when + rest);
    run.run(20);
    REQUIRE(run.task.failure());
    CHECK(run.task.failure()->code == "E340");
  }
}

TEST_CASE("a WHEN that is true when it is armed raises, also where nothing comes behind it") {
  for (const std::string way : {"", "MOVE(40,0,0)\n"}) {
    CAPTURE(way);
    SteppedRun run("lift = ON\nWAIT lift_up\n" + way + "WHEN lift_up : RAISE \"up\"");
    const RunResult result = run.run();
    REQUIRE(run.task.failure());
    CHECK(run.task.failure()->message == "up");
    CHECK(result.final_joints[0] == (way.empty() ? 0 : 40));
  }
  SteppedRun quiet("WHEN lift_up : RAISE \"up\"");
  quiet.run();
  CHECK_FALSE(quiet.task.failure());
}

TEST_CASE("a thousand WHENs one after another find their places") {
  SteppedRun run(
      "FOR i = 1 TO 1000 DO\n  WHEN lift_down : DOUT[1] = ON\n  WAIT 0.02s\nENDFOR\nPRINT 1");
  const RunResult result = run.run();
  CHECK(result.output.size() == 1);
  CHECK(result.signals.size() == 1000);
}

TEST_CASE("the control cycle takes no memory while it looks at WHENs") {
  SteppedRun run("WHEN lift_down : DOUT[1] = ON\nWHEN lift_up : DOUT[2] = ON\nMOVE(100,0,0)");
  run.controller.servo().enable(0);
  run.task.step(1000);
  rob::test::NoAllocation guard;
  for (int k = 0; k < 300; ++k) run.controller.motion().cycle(k, 0);
  CHECK(guard.count() == 0);
}

TEST_CASE("what a WHEN raises in a TRY is caught there, under the look-ahead law, too") {
  for (const char* law : {"paul", "lookahead"}) {
    CAPTURE(law);
    rob::test::SteppedRun run(std::string("LAW ") + law +
                              "\nTRY\nWHEN HERE.x > 10mm : RAISE \"far\"\n"
                              "MOVE(100, 0, 0) AT 10mm/s\nRESCUE why\nPRINT why\nENDTRY\n"
                              "PRINT \"end\"\n");
    const auto result = run.run();
    CHECK(result.output == std::vector<std::string>{"far", "end"});
    CHECK_FALSE(run.task.failure().has_value());
  }
}
