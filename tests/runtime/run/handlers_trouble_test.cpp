#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "runtime/run/run.h"
#include "tests/support/stepped_run.h"

using rob::runtime::RunResult;
using rob::test::SteppedRun;

// Handlers of WHEN where something else goes on at the same time. The lift of the gantry takes
// 0.5 s. Each run would go on for its 1000 s if nobody told motion that there is no handler.

TEST_CASE("a handler whose block the program has left does not begin") {
  // The program leaves the block at the decision point, 2.75 s; its corner ends 1.375 s later.
  SteppedRun run(
      "VAR n = 0\nIF n == 0 THEN\n  WHEN CLOCK > 3s : BRAKE\n  MOVE(40,0,0)\nENDIF\n"
      "WHEN CLOCK > 30s DO\n  PRINT \"other\"\nENDWHEN\nMOVE(40,100,0)\nMOVE(0,100,0)\nWAIT 0s");
  const RunResult result = run.run();
  CHECK(result.output.empty());
  CHECK(run.rows.back().sample.reference.q[0] == doctest::Approx(0).epsilon(1e-9));
  CHECK(run.rows.back().sample.reference.q[1] == doctest::Approx(0.1));
}

TEST_CASE("no handler begins once an error ends the program") {
  SteppedRun run(
      "VAR z = 0\nWHEN CLOCK > 2s DO\n  PRINT \"handler\"\n  STOP\nENDWHEN\nMOVE(100,0,0)\n"
      "z = 1 DIV z");
  const RunResult result = run.run();
  REQUIRE(run.task.failure());
  CHECK(run.task.failure()->code == "E302");
  CHECK(result.output.empty());
  CHECK(result.measured == doctest::Approx(7.75).epsilon(1e-9));
}

TEST_CASE("a WHEN that raises in the cycle of a handler goes first, and there is no handler") {
  SteppedRun run(
      "WHEN CLOCK > 1s DO\n  PRINT \"h\"\n  MOVE(0,10,0)\nENDWHEN\n"
      "WHEN CLOCK > 1s : RAISE \"r\"\nMOVE(100,0,0)");
  const RunResult result = run.run();
  REQUIRE(run.task.failure());
  CHECK(run.task.failure()->message == "r");
  CHECK(result.output.empty());
  CHECK(result.measured < 2);
}

TEST_CASE("a handler waits until an error of the program is settled, and begins then") {
  SteppedRun run(
      "VAR z = 0\nWHEN CLOCK > 2s DO\n  PRINT \"handler\"\n  STOP\nENDWHEN\nTRY\n"
      "  MOVE(100,0,0)\n  z = 1 DIV z\nRESCUE why\n  PRINT \"rescued\"\nENDTRY\nMOVE(0,0,0)");
  const RunResult result = run.run();
  CHECK(!run.task.failure());
  CHECK(result.output == std::vector<std::string>{"rescued", "handler"});
}

TEST_CASE("what cannot be reached any more behind BRAKE is an error, and nothing of it begins") {
  SteppedRun run(
      "WHEN CLOCK > 0.5s : BRAKE\nTRY\n  MOVE(30,0,0)\n  MOVE BY (-20,0,0)\n"
      "  MOVE BY (20,50,0)\n  STOP\nRESCUE why\n  PRINT why\nENDTRY");
  RunResult result = run.run();
  CHECK(!run.task.failure());  // it was braked on its first mm: 20 mm back from there is below 0
  REQUIRE(result.output.size() == 1);
  CHECK(result.output[0].find("line 4") != std::string::npos);
  CHECK(result.output[0].find("-19") != std::string::npos);
  CHECK(run.rows.back().sample.reference.q[1] == 0);
}

TEST_CASE("a TRY of a handler does not catch what another WHEN raises") {
  SteppedRun run(
      "WHEN lift_up DO\n  TRY\n    lift = OFF\n    MOVE(0,60,0)\n  RESCUE why\n    PRINT why\n"
      "  ENDTRY\nENDWHEN\nWHEN lift_down AND CLOCK > 0.2s : RAISE \"down\"\nlift = ON\n"
      "MOVE(100,0,0)\nPRINT \"one\"");
  const RunResult result = run.run();
  REQUIRE(run.task.failure());
  CHECK(run.task.failure()->message == "down");
  CHECK(result.output.empty());
}

TEST_CASE("behind BRAKE only the motion that has an UNTIL is asked") {
  SteppedRun run(
      "WHEN CLOCK > 0.5s : BRAKE\nMOVE(100,0,0)\nMOVE(100,100,0)\n"
      "MOVE(200,100,0) UNTIL HERE.x > 150mm\nPRINT HIT, \" \", HERE.y");
  const RunResult result = run.run();
  CHECK(result.output == std::vector<std::string>{"TRUE 100mm"});
}

TEST_CASE("behind BRAKE components that were left out are those of the new place, in a frame too") {
  SteppedRun run(
      "FRAME f = POSE(100mm, 100mm, 0mm)\nWHEN CLOCK > 1s DO\n  MOVE(50,60,0)\n  BRAKE\nENDWHEN\n"
      "WITH IN f DO\n  MOVE(0,0,0)\n  MOVE(x: 50)\n  STOP\nENDWITH");
  run.run();
  CHECK(run.rows.back().sample.reference.q[0] == doctest::Approx(0.15));
  CHECK(run.rows.back().sample.reference.q[1] == doctest::Approx(0.06));
}

TEST_CASE("HIT is that of the program, whatever a handler's own motions have met") {
  SteppedRun run(
      "lift = ON\nMOVE(100,0,0) UNTIL lift_up\nWHEN CLOCK > 1.5s DO\n"
      "  MOVE(0,10,0) UNTIL DIN[1]\n  PRINT HIT\nENDWHEN\nWAIT CLOCK > 9s\nPRINT HIT");
  CHECK(run.run().output == std::vector<std::string>{"FALSE", "TRUE"});
}

TEST_CASE("in real time, with threads, a handler has the axes and gives them back") {
  const rob::motion::RobotModel robot = rob::motion::embedded_robot("gantry");
  const auto program = rob::runtime::compile_program(
      "test.rob",
      "VAR n = 0\nWHEN CLOCK > 0.5s DO\n  n = n + 1\n  WAIT 0.2s\nENDWHEN\nWHEN CLOCK > 0.6s DO\n"
      "  n = n + 10\nENDWHEN\nMOVE(20,0,0)\nWAIT CLOCK > 0s\nPRINT n",
      robot);
  const RunResult result = rob::runtime::run(program, robot, {}, {});
  CHECK(result.output == std::vector<std::string>{"11"});
  CHECK(result.status == "done");
  CHECK(result.measured > 5.5);
}
