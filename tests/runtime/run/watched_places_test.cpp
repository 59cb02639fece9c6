#include <doctest/doctest.h>

#include <cmath>

#include "tests/support/no_allocation.h"
#include "tests/support/stepped_run.h"

using rob::runtime::RunResult;
using rob::test::line;
using rob::test::SteppedRun;

// From rest an axis of the gantry runs at 20 mm/s from 2·t_acc = 2.75 s on and is at
// 20 mm/s · (t − 1.375 s) then (S1). Conditions are looked at every 10 ms.

namespace {

/// The first control cycle in which 20 mm/s · (t − 1.375 s) is beyond `x` mm, s.
double cycle_beyond(double x) { return 0.01 * (std::floor((x / 20 + 1.375) * 100 + 1e-9) + 1); }

}  // namespace

TEST_CASE("HERE ends a motion in the first cycle in which its reference is beyond a place") {
  SteppedRun run("MOVE(100,0,0) UNTIL HERE.x > 50mm\nPRINT HIT\nPRINT HITPOSE.x / 1mm");
  const RunResult result = run.run();
  REQUIRE(result.events.size() == 1);
  CHECK(result.events[0].kind == "hit");
  CHECK(result.events[0].time == doctest::Approx(cycle_beyond(50)).epsilon(1e-9));  // 3.88 s
  REQUIRE(result.output.size() == 2);
  CHECK(result.output[0] == "TRUE");
  // Measured: the servo follows within a twentieth of a millimetre.
  CHECK(std::stod(result.output[1]) == doctest::Approx(20 * (3.88 - 1.375)).epsilon(0.001));
}

TEST_CASE("HERE in a condition is the tip of the active tool") {
  SteppedRun run(
      "TOOL pen = POSE(30mm, 0mm, 0mm)\nMOVE(140,0,0) WITH pen UNTIL HERE.x > 80mm\nPRINT HIT");
  const RunResult result = run.run();
  REQUIRE(result.events.size() == 1);
  CHECK(result.events[0].time == doctest::Approx(cycle_beyond(80 - 30)).epsilon(1e-9));  // 3.88 s
}

TEST_CASE("HERE is where the corner is, not where its target lies") {
  SteppedRun run("MOVE(100,0,0)\nMOVE(100,80,0) UNTIL HERE.y > 1mm AND HERE.x < 100mm");
  const RunResult result = run.run();
  // In the corner y = 80 mm · 1.375/4 · (2 − h)·h³ with h = (t − 5 s) / 2.75 s.
  int cycle = 500;
  const auto y = [](double h) { return 80 * 1.375 / 4 * (2 - h) * h * h * h; };
  while (y((0.01 * cycle - 5) / 2.75) <= 1) ++cycle;
  REQUIRE(result.events.size() == 1);
  CHECK(result.events[0].time == doctest::Approx(0.01 * cycle).epsilon(1e-9));
  CHECK(line(result, 2).ended == "hit");
}

TEST_CASE("a WHEN that looks at a place or at the time acts in that very cycle") {
  SteppedRun run(
      "WHEN HERE.x > 60mm : lift = ON\nWHEN CLOCK > 1.234s : gripper = ON\n"
      "MOVE(100,0,0)");
  const RunResult result = run.run();
  REQUIRE(result.signals.size() == 2);
  CHECK(result.signals[0].name == "gripper");
  CHECK(result.signals[0].time == doctest::Approx(1.24).epsilon(1e-9));
  CHECK(result.signals[1].name == "lift");
  CHECK(result.signals[1].time == doctest::Approx(cycle_beyond(60)).epsilon(1e-9));
}

TEST_CASE("CLOCK ends a motion, and a WAIT waits for it") {
  SteppedRun run("MOVE(100,0,0) UNTIL CLOCK >= 2s\nWAIT CLOCK > 4s\nPRINT CLOCK < 4.05s");
  const RunResult result = run.run();
  REQUIRE(result.events.size() == 1);
  CHECK(result.events[0].time == doctest::Approx(2).epsilon(1e-9));
  REQUIRE(result.output.size() == 1);
  CHECK(result.output[0] == "TRUE");
}

TEST_CASE("what a condition computes of places and of variables is what a program computes") {
  SteppedRun run(
      "VAR p = POSE(50mm, 0mm, 0mm, 0deg, 0deg, 90deg)\nVAR v: VEC = (3mm, 4mm, 0mm)\n"
      "VAR j = JOINTS(60mm, 0mm, 0deg)\n"
      "MOVE(100,0,0) UNTIL DIST(HERE, p) < NORM(v)\n"
      "MOVE(100,0,0) UNTIL JOINTS()[1] > j[1] AND (p * v).x == 46mm AND p.c == 90deg");
  const RunResult result = run.run();
  REQUIRE(result.events.size() == 2);
  // 50 mm − 5 mm; 60 mm comes while the second motion still gathers speed or later.
  CHECK(result.events[0].time == doctest::Approx(cycle_beyond(45)).epsilon(1e-9));
  CHECK(result.events[1].line == 5);
  CHECK(result.final_joints[0] > 60);
  CHECK(result.final_joints[0] < 68);
}

TEST_CASE("JOINTS of a pose are the gantry's own, nearest to what is asked for") {
  SteppedRun run(
      "MOVE(100,0,90) FINE\nPRINT JOINTS()\nPRINT FORWARD(JOINTS()).c\n"
      "VAR p = POSE(10mm, 20mm, 0mm, 0deg, 0deg, 180deg)\nPRINT JOINTS(p)\n"
      "PRINT JOINTS(p, near: JOINTS(0mm, 0mm, -150deg))[3] / 1deg\n"
      "MOVE JOINTS(100mm, 10mm, 90deg)");
  const RunResult result = run.run();
  REQUIRE(result.output.size() == 4);
  CHECK(result.output[0] == "JOINTS(100mm, 0mm, 90deg)");
  CHECK(result.output[1] == "90deg");
  CHECK(result.output[2] == "JOINTS(10mm, 20mm, 180deg)");
  CHECK(std::stod(result.output[3]) == doctest::Approx(-180));
  REQUIRE(result.final_joints.size() == 3);
  CHECK(result.final_joints[1] == doctest::Approx(10));
}

TEST_CASE("the control cycle takes no memory while it looks at places") {
  SteppedRun run(
      "VAR p = POSE(500mm, 0mm, 0mm)\n"
      "MOVE(100,0,0) UNTIL DIST(HERE, p) < 1mm OR JOINTS()[1] > 1m OR CLOCK > 100s");
  run.controller.servo().enable(0);
  run.task.step(1000);
  rob::test::NoAllocation guard;
  for (int k = 0; k < 300; ++k) run.controller.motion().cycle(k, 0);
  CHECK(guard.count() == 0);
}
