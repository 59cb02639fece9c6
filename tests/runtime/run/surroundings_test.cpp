#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "motion/generate/stop_ramp.h"
#include "runtime/run/foretell.h"
#include "tests/support/degrees.h"
#include "tests/support/stepped_run.h"

using rob::runtime::RunResult;
using rob::test::kDegree;
using rob::test::SteppedRun;

namespace {

constexpr double kSame = 1e-9;  // m, rad: rounding of a few rotations

const char* const kFrames =
    "FRAME pallet = POSE(200mm, 100mm, 0mm, 0deg, 0deg, 90deg)\n"
    "FRAME raised = POSE(0mm, 0mm, 50mm)\n"
    "TOOL pen = POSE(30mm, 0mm, 0mm, 0deg, 0deg, 90deg)\n"
    "TOOL cup = POSE(0mm, 0mm, 120mm) MASS 0.8kg\n";

/// Where the axes stand at the end, in mm and deg.
void ends_at(const std::string& motions, double x, double y, double theta) {
  CAPTURE(motions);
  SteppedRun run(kFrames + motions);
  run.run();
  REQUIRE_FALSE(run.task.failure().has_value());
  const auto& q = run.rows.back().sample.reference.q;
  CHECK(std::abs(q[0] - x / 1000) < kSame);
  CHECK(std::abs(q[1] - y / 1000) < kSame);
  CHECK(std::abs(q[2] - theta * kDegree) < kSame);
}

std::string why(const std::string& motions) {
  SteppedRun run(kFrames + motions);
  run.run();
  REQUIRE(run.task.failure().has_value());
  return run.task.failure()->message;
}

RunResult foretold_gantry(const std::string& text) {
  const auto robot = rob::motion::embedded_robot("gantry");
  const auto program = rob::runtime::compile_program("test.rob", kFrames + text, robot);
  REQUIRE(program.runnable());
  return rob::runtime::foretell(program, robot);
}

}  // namespace

// pallet: its x runs along the world's y, its y against the world's x, from (200, 100) on.
TEST_CASE("IN takes tuples, BY and free poses from the frame to the axes") {
  ends_at("MOVE(10, 20, 0) IN pallet\n", 200 - 20, 100 + 10, 90);
  ends_at("MOVE(10, 20, 0) IN pallet\nMOVE(x: 30) IN pallet\n", 180, 130, 90);
  ends_at("MOVE(150, 50, 0)\nMOVE BY (5, 7, 10) IN pallet\n", 150 - 7, 50 + 5, 10);
  ends_at("VAR v = (5mm, 7mm, 0mm)\nMOVE(150, 50, 0)\nMOVEL BY v IN pallet\n", 143, 55, 0);
  ends_at("MOVE POSE(10mm, 20mm, 0mm) IN pallet\n", 180, 110, 90);
  ends_at("WITH IN pallet DO\nMOVE(10, 20, 0)\nMOVE(x: 30)\nENDWITH\nMOVE BY (1, 2, 0)\n", 181, 132,
          90);
}

TEST_CASE("IN TOOL counts along the axes of the tool") {
  ends_at("MOVE(150, 50, 90)\nMOVE BY (5, 1, 0) IN TOOL\n", 150 - 1, 50 + 5, 90);
  ends_at("MOVE(150, 50, 90)\nMOVE(2, 0, 10) IN TOOL\n", 150, 52, 100);
}

TEST_CASE("what a frame does not say of the plane is kept") {
  ends_at("MOVE(10, 20, 30) IN raised\n", 10, 20, 30);
  CHECK(why("VAR p: POSE IN raised = POSE(10mm, 20mm, 0mm)\nVAR n = 1\nMOVE p\n")
            .find("cannot bring its tool to POSE(10mm, 20mm, 50mm") != std::string::npos);
}

TEST_CASE("a tuple turns as far as it says, in a frame and with a tool too") {
  ends_at("MOVE(10, 10, 170)\nMOVE BY (0, 0, -300) IN pallet\n", 10, 10, -130);
  ends_at("MOVE(10, 10, -90)\nMOVE(0, 0, 0) IN pallet WITH pen\n", 170, 100, 0);
}

