#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "tests/support/stepped_run.h"

using rob::motion::MotionState;
using rob::runtime::RunResult;
using rob::runtime::Snapshot;
using rob::test::line;
using rob::test::SteppedRun;

namespace {

double least_x_rate(const SteppedRun& run, double from, double to) {
  double least = 1;
  for (const Snapshot& row : run.rows) {
    const auto& reference = row.sample.reference;
    if (reference.time >= from && reference.time <= to) least = std::min(least, reference.qd[0]);
  }
  return 1000 * least;
}

}  // namespace

TEST_CASE("what is commanded behind a JOG starts where it has come to rest") {
  SteppedRun run(
      "JOG WORLD (x: 10mm/s) FOR 2s\n"
      "PRINT ROUND(TARGET.x, 0.001mm)\n"
      "MOVE BY (10mm, 0mm, 0deg)\n");
  const RunResult result = run.run();
  CHECK(result.status == "done");
  REQUIRE(result.output.size() == 1);
  CHECK(result.output[0] == "20mm");
  CHECK(result.final_joints[0] == doctest::Approx(30).epsilon(1e-6));
  CHECK(line(result, 1).ended == "reached");
  CHECK(!line(result, 1).miss_planned);
  CHECK(result.deviation < 1e-6);
  CHECK(run.rows[100].sample.state == MotionState::Jogging);
}

TEST_CASE("a loop of JOGs of 20 ms that reads the world each time keeps its speed") {
  SteppedRun run(
      "WHILE HERE.x < 40mm DO\n"
      "  JOG WORLD (x: 10mm/s) FOR 20ms\n"
      "ENDWHILE\n");
  const RunResult result = run.run();
  CHECK(result.status == "done");
  CHECK(result.starved == 0);
  CHECK(least_x_rate(run, 0.3, 3.9) == doctest::Approx(10).epsilon(1e-9));
  // 0.1 s behind a constant rate from the start; and at its decision point it sees 40 mm.
  CHECK(line(result, 2).count >= 204);
  CHECK(line(result, 2).count <= 207);
}

TEST_CASE("rates computed from readings follow them") {
  SteppedRun run(
      "WHILE HERE.x < 39mm DO\n"
      "  JOG WORLD (x: CLAMP((40mm - HERE.x) / 1s, 0.5mm/s, 15mm/s)) FOR 20ms\n"
      "ENDWHILE\n");
  const RunResult result = run.run();
  CHECK(result.status == "done");
  // x' = (40 mm − x)/1 s falls to 1 mm/s at 39 mm; it is slowed down from there.
  CHECK(result.final_joints[0] > 39);
  CHECK(result.final_joints[0] < 39.2);
  CHECK(least_x_rate(run, 0.4, 3) > 0.5);
}

TEST_CASE("JOG UNTIL ends by its condition; HITPOSE and TARGET say where") {
  SteppedRun run(
      "lift = ON\n"
      "JOG WORLD (x: 10mm/s) UNTIL lift_up\n"
      "PRINT HIT, HITPOSE.x < TARGET.x\n"
      "JOG WORLD (x: 10mm/s) FOR 0.5s UNTIL gripper_closed ELSE PRINT \"not closed\"\n"
      "PRINT HIT\n");
  const RunResult result = run.run();
  REQUIRE(result.output.size() == 3);
  CHECK(result.output[0] == "TRUETRUE");
  CHECK(result.output[1] == "not closed");
  CHECK(result.output[2] == "FALSE");
  CHECK(line(result, 2).ended == "hit");
  // The lift takes 0.5 s; slowing down 0.2 s.
  CHECK(line(result, 2).measured == doctest::Approx(0.72).epsilon(0.05));
}

TEST_CASE("a condition that holds lets no jog begin") {
  SteppedRun run("JOG WORLD (x: 10mm/s) UNTIL lift_down\nPRINT HIT");
  const RunResult result = run.run();
  REQUIRE(result.output.size() == 1);
  CHECK(result.output[0] == "TRUE");
  for (const auto& row : run.rows) CHECK(row.sample.reference.q[0] == 0);
}

TEST_CASE("an output between two jogs acts where they join, one behind the last at rest") {
  SteppedRun run(
      "JOG WORLD (x: 10mm/s) FOR 1s\n"
      "lift = ON\n"
      "JOG WORLD (x: 15mm/s) FOR 1s\n"
      "gripper = ON\n");
  const RunResult result = run.run();
  REQUIRE(result.signals.size() == 2);
  CHECK(result.signals[0].time == doctest::Approx(1.01).epsilon(1e-9));  // in the next cycle
  CHECK(result.signals[1].time > 2.2);
  CHECK(result.signals[1].time < 2.4);
  CHECK(least_x_rate(run, 0.4, 1.9) > 9.999);
}

TEST_CASE("jogs of other rates join, jogs of another frame begin at rest") {
  SteppedRun joined("JOG WORLD (x: 10mm/s) FOR 1s\nJOG WORLD (x: 10mm/s, y: 10mm/s) FOR 1s\n");
  joined.run();
  CHECK(least_x_rate(joined, 0.4, 1.9) == doctest::Approx(10).epsilon(1e-9));
  SteppedRun apart("JOG WORLD (x: 10mm/s) FOR 1s\nJOG TOOL (x: 10mm/s) FOR 1s\n");
  const RunResult result = apart.run();
  CHECK(least_x_rate(apart, 0.4, 1.9) == 0);
  CHECK(result.final_joints[0] == doctest::Approx(20).epsilon(1e-6));
}

