#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

#include "tests/support/stepped_run.h"

using rob::runtime::RunResult;
using rob::runtime::Snapshot;
using rob::test::line;
using rob::test::SteppedRun;

// The lift of the gantry takes 0.5 s: lift_up comes 0.5 s behind lift = ON. Its axes move at 20
// mm/s, with 100 mm/s² and 1000 mm/s³ at most.

namespace {

constexpr double kAheadPeriod = 0.01;  // s
constexpr double kAheadSpeed = 0.02;   // m/s
constexpr double kAheadAccel = 0.1;    // m/s²
constexpr double kAheadJerk = 1;       // m/s³

SteppedRun looking_ahead(const std::string& text) { return SteppedRun("LAW LOOKAHEAD\n" + text); }

/// No reference leaves what the axes can do, however the path was left and found again.
void check_ahead_limits(const std::vector<Snapshot>& rows) {
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const auto& before = rows[i - 1].sample.reference;
    const auto& now = rows[i].sample.reference;
    for (int axis = 0; axis < 2; ++axis) {
      REQUIRE(std::abs(now.q[axis] - before.q[axis]) <= kAheadSpeed * kAheadPeriod * (1 + 1e-6));
      REQUIRE(std::abs(now.qd[axis] - before.qd[axis]) <= kAheadAccel * kAheadPeriod * (1 + 1e-6));
      REQUIRE(std::abs(now.qdd[axis] - before.qdd[axis]) <= kAheadJerk * kAheadPeriod * (1 + 1e-6));
    }
  }
}

}  // namespace

TEST_CASE("looking ahead, a handler has the axes at rest, brings them back, and the path goes on") {
  SteppedRun run = looking_ahead(
      "WHEN lift_up DO\n  PRINT \"up\"\n  MOVE(0,60,0)\n  PRINT \"there\"\nENDWHEN\n"
      "lift = ON\nMOVE(100,0,0)\nMOVE(100,50,0)\nPRINT \"end\"");
  const RunResult result = run.run();
  CHECK(result.output == std::vector<std::string>{"up", "there", "end"});
  check_ahead_limits(run.rows);
  double left = -1, found = -1;
  bool on_its_way = true;
  for (const Snapshot& row : run.rows) {
    const auto& q = row.sample.reference.q;
    if (row.sample.tag != 8) {
      on_its_way = false;
      continue;
    }
    if (on_its_way) left = q[0];
    if (!on_its_way && found < 0) {
      found = q[0];
      CHECK(row.sample.reference.qd.norm() == 0);
    }
  }
  CHECK(left > 0.001);
  CHECK(found == doctest::Approx(left).epsilon(1e-9));
  CHECK(run.rows.back().sample.reference.q[0] == doctest::Approx(0.1));
  CHECK(run.rows.back().sample.reference.q[1] == doctest::Approx(0.05));
  CHECK(line(result, 8).ended == "reached");
}

TEST_CASE("looking ahead, a handler that does not move leaves path and corners as they were") {
  const std::string triangle =
      "lift = ON\nMOVE(40,40,0)\nMOVE(140,40,0)\nMOVE(90,126,0)\nMOVE(40,40,0)\n";
  SteppedRun plain = looking_ahead("\n" + triangle);
  const RunResult without = plain.run();
  SteppedRun run = looking_ahead("WHEN lift_up DO\n  WAIT 1s\nENDWHEN\n" + triangle);
  const RunResult with = run.run();
  check_ahead_limits(run.rows);
  for (int number = 3; number <= 5; ++number) {
    CHECK(*line(with, number + 3).miss_measured ==
          doctest::Approx(*line(without, number + 1).miss_measured).epsilon(0.02));
  }
  // The second of the WAIT, and the stop: v/a + T_w = 0.4 s, half of it on the way.
  CHECK(with.measured > without.measured + 1);
  CHECK(with.measured < without.measured + 1 + 0.6);
}

TEST_CASE("looking ahead, BRAKE in a handler: what is queued starts from where the axes are") {
  for (const char* there : {"MOVE(50,50,0)\n  ", "JOG WORLD (y: 10mm/s) FOR 5s\n  ", ""}) {
    CAPTURE(there);
    SteppedRun run = looking_ahead("WHEN lift_up DO\n  " + std::string(there) +
                                   "BRAKE\nENDWHEN\nlift = ON\nMOVE(100,0,0) ZONE 5mm\n"
                                   "MOVE(x: 60)\nSTOP\nDOUT[1] = ON\nMOVE(x: 10)\nWAIT 0.5s");
    const RunResult result = run.run();
    check_ahead_limits(run.rows);
    const auto& end = run.rows.back().sample.reference.q;
    CHECK(end[0] == doctest::Approx(0.01));
    CHECK(end[1] == doctest::Approx(*there != 0 ? 0.05 : 0).epsilon(0.01));  // where it was left
    CHECK(result.signals.back().name == "DOUT[1]");
    CHECK(result.dropped_effects == 0);
    double farthest = 0;
    for (const Snapshot& row : run.rows) farthest = std::max(farthest, row.sample.reference.q[0]);
    CHECK(farthest < 0.061);  // the motion to 100 has ended early
  }
}

TEST_CASE("looking ahead, an error in a handler drops all that it has interrupted") {
  SteppedRun run = looking_ahead(
      "TRY\n  WHEN lift_up DO\n    MOVE(0,30,0)\n    RAISE \"no\"\n  ENDWHEN\n  lift = ON\n"
      "  MOVE(100,0,0)\n  PRINT \"never\"\n  MOVE(200,0,0)\n"
      "RESCUE why\n  PRINT why, \" \", HERE.y\n  MOVE BY (0,10,0)\nENDTRY\nPRINT \"on\"");
  const RunResult result = run.run();
  REQUIRE(!run.task.failure());
  CHECK(result.output == std::vector<std::string>{"no 30mm", "on"});
  check_ahead_limits(run.rows);
  CHECK(run.rows.back().sample.reference.q[0] == doctest::Approx(0).epsilon(1e-9));
  CHECK(run.rows.back().sample.reference.q[1] == doctest::Approx(0.04));
}