// pen: its tip is 30 mm off the flange along the flange's x, turned by 90 deg.
TEST_CASE("WITH brings the tip of the tool to the target") {
  ends_at("MOVE(100, 50, 90) WITH pen\n", 100 - 30, 50, 0);
  ends_at("MOVE(100, 50, 180) WITH pen\n", 100, 50 - 30, 90);
  ends_at("MOVE(100, 50, 90) WITH pen IN world\nMOVE(x: 110) WITH pen\n", 80, 50, 0);
  ends_at("MOVE(0, 0, 180) WITH pen IN pallet\n", 200 + 30, 100, 180);
  ends_at("MOVE(100, 50, 0) WITH cup\n", 100, 50, 0);  // the tip stays 120 mm above the plane
  ends_at("MOVE(100, 50, 0) FINE\nWITH pen DO\nVAR p = HERE\nMOVE p + (10mm, 0mm, 0mm)\nENDWITH\n",
          110, 50, 0);
  ends_at(
      "MOVE(100, 50, 0)\nWITH pen DO\nVAR p = TARGET\nMOVE p * (POSE(0mm, 5mm, 0mm))\nENDWITH\n",
      95, 50, 0);
}

TEST_CASE("WITH and IN are restored when an error leaves their block") {
  ends_at("TRY\nWITH pen IN pallet DO\nMOVE(x: 9999)\nENDWITH\nRESCUE\nENDTRY\nMOVE(10, 20, 30)\n",
          10, 20, 30);
}

TEST_CASE("MOVEL with a tool off the axis that turns leads its tip straight") {
  SteppedRun run(kFrames + std::string("MOVEL(100, 50, 170) WITH pen\n"));
  run.run();
  REQUIRE_FALSE(run.task.failure().has_value());
  for (const auto& row : run.rows) {
    // The tip, 30 mm ahead of the flange, from (30, 0) to (100, 50).
    const auto& q = row.sample.reference.q;
    const double x = q[0] + 0.03 * std::cos(q[2]);
    const double y = q[1] + 0.03 * std::sin(q[2]);
    REQUIRE(std::abs((x - 0.03) * 50 - y * 70) < 1e-6 * 86);
  }
  ends_at("MOVE(100, 50, 90) WITH pen\nMOVEL(120, 60, 90) WITH pen\n", 90, 60, 0);
}

TEST_CASE("rule 18: a change of the tool in a corner makes it exact, with a warning") {
  const auto jumps = [](const RunResult& result) {
    return std::ranges::count_if(result.findings,
                                 [](const auto& finding) { return finding.code == "W511"; });
  };
  // 100 mm at 20 mm/s, 2·t_acc to be exact; then 70 mm, since the tip is 30 mm ahead, and the same.
  const RunResult changed = foretold_gantry("MOVE(100, 0, 0)\nMOVE(200, 0, 90) WITH pen\n");
  CHECK(jumps(changed) == 1);
  CHECK(rob::test::line(changed, 6).count == 1);
  CHECK(changed.measured == doctest::Approx(5 + 2.75 + 3.5 + 2.75));
  CHECK(jumps(foretold_gantry("MOVE(100, 0, 0) FINE\nMOVE(200, 0, 90) WITH pen\n")) == 0);
  CHECK(jumps(foretold_gantry("MOVE(100, 0, 0)\nMOVE(200, 0, 0) IN raised\n")) == 0);
}

// Turning back misses the angle by 3/8·t_acc·v (docs/motion.md); the tip lies 30 mm off the axis.
TEST_CASE("the miss of a corner is that of the tip") {
  const std::string turns = "MOVE JOINT 3 TO 90deg WITH pen\nMOVE JOINT 3 TO 0deg WITH pen\n";
  const double missed = 3.0 / 8 * 1.375 * 20 * kDegree;
  const double chord = 2 * 30 * std::sin(missed / 2);  // mm
  const RunResult result = SteppedRun(kFrames + turns).run();
  REQUIRE(result.lines.size() >= 2);
  CHECK(result.lines[0].miss_planned.value() == doctest::Approx(chord));
  CHECK(std::abs(result.lines[0].miss_measured.value() - chord) < 0.05);
  CHECK(result.lines[0].way == doctest::Approx(30 * (90 - 20 * 1.375) * kDegree).epsilon(1e-3));
  CHECK(result.deviation == doctest::Approx(chord));
  const RunResult flange = SteppedRun("MOVE JOINT 3 TO 90deg\nMOVE JOINT 3 TO 0deg\n").run();
  CHECK(flange.lines[0].miss_planned.value() < 1e-9);
}