TEST_CASE("BRAKE ends a jog, WHEN interrupts one, a handler comes back to it") {
  SteppedRun braked("JOG WORLD (x: 10mm/s) FOR 5s\nBRAKE\nPRINT TARGET.x < 1mm\n");
  CHECK(braked.run().output.at(0) == "TRUE");

  SteppedRun raised(
      "TRY\n"
      "  WHEN lift_up : RAISE \"up\"\n"
      "  lift = ON\n"
      "  JOG WORLD (x: 10mm/s) FOR 5s\n"
      "  JOG WORLD (y: 10mm/s) FOR 5s\n"
      "RESCUE why\n"
      "  PRINT why, \" \", TARGET.x < 7mm\n"
      "  MOVE(10, 10, 0)\n"
      "ENDTRY\n");
  const RunResult result = raised.run();
  CHECK(result.status == "done");
  CHECK(result.output.at(0) == "up TRUE");
  CHECK(result.final_joints[1] == doctest::Approx(10).epsilon(1e-6));

  SteppedRun handled(
      "WHEN lift_up DO\n"
      "  lift = OFF\n"
      "  JOG WORLD (y: 10mm/s) FOR 1s\n"
      "ENDWHEN\n"
      "lift = ON\n"
      "JOG WORLD (x: 10mm/s) FOR 2s\n");
  const RunResult back = handled.run();
  CHECK(back.status == "done");
  CHECK(back.final_joints[0] == doctest::Approx(20).epsilon(1e-6));
  CHECK(std::abs(back.final_joints[1]) < 1e-6);
  double most_y = 0;
  for (const auto& row : handled.rows) most_y = std::max(most_y, row.sample.reference.q[1]);
  CHECK(most_y == doctest::Approx(0.01).epsilon(1e-6));
}

TEST_CASE("a handler that brakes ends the jog, and the next one begins anew") {
  SteppedRun run(
      "WHEN lift_up DO\n"
      "  lift = OFF\n"
      "  BRAKE\n"
      "ENDWHEN\n"
      "lift = ON\n"
      "JOG WORLD (x: 10mm/s) FOR 60s\n"
      "JOG WORLD (y: 10mm/s) FOR 1s\n");
  const RunResult result = run.run();
  CHECK(result.status == "done");
  CHECK(result.final_joints[0] < 10);
  CHECK(result.final_joints[1] == doctest::Approx(10).epsilon(1e-6));
}

TEST_CASE("an error behind a jog takes effect when it has come to rest") {
  SteppedRun run(
      "JOG WORLD (x: 10mm/s) FOR 1s\nTRY\n  RAISE \"no\"\nRESCUE why\n  PRINT why, ROUND(TARGET.x, "
      "0.001mm)\nENDTRY\nMOVE(20, 0, 0)\n");
  const RunResult result = run.run();
  CHECK(result.output.at(0) == "no10mm");
  CHECK(result.final_joints[0] == doctest::Approx(20).epsilon(1e-6));
}

TEST_CASE("a share above 100% that is computed takes no more of a jog than 100%") {
  const auto rows = [](const char* share) {
    SteppedRun run(std::string("VAR share = ") + share +
                   "\nJOG JOINT (60mm/s, 0mm/s, 0deg/s) AT share FOR 2s\n");
    CHECK(run.run().status == "done");
    return run.rows;
  };
  const auto most = rows("100%");
  const auto more = rows("300%");
  REQUIRE(more.size() == most.size());
  const bool same = std::ranges::equal(more, most, [](const Snapshot& a, const Snapshot& b) {
    return a.sample.reference.q == b.sample.reference.q;
  });
  CHECK(same);
  CHECK(most[150].sample.reference.qd[0] == doctest::Approx(0.02));  // m/s: v_max of the axis
}

TEST_CASE("a jog that goes no further is an event, not an error") {
  SteppedRun run("JOG WORLD (x: -10mm/s) FOR 1s\nMOVE(10, 0, 0)\n");
  const RunResult result = run.run();
  CHECK(result.status == "done");
  REQUIRE(result.events.size() == 1);
  CHECK(result.events[0].kind == "limit");
  CHECK(result.events[0].line == 1);
  CHECK(result.events[0].text.find("axis x") != std::string::npos);
}

TEST_CASE("a JOG without FOR is over where it goes no further, and its condition has not held") {
  SteppedRun run("JOG WORLD (x: -10mm/s) UNTIL lift_up ELSE PRINT \"at the end\"\nPRINT HIT\n");
  const RunResult result = run.run(10);
  CHECK(result.status == "done");
  REQUIRE(result.output.size() == 2);
  CHECK(result.output[0] == "at the end");
  CHECK(result.output[1] == "FALSE");
}

TEST_CASE("a hold stops a jog for good, and the run ends there") {
  SteppedRun run("JOG WORLD (x: 10mm/s) FOR 60s\n");
  run.each_cycle = [&](double time) {
    if (time > 1) run.controller.request_hold();
  };
  const RunResult result = run.run();
  CHECK(result.measured > 1.1);
  CHECK(result.measured < 1.5);
  CHECK(run.rows.back().sample.state == MotionState::Held);
  CHECK(run.rows.back().sample.reference.qd[0] == 0);
}
