#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "motion/robots/time_scaling.h"
#include "tests/support/no_allocation.h"
#include "tests/support/stepped_run.h"

using rob::runtime::RunResult;
using rob::test::line;
using rob::test::SteppedRun;

// 100 mm of the gantry take 5 s and the exact stop 2.75 s; its lift takes 0.5 s.

TEST_CASE("a guarded motion ends where its signal comes, and the report says so") {
  SteppedRun run("lift = ON\nMOVE(100,0,0) UNTIL lift_up ELSE PRINT \"missed\"\nPRINT HIT");
  const RunResult result = run.run();
  REQUIRE(result.output.size() == 1);
  CHECK(result.output[0] == "TRUE");
  CHECK(line(result, 2).ended == "hit");
  CHECK(!line(result, 2).miss_planned);
  REQUIRE(result.events.size() == 1);
  CHECK(result.events[0].kind == "hit");
  CHECK(result.events[0].line == 2);
  CHECK(result.events[0].time >= 0.5);
  CHECK(result.events[0].time <= 0.53);
  CHECK(result.events[0].text.find("at rest 0.36") == 0);
  CHECK(result.final_joints[0] > 0);
  CHECK(result.final_joints[0] < 10);
  CHECK(result.dropped_effects == 0);
}

TEST_CASE("a guarded motion that arrives executes its ELSE and takes the time of an exact one") {
  SteppedRun run("MOVE(100,0,0) UNTIL lift_up ELSE PRINT \"missed\"\nPRINT HIT");
  const RunResult result = run.run();
  REQUIRE(result.output.size() == 2);
  CHECK(result.output[0] == "missed");
  CHECK(result.output[1] == "FALSE");
  CHECK(line(result, 1).ended == "reached");
  CHECK(line(result, 1).planned == doctest::Approx(7.75).epsilon(1e-12));
  CHECK(result.measured >= 7.75);  // the program goes on in the cycles behind the arrival
  CHECK(result.measured <= 7.75 + 0.03);
  CHECK(!line(result, 1).decides);
  CHECK(result.starved == 0);
  CHECK(result.events.empty());
}

TEST_CASE("the motion behind an early end starts at its place of rest and keeps what is left out") {
  // The lift is told in the corner, 2.75 s + 1.375 s after the start, and is up 0.5 s later, at
  // 20 mm + 20 mm/s · 0.5 s minus what the corner still lacks.
  SteppedRun run("MOVE(20,0,0)\nlift = ON\nMOVE(120,0,0) UNTIL lift_up\nMOVE(, 40, )");
  const RunResult result = run.run();
  CHECK(line(result, 3).ended == "hit");
  CHECK(result.final_joints[0] > 20);
  CHECK(result.final_joints[0] < 40);
  CHECK(result.final_joints[1] == doctest::Approx(40));
  CHECK(line(result, 4).ended == "reached");
  double most_x = 0;
  for (const auto& row : run.rows) most_x = std::max(most_x, 1000 * row.sample.reference.q[0]);
  CHECK(most_x == doctest::Approx(result.final_joints[0]).epsilon(1e-9));
}

TEST_CASE("from standstill a condition that holds lets nothing move") {
  SteppedRun run("MOVE(100,0,0) UNTIL lift_down\nPRINT HIT");
  const RunResult result = run.run();
  REQUIRE(result.output.size() == 1);
  CHECK(result.output[0] == "TRUE");
  for (const auto& row : run.rows) CHECK(row.sample.reference.q[0] == 0);
  CHECK(result.measured < 0.05);
}

TEST_CASE("a motion is blended into a guarded one, and effects before it act in the corner") {
  SteppedRun run("MOVE(100,0,0)\nlift = ON\nMOVE(200,0,0) UNTIL lift_up");
  const RunResult result = run.run();
  CHECK(line(result, 1).measured == doctest::Approx(5).epsilon(1e-9));
  REQUIRE(result.signals.size() == 1);
  CHECK(result.signals[0].time == doctest::Approx(6.38).epsilon(1e-9));
  CHECK(line(result, 3).ended == "hit");
  REQUIRE(result.events.size() == 1);
  CHECK(result.events[0].time == doctest::Approx(6.9).epsilon(0.005));
}