TEST_CASE("AT bounds the speed of the tip") {
  // A quarter turn takes a tip that is 30 mm off the axis 30·√2 mm further, as the crow flies.
  const RunResult turned = foretold_gantry("MOVE JOINT 3 TO 90deg WITH pen AT 4mm/s\n");
  CHECK(turned.measured == doctest::Approx(30 * std::numbers::sqrt2 / 4 + 2.75));
  CHECK(foretold_gantry("MOVE JOINT 3 TO 90deg AT 4mm/s\n").measured ==
        doctest::Approx(90 / 20.0 + 2.75));
}

TEST_CASE("OVERRIDE at standstill stretches what follows, and not a WAIT") {
  const std::string text = "MOVE(100,0,0)\nWAIT 1s\nOVERRIDE 50%\nWAIT 1s\nMOVE(0,0,0)\n";
  const RunResult result = foretold_gantry(text);
  // 5 s and 2.75 s to be exact, two WAITs, then the same at half speed.
  CHECK(result.measured == doctest::Approx(7.75 + 2 + 2 * 7.75));
  CHECK(result.planned == doctest::Approx(7.75 + 2 + 2 * 7.75));
  SteppedRun slow(text, nullptr, 0.5);  // --override 50%: a quarter in all
  CHECK(slow.run().measured == doctest::Approx(2 * 7.75 + 2 + 4 * 7.75));
}

TEST_CASE("OVERRIDE before the first motion, or behind a STOP, holds for all of the next one") {
  CHECK(foretold_gantry("OVERRIDE 50%\nMOVE(100,0,0)\n").measured == doctest::Approx(2 * 7.75));
  CHECK(foretold_gantry("MOVE(100,0,0)\nSTOP\nOVERRIDE 25%\nMOVE(0,0,0)\n").measured ==
        doctest::Approx(7.75 + 4 * 7.75));
}

TEST_CASE("OVERRIDE in a corner scales time from the middle of the corner on") {
  SteppedRun run("MOVE(100,0,0)\nOVERRIDE 50%\nMOVE(200,0,0)\n");
  const RunResult result = run.run();
  // The first target would have been reached at 5 s + t_acc = 6.375 s; it acts in the cycle of
  // 6.38 s. 12.75 s of path are there in all; the ramp to one half takes its share of the rest.
  rob::motion::StopRamp ramp(rob::motion::time_scale_limits(run.robot));
  ramp.aim(0.5);
  const double ramping = ramp.remaining();
  const double gained = ramp.advance(ramping);
  const double rest = 12.75 - 6.38;
  CHECK(result.measured == doctest::Approx(6.38 + ramping + (rest - gained) / 0.5));
  CHECK(result.planned == doctest::Approx(6.38 + rest / 0.5));
  CHECK(run.rows.back().override_share == 0.5);
  CHECK(std::abs(run.rows.back().sample.reference.q[0] - 0.2) < kSame);
}

TEST_CASE("OVERRIDE above 100 % raises AT from the next motion on, never an axis' maximum") {
  CHECK(foretold_gantry("OVERRIDE 200%\nMOVE(100,0,0) AT 10mm/s\n").measured ==
        doctest::Approx(7.75));
  CHECK(foretold_gantry("OVERRIDE 200%\nMOVE(100,0,0)\n").measured == doctest::Approx(7.75));
  CHECK(
      foretold_gantry("OVERRIDE 200%\nMOVE(100,0,0)\nSTOP\nOVERRIDE 100%\nMOVE(0,0,0) AT 10mm/s\n")
          .measured == doctest::Approx(7.75 + 12.75));
}
