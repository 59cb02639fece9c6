#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "tests/support/no_allocation.h"
#include "tests/support/stepped_run.h"

using rob::runtime::RunResult;
using rob::runtime::Snapshot;
using rob::test::line;
using rob::test::SteppedRun;

// The lift of the gantry takes 0.5 s: lift_up comes 0.5 s behind lift = ON. The axes move at 20
// mm/s at most and change speed by 100 mm/s² at most; a corner takes 2·1.375 s.

namespace {

constexpr double kPeriod = 0.01;  // s
constexpr double kSpeed = 0.02;   // m/s
constexpr double kAccel = 0.1;    // m/s²

/// No reference leaves what the axes can do, however the path was left and found again.
void check_limits(const std::vector<Snapshot>& rows) {
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const auto& before = rows[i - 1].sample.reference;
    const auto& now = rows[i].sample.reference;
    for (int axis = 0; axis < 2; ++axis) {
      REQUIRE(std::abs(now.q[axis] - before.q[axis]) <= kSpeed * kPeriod * (1 + 1e-9));
      REQUIRE(std::abs(now.qd[axis] - before.qd[axis]) <= kAccel * kPeriod * (1 + 1e-9));
    }
  }
}

/// Where the axes stood while a line ran, m: the first of these rows.
double x_of_line(const std::vector<Snapshot>& rows, std::uint32_t number) {
  for (const Snapshot& row : rows)
    if (row.sample.tag == number) return row.sample.reference.q[0];
  return -1;
}

}  // namespace

TEST_CASE("a handler has the axes at rest, brings them back, and the motion goes on") {
  SteppedRun run(
      "WHEN lift_up DO\n  PRINT \"up\"\n  MOVE(0,60,0)\n  PRINT \"there\"\nENDWHEN\n"
      "lift = ON\nMOVE(100,0,0)\nPRINT \"end\"");
  const RunResult result = run.run();
  CHECK(result.output == std::vector<std::string>{"up", "there", "end"});
  check_limits(run.rows);
  bool on_its_way = true;
  double left = -1, found = -1;
  for (const Snapshot& row : run.rows) {
    const auto& q = row.sample.reference.q;
    if (row.sample.tag == 7) {
      CHECK(q[1] == doctest::Approx(0).epsilon(1e-12));
      (on_its_way ? left : found) = on_its_way || found < 0 ? q[0] : found;
    } else {
      on_its_way = false;
    }
  }
  CHECK(found == doctest::Approx(left).epsilon(1e-9));
  CHECK(run.rows.back().sample.reference.q[0] == doctest::Approx(0.1));
  CHECK(line(result, 7).ended == "reached");
}

TEST_CASE("a handler that does not move leaves path and corners as they were") {
  const std::string triangle =
      "lift = ON\nMOVE(40,40,0)\nMOVE(140,40,0)\nMOVE(90,126,0)\nMOVE(40,40,0)\n";
  SteppedRun plain("\n" + triangle);
  const RunResult without = plain.run();
  SteppedRun run("WHEN lift_up DO\n  WAIT 1s\nENDWHEN\n" + triangle);
  const RunResult with = run.run();
  check_limits(run.rows);
  for (int number = 2; number <= 4; ++number) {
    CHECK(*line(with, number + 3).miss_measured ==
          doctest::Approx(*line(without, number + 1).miss_measured).epsilon(1e-3));
  }
  // The second of the WAIT, and what slowing down and speeding up again cost.
  CHECK(with.measured > without.measured + 1);
  CHECK(with.measured < without.measured + 1 + 0.8);
}

TEST_CASE("a handler that neither moves nor waits does not stop the axes") {
  SteppedRun run(
      "VAR n = 0\nWHEN lift_up DO\n  n = n + 1\n  DOUT[1] = ON\n  PRINT n\nENDWHEN\n"
      "lift = ON\nMOVE(100,0,0)");
  const RunResult result = run.run();
  CHECK(result.output == std::vector<std::string>{"1"});
  REQUIRE(result.signals.size() == 2);
  CHECK(result.signals[1].name == "DOUT[1]");
  CHECK(result.signals[1].time < 0.6);
  // 100 mm at 20 mm/s and the stop behind it: 5 + 2.75 s, as without the handler.
  CHECK(result.measured == doctest::Approx(7.75).epsilon(1e-9));
}

TEST_CASE("a handler sees the variables around it, and what it changes stays changed") {
  SteppedRun run(
      "work(3)\n"
      "PROC work(k: INT)\n"
      "  VAR t = \"a\"\n  VAR list: ARRAY[2] OF INT\n  VAR v: VEC = (1mm, 2mm, 3mm)\n"
      "  FOR i = 1 TO 1 DO\n"
      "    WHEN lift_up DO\n"
      "      t = t + \"b\"\n      list[2] = k + i\n      v.y = 7mm\n      STOP\n"
      "    ENDWHEN\n"
      "    lift = ON\n    MOVE(100,0,0)\n"
      "  ENDFOR\n"
      "  WAIT 0s\n"
      "  PRINT t, \" \", list[1], \" \", list[2], \" \", v\n"
      "ENDPROC");
  CHECK(run.run().output == std::vector<std::string>{"ab 0 4 (1mm, 7mm, 3mm)"});
}