TEST_CASE("a condition that cannot be computed ends the program in motion order") {
  SteppedRun run(
      "VAR n = 0\nMOVE(20,0,0)\nPRINT \"there\"\nMOVE(100,0,0) UNTIL 1 DIV n == 2\nPRINT 1");
  const RunResult result = run.run();
  REQUIRE(run.task.failure());
  CHECK(run.task.failure()->code == "E302");
  CHECK(run.task.failure()->place.line == 4);
  REQUIRE(result.output.size() == 1);
  CHECK(result.output[0] == "there");
}

TEST_CASE("guarded motions in a loop run one after the other") {
  SteppedRun run("FOR i = 1 TO 200 DO\n  MOVE(100,0,0) UNTIL lift_down\nENDFOR\nPRINT HIT");
  const RunResult result = run.run();
  CHECK(line(result, 2).count == 200);
  CHECK(result.output.size() == 1);
  CHECK(result.final_joints[0] == 0);
}

TEST_CASE("two runs with an early end have the same bits") {
  const std::string text = "lift = ON\nMOVE(100,70,20) UNTIL lift_up\nMOVE(0,0,0)";
  SteppedRun a(text);
  SteppedRun b(text);
  a.run();
  b.run();
  REQUIRE(a.rows.size() == b.rows.size());
  for (std::size_t k = 0; k < a.rows.size(); ++k) {
    REQUIRE(a.rows[k].sample.reference.q == b.rows[k].sample.reference.q);
  }
}

TEST_CASE("the control cycle takes no memory while it looks at a condition") {
  SteppedRun run("MOVE(100,0,0) UNTIL DIN[1] AND SIN(1deg) > 2");
  run.controller.servo().enable(0);
  run.task.step(1000);
  rob::test::NoAllocation guard;
  for (int k = 0; k < 300; ++k) run.controller.motion().cycle(k, 0);
  CHECK(guard.count() == 0);
}

TEST_CASE("a slow motion that ends early stands as soon as its own speed permits") {
  // x at 1 mm/s, with 100 mm/s² and 1000 mm/s³. S1 leaves of them, with t_acc = 2.75 s,
  //   r' <= A/v − 1.5/t = 99.5 /s     r'' <= J/v − 3/t² − 4.5·r'/t = 837 /s²
  // so r is at 0 after 2/√r'' = 69 ms; under the look-ahead law a ramp of 2·√(v/J) = 63 ms, and as
  // long a mean in whole periods.
  struct {
    const char* law;
    double most;
  } const cases[] = {{"paul", 0.0692}, {"lookahead", 0.0633 + 0.02}};
  for (const auto& one : cases) {
    CAPTURE(one.law);
    SteppedRun run(std::string("LAW ") + one.law +
                   "\nMOVE(100,0,0) AT 1mm/s UNTIL CLOCK > 8s\nMOVE(200,0,0)\n");
    const RunResult result = run.run();
    double first = 0;
    double last = 0;
    double before = 0;
    for (const auto& row : run.rows) {
      const double t = row.sample.reference.time;
      CHECK(std::abs(row.sample.reference.qdd[0]) <= 0.1 + 1e-9);
      CHECK(std::abs(row.sample.reference.qdd[0] - before) <=
            1.0 * run.robot.reference_period + 1e-9);
      before = row.sample.reference.qdd[0];
      if (row.sample.state != rob::motion::MotionState::Stopping) continue;
      if (first == 0) first = t;
      last = t;
    }
    CHECK(first == doctest::Approx(8.02).epsilon(0.002));
    CHECK(last - first <= one.most);
    CHECK(line(result, 3).ended == "reached");
    CHECK(run.rows.back().sample.reference.q[0] == doctest::Approx(0.2));
  }
}
