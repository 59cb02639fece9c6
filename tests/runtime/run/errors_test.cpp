#include <doctest/doctest.h>

#include "tests/support/stepped_run.h"

using rob::runtime::RunResult;
using rob::test::SteppedRun;

TEST_CASE("an error takes effect when all that was commanded before it is finished") {
  // 40 mm at 20 mm/s under a t_acc of 1.375 s: 2.75 s to the decision, 2.75 s to rest.
  SteppedRun run(
      "VAR far = 9000mm\n"
      "TRY\n"
      "  MOVE(40, 40, 0)\n"
      "  lift = ON\n"
      "  PRINT \"there\"\n"
      "  MOVE(far, 40, 0)\n"
      "RESCUE why\n"
      "  gripper = ON\n"
      "  PRINT why\n"
      "ENDTRY\n");
  const RunResult result = run.run();
  CHECK(result.status == "done");
  REQUIRE(result.output.size() == 2);
  CHECK(result.output[0] == "there");
  CHECK(result.output[1].starts_with("E401: axis x: 9000 mm is beyond"));
  REQUIRE(result.signals.size() == 2);
  CHECK(result.signals[0].name == "lift");
  CHECK(result.signals[0].time == doctest::Approx(5.5));
  CHECK(result.signals[1].name == "gripper");
  CHECK(result.signals[1].time >= result.signals[0].time);
  CHECK(result.final_joints[0] == doctest::Approx(40));
}

TEST_CASE("a RESCUE starts at standstill with an empty queue, and moves on from there") {
  SteppedRun run(
      "TRY\n"
      "  MOVE(40, 40, 0)\n"
      "  RAISE \"x\"\n"
      "RESCUE\n"
      "  PRINT \"rescued\"\n"
      "  MOVE(60, 40, 0)\n"
      "ENDTRY\n");
  const RunResult result = run.run();
  CHECK(result.status == "done");
  CHECK(result.starved == 0);
  CHECK(result.final_joints[0] == doctest::Approx(60));
  // Rest to rest twice: what it takes with a STOP in the place of the error, and the cycles in
  // which the standstill is seen, told to the program, and left.
  SteppedRun stopped("MOVE(40, 40, 0)\nSTOP\nMOVE(60, 40, 0)\n");
  const double both = stopped.run().measured;
  CHECK(result.measured >= both - 1e-9);
  CHECK(result.measured <= both + 0.03 + 1e-9);
}

TEST_CASE("leaving a TRY normally keeps the blend") {
  const std::string plain = "MOVE(40, 40, 0)\nMOVE(140, 40, 0)\nMOVE(90, 126, 0)\n";
  SteppedRun with(
      "TRY\n"
      "  MOVE(40, 40, 0)\n"
      "  MOVE(140, 40, 0)\n"
      "RESCUE\n"
      "ENDTRY\n"
      "MOVE(90, 126, 0)\n");
  SteppedRun without(plain);
  const RunResult guarded = with.run();
  CHECK(guarded.measured == without.run().measured);
  CHECK(guarded.starved == 0);
}

TEST_CASE("a guard of a motion that was refused guards no other") {
  SteppedRun run(
      "VAR far = 9000mm\n"
      "lift = ON\n"
      "TRY\n"
      "  MOVE(far, 40, 0) UNTIL lift_up\n"
      "RESCUE\n"
      "ENDTRY\n"
      "WAIT lift_up\n"
      "MOVE(40, 40, 0)\n");
  const RunResult result = run.run();
  CHECK(result.status == "done");
  CHECK(result.final_joints[0] == doctest::Approx(40));
}

TEST_CASE("an uncaught error behind a caught one ends the run with its own place") {
  SteppedRun run("TRY\n  RAISE \"a\"\nRESCUE\n  RAISE \"b\"\nENDTRY\n");
  run.run();
  REQUIRE(run.task.failure().has_value());
  CHECK(run.task.failure()->message == "b");
  CHECK(run.task.failure()->place.line == 4);
}

TEST_CASE(
    "BRAKE ends the motion before it on its path, drops its effects, and goes on from there") {
  SteppedRun run(
      "MOVE(40, 0, 0)\n"
      "MOVE(240, 0, 0)\n"
      "gripper = ON\n"
      "BRAKE\n"
      "lift = ON\n"
      "MOVE(y: 40mm)\n");
  const RunResult result = run.run();
  CHECK(result.status == "done");
  CHECK(result.dropped_effects == 1);
  REQUIRE(result.signals.size() == 1);
  CHECK(result.signals[0].name == "lift");
  // The second motion becomes the running one at 2.75 s, at about 20 mm; x stays where it came to
  // rest.
  CHECK(result.final_joints[0] > 20);
  CHECK(result.final_joints[0] < 40);
  CHECK(result.final_joints[1] == doctest::Approx(40));
}

TEST_CASE("BRAKE where nothing moves changes nothing") {
  SteppedRun run(
      "BRAKE\n"
      "MOVE(40, 0, 0)\n"
      "STOP\n"
      "lift = ON\n"
      "BRAKE\n"
      "MOVE(60, 0, 0)\n");
  const RunResult result = run.run();
  CHECK(result.dropped_effects == 0);
  CHECK(result.signals.size() == 1);
  CHECK(result.final_joints[0] == doctest::Approx(60));
}

TEST_CASE("BRAKE behind a FINE motion brakes the motion, not its arrival") {
  SteppedRun run("MOVE(200, 0, 0) FINE\nBRAKE\n");
  const RunResult result = run.run();
  CHECK(result.status == "done");
  CHECK(result.final_joints[0] < 20);
}

TEST_CASE("an error points at the statement that has raised it") {
  using rob::lang::Place;
  const auto place_of_error = [](const char* program) {
    SteppedRun run(program);
    run.run();
    REQUIRE(run.task.failure());
    return run.task.failure()->place;
  };
  CHECK(place_of_error("lift = ON\n  WHEN lift_up : RAISE \"up\"\nMOVE(100, 0, 0)") ==
        Place{2, 18, 5});
  CHECK(place_of_error("lift = ON\nWHEN lift_up AND 1 / (CLOCK - CLOCK) > 2Hz : gripper = ON\n"
                       "MOVE(100, 0, 0)") == Place{2, 14, 3});
  CHECK(place_of_error("VAR far = 50mm\nMOVE(40, 0, 0) DO\n  AFTER 5mm : lift = ON\n"
                       "  AFTER far : lift = OFF\nENDMOVE") == Place{4, 3, 5});
  CHECK(place_of_error("TASK t\n  WAIT lift_up\nENDTASK\nSTART t\n  START t\nMOVE(40, 0, 0)") ==
        Place{5, 3, 5});
}
