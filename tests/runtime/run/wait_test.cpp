#include <doctest/doctest.h>

#include "tests/support/stepped_run.h"

using rob::runtime::RunResult;
using rob::test::line;
using rob::test::SteppedRun;

// Every short motion and every stop of the gantry takes 2.75 s; its lift takes 0.5 s.

TEST_CASE("a WAIT makes the move before it exact and takes its own time exactly") {
  SteppedRun run("MOVE(40,0,0)\nWAIT 0.3333s\nMOVE(0,0,0)");
  const RunResult result = run.run();
  CHECK(line(result, 1).exact);
  CHECK(line(result, 1).miss_planned == 0);
  CHECK(line(result, 2).planned == doctest::Approx(2.75 + 0.3333).epsilon(1e-12));
  CHECK(line(result, 2).measured == doctest::Approx(2.75 + 0.3333).epsilon(1e-12));
  CHECK(line(result, 2).count == 1);
  CHECK(line(result, 3).starts == doctest::Approx(2 * 2.75 + 0.3333).epsilon(1e-12));
  CHECK(result.planned == doctest::Approx(4 * 2.75 + 0.3333).epsilon(1e-12));
  CHECK(result.measured == doctest::Approx(4 * 2.75 + 0.3333).epsilon(1e-12));
}

TEST_CASE("behind an exact move a WAIT takes nothing but its own time") {
  SteppedRun run("MOVE(40,0,0)\nSTOP\nWAIT 0.5s\nWAIT 0s");
  const RunResult result = run.run();
  CHECK(line(result, 3).planned == doctest::Approx(0.5).epsilon(1e-12));
  CHECK(result.measured == doctest::Approx(2 * 2.75 + 0.5).epsilon(1e-12));
}

TEST_CASE("WAIT 0s is a barrier and nothing else") {
  SteppedRun run("MOVE(40,0,0)\nWAIT 0s\nMOVE(0,0,0)");
  const RunResult result = run.run();
  CHECK(line(result, 1).exact);
  CHECK(result.measured == doctest::Approx(4 * 2.75).epsilon(1e-12));
}

TEST_CASE("a WAIT at the very beginning delays the first move") {
  SteppedRun run("WAIT 1.005s\nMOVE(40,0,0)");
  const RunResult result = run.run();
  CHECK(line(result, 2).starts == doctest::Approx(1.005).epsilon(1e-12));
}

TEST_CASE("an override does not stretch a WAIT") {
  SteppedRun run("MOVE(40,0,0)\nSTOP\nWAIT 1s", nullptr, 0.5);
  const RunResult result = run.run();
  CHECK(line(result, 3).planned == doctest::Approx(1).epsilon(1e-12));
  CHECK(line(result, 3).measured == doctest::Approx(1).epsilon(1e-9));
  CHECK(result.measured == doctest::Approx(2 * 2 * 2.75 + 1).epsilon(1e-9));
}

TEST_CASE("a WAIT for the lift lasts as long as the lift, in whole cycles") {
  SteppedRun run("MOVE(40,0,0)\nSTOP\nlift = ON\nWAIT lift_up\nPRINT 1");
  const RunResult result = run.run();
  const double waited = line(result, 4).measured;
  CHECK(waited >= 0.5);
  CHECK(waited <= 0.5 + 0.06);  // some cycles from the program to the machine and back
  CHECK(result.measured == doctest::Approx(2 * 2.75 + waited).epsilon(1e-9));
  CHECK(result.output.size() == 1);
}

TEST_CASE("a condition is looked at when the effects before the WAIT have acted") {
  SteppedRun run("MOVE(40,0,0)\nlift = ON\nWAIT lift\nPRINT \"lit\"");
  const RunResult result = run.run();
  REQUIRE(result.signals.size() == 1);
  CHECK(result.signals[0].time == doctest::Approx(5.5).epsilon(1e-9));
  CHECK(line(result, 3).measured < 2.75 + 0.05);
}

TEST_CASE("the inputs are known before the first cycle") {
  SteppedRun run("PRINT lift_down\nWAIT NOT lift_down TIMEOUT 0.1s ELSE PRINT \"down\"");
  const RunResult result = run.run();
  REQUIRE(result.output.size() == 2);
  CHECK(result.output[0] == "TRUE");
  CHECK(result.output[1] == "down");
}

TEST_CASE("a timeout counts from standstill and ends the program in motion order") {
  SteppedRun run("MOVE(40,0,0)\nWAIT lift_up TIMEOUT 0.5s\nPRINT \"never\"");
  const RunResult result = run.run();
  REQUIRE(run.task.failure());
  CHECK(run.task.failure()->code == "E313");
  CHECK(run.task.failure()->place.line == 2);
  CHECK(result.output.empty());
  CHECK(line(result, 2).measured >= 2.75 + 0.5);
  CHECK(line(result, 2).measured <= 2.75 + 0.5 + 0.05);
}

TEST_CASE("more waits than the buffer holds keep their time") {
  SteppedRun run("FOR i = 1 TO 200 DO\n  WAIT 0.0125s\nENDFOR");
  const RunResult result = run.run();
  CHECK(result.measured == doctest::Approx(2.5).epsilon(1e-9));
  CHECK(line(result, 2).count == 200);
}