TEST_CASE("a handler interrupts a WAIT, whose time goes on behind it") {
  SteppedRun run("WHEN lift_up DO\n  WAIT 1s\nENDWHEN\nlift = ON\nWAIT 2s\nPRINT CLOCK");
  const RunResult result = run.run();
  CHECK(result.measured == doctest::Approx(3).epsilon(0.02));
}

TEST_CASE("an error in a handler is the program's: what was interrupted is dropped") {
  SteppedRun run(
      "TRY\n  WHEN lift_up DO\n    MOVE(0,30,0)\n    RAISE \"no\"\n  ENDWHEN\n  lift = ON\n"
      "  MOVE(100,0,0)\n  PRINT \"never\"\n  MOVE(200,0,0)\n"
      "RESCUE why\n  PRINT why, \" \", HERE.y\n  MOVE BY (0,10,0)\nENDTRY\nPRINT \"on\"");
  const RunResult result = run.run();
  REQUIRE(!run.task.failure());
  CHECK(result.output == std::vector<std::string>{"no 30mm", "on"});
  check_limits(run.rows);
  CHECK(run.rows.back().sample.reference.q[0] == doctest::Approx(0).epsilon(1e-9));
  CHECK(run.rows.back().sample.reference.q[1] == doctest::Approx(0.04));
}

TEST_CASE("an error in a handler that nobody rescues ends the program with its SAFE values") {
  SteppedRun run(
      "SIGNAL lamp = DOUT[1] SAFE ON\nWHEN lift_up DO\n  MOVE(0,30,0)\n  RAISE \"no\"\nENDWHEN\n"
      "lift = ON\nMOVE(100,0,0)\nPRINT \"never\"");
  const RunResult result = run.run();
  REQUIRE(run.task.failure());
  CHECK(run.task.failure()->message == "no");
  CHECK(run.task.failure()->place.line == 4);
  REQUIRE(run.task.failure()->calls.size() == 1);
  CHECK(run.task.failure()->calls[0].by == rob::lang::CallSite::By::When);
  CHECK(run.task.failure()->calls[0].line == 2);
  CHECK(result.output.empty());
  CHECK(result.signals.back().name == "lamp");
  CHECK(run.rows.back().sample.reference.q[1] == doctest::Approx(0.03));
}

TEST_CASE("a WHEN that raises stops a handler where it is") {
  SteppedRun run(
      "WHEN lift_up DO\n  lift = OFF\n  MOVE(100,60,0)\n  PRINT \"never\"\nENDWHEN\n"
      "WHEN lift_down AND CLOCK > 0.2s : RAISE \"down\"\nlift = ON\nMOVE(100,0,0)\nPRINT \"no\"");
  const RunResult result = run.run();
  REQUIRE(run.task.failure());
  CHECK(run.task.failure()->message == "down");
  CHECK(result.output.empty());
  check_limits(run.rows);
  CHECK(run.rows.back().sample.reference.q[1] < 0.03);
  CHECK(result.measured < 3);
}

TEST_CASE("BRAKE behind WHEN drops the rest of the motion: the next one starts from there") {
  SteppedRun run(
      "WHEN lift_up : BRAKE\nlift = ON\nMOVE(100,0,0)\nPRINT \"one\"\nMOVE BY (0,20,0)\n"
      "PRINT \"two\"\nMOVE BY (0,20,0)");
  const RunResult result = run.run();
  CHECK(result.output == std::vector<std::string>{"one", "two"});
  check_limits(run.rows);
  const auto& end = run.rows.back().sample.reference.q;
  CHECK(end[1] == doctest::Approx(0.04));
  CHECK(end[0] < 0.02);  // it had gone for a second
  CHECK(end[0] == doctest::Approx(x_of_line(run.rows, 5)).epsilon(1e-9));
  CHECK(line(result, 3).ended == "brake");
}

TEST_CASE("BRAKE in a handler: the program goes on from where the handler has brought the axes") {
  SteppedRun run(
      "WHEN lift_up DO\n  MOVE(50,50,0)\n  BRAKE\nENDWHEN\nlift = ON\nMOVE(100,0,0)\n"
      "MOVE(x: 60)\nSTOP\nDOUT[1] = ON\nWAIT 0.5s");
  const RunResult result = run.run();
  check_limits(run.rows);
  const auto& end = run.rows.back().sample.reference.q;
  CHECK(end[0] == doctest::Approx(0.06));
  CHECK(end[1] == doctest::Approx(0.05));  // left out: where it was left
  CHECK(result.signals.back().name == "DOUT[1]");
  CHECK(result.dropped_effects == 0);
}

TEST_CASE("BRAKE while a guarded motion runs ends it without a hit") {
  SteppedRun run(
      "WHEN lift_up : BRAKE\nlift = ON\nMOVE(100,0,0) UNTIL DIN[1] ELSE PRINT \"missed\"\n"
      "PRINT HIT\nMOVE BY (0,10,0)");
  const RunResult result = run.run();
  CHECK(result.output == std::vector<std::string>{"missed", "FALSE"});
  CHECK(run.rows.back().sample.reference.q[1] == doctest::Approx(0.01));
}

TEST_CASE("guards are not asked while a handler has the axes") {
  SteppedRun run(
      "WHEN lift_up DO\n  MOVE(0,60,0)\nENDWHEN\nlift = ON\n"
      "MOVE(100,0,0) UNTIL HERE.y > 30mm\nPRINT HIT");
  const RunResult result = run.run();
  CHECK(result.output == std::vector<std::string>{"FALSE"});
  CHECK(run.rows.back().sample.reference.q[0] == doctest::Approx(0.1));
}

TEST_CASE("handlers do not interrupt handlers: the second begins when the first has ended") {
  SteppedRun run(
      "WHEN lift_up DO\n  PRINT \"a1\"\n  MOVE(0,20,0)\n  PRINT \"a2\"\nENDWHEN\n"
      "WHEN lift_up DO\n  PRINT \"b1\"\n  MOVE(0,30,0)\n  PRINT \"b2\"\nENDWHEN\n"
      "lift = ON\nMOVE(100,0,0)\nPRINT \"end\"");
  const RunResult result = run.run();
  CHECK(result.output == std::vector<std::string>{"a1", "a2", "b1", "b2", "end"});
  check_limits(run.rows);
}

TEST_CASE("a handler begins once for each time that its condition comes true") {
  SteppedRun run(
      "VAR n = 0\nWHEN lift_up DO\n  n = n + 1\n  PRINT n\n  lift = OFF\n  WAIT lift_down\n"
      "  lift = ON\n  WAIT 1s\nENDWHEN\nlift = ON\nMOVE(10,0,0)\nSTOP\nlift = OFF\nWAIT 1s\n"
      "lift = ON\nWAIT 1s");
  // It is not asked while it runs: that lift_up goes and comes again in it is not seen.
  CHECK(run.run().output == std::vector<std::string>{"1", "2"});
}

TEST_CASE("a hold while a handler has the axes ends the run where they come to rest") {
  SteppedRun run("WHEN lift_up DO\n  MOVE(0,100,0)\nENDWHEN\nlift = ON\nMOVE(100,0,0)");
  run.each_cycle = [&](double now) {
    if (now > 4) run.controller.request_hold();
  };
  const RunResult result = run.run();
  check_limits(run.rows);
  CHECK(result.measured < 5);
  CHECK(run.rows.back().sample.state == rob::motion::MotionState::Held);
  CHECK(run.rows.back().sample.reference.q[1] > 0.02);
}

TEST_CASE("the ticks of a handler take no memory") {
  SteppedRun run("WHEN CLOCK > 0.5s DO\n  MOVE(0,60,0)\nENDWHEN\nMOVE(100,0,0)\nMOVE(0,0,0)");
  run.controller.servo().enable(0);
  for (int k = 0; k < 2200; ++k) {
    run.task.step(1000);
    rob::test::NoAllocation guard;
    run.controller.motion().cycle(k, 0);
    REQUIRE(guard.count() == 0);
    run.recorder.drain();
  }
  const RunResult result = run.recorder.finish();
  CHECK(result.lines.size() == 5);  // the handler and its way back, two motions, the end
}

TEST_CASE("the same handlers give the same bits") {
  const std::string text =
      "WHEN lift_up DO\n  MOVE(0,60,0)\nENDWHEN\nlift = ON\nMOVE(40,40,0)\nMOVE(140,40,0)";
  SteppedRun first(text);
  SteppedRun second(text);
  first.run();
  second.run();
  REQUIRE(first.rows.size() == second.rows.size());
  for (std::size_t i = 0; i < first.rows.size(); ++i) {
    REQUIRE(first.rows[i].sample.reference.q == second.rows[i].sample.reference.q);
    REQUIRE(first.rows[i].measured == second.rows[i].measured);
  }
}

TEST_CASE("the motions of a handler take the WITH around its WHEN, not that of the program") {
  SteppedRun run(
      "WITH AT 10mm/s DO\nWHEN lift_up DO\nMOVE(0,60,0)\nENDWHEN\nlift = ON\n"
      "WITH AT 5mm/s DO\nMOVE(40,0,0)\nENDWITH\nENDWITH\n");
  run.run();
  const auto top_speed = [&](std::uint32_t number) {
    double top = 0;
    for (const Snapshot& row : run.rows) {
      const auto& qd = row.sample.reference.qd;
      if (row.sample.tag == number) top = std::max(top, std::hypot(qd[0], qd[1]));
    }
    return top;
  };
  CHECK(top_speed(3) == doctest::Approx(0.010).epsilon(1e-6));
  CHECK(top_speed(7) == doctest::Approx(0.005).epsilon(1e-6));
}
