#include <doctest/doctest.h>

#include <cmath>

#include "tests/support/stepped_run.h"

using rob::runtime::RunResult;
using rob::runtime::SignalChange;
using rob::test::SteppedRun;

// 20 mm/s; t_acc = 1.375 s. From rest the tool covers 20·1.375·(2h³ − h⁴) mm up to
// t = (2h − 1)·1.375 s, and t = 0 lies 1.375 s behind the start.

namespace {

double switched(const RunResult& result, const std::string& name) {
  for (const SignalChange& change : result.signals)
    if (change.name == name) return change.time;
  return -1;
}

}  // namespace

TEST_CASE("a path event of a straight piece comes when its place is passed") {
  SteppedRun run(
      "MOVE(0,0,0)\nMOVE(100,0,0) DO\n  AFTER 40mm : DOUT[1] = ON\n  BEFORE 40mm : DOUT[2] = ON\n"
      "  AFTER 40mm LEAD 15ms : DOUT[3] = ON\n  AFTER 40mm LAG 15ms : DOUT[4] = ON\nENDMOVE");
  const RunResult result = run.run();
  const double start = result.lines[1].starts + 1.375;  // t = 0 of the motion
  CHECK(switched(result, "DOUT[1]") == doctest::Approx(start + 2).epsilon(1e-9));
  CHECK(switched(result, "DOUT[2]") == doctest::Approx(start + 3).epsilon(1e-9));
  CHECK(switched(result, "DOUT[3]") == doctest::Approx(start + 1.985).epsilon(1e-9));
  CHECK(switched(result, "DOUT[4]") == doctest::Approx(start + 2.015).epsilon(1e-9));
  CHECK(result.dropped_effects == 0);
}

TEST_CASE("from rest and to rest the place itself is passed") {
  SteppedRun run(
      "MOVE(100,0,0) DO\n  AFTER 5mm : DOUT[1] = ON\n  BEFORE 5mm : DOUT[2] = ON\nENDMOVE\nSTOP");
  const RunResult result = run.run();
  const auto x_at = [&](double time) {
    const auto k = static_cast<std::size_t>(std::floor(time / 0.01));
    const auto& a = run.rows[k].sample.reference;
    return 1000 * (a.q[0] + a.qd[0] * (time - a.time));
  };
  CHECK(x_at(switched(result, "DOUT[1]")) == doctest::Approx(5).epsilon(1e-3));
  CHECK(x_at(switched(result, "DOUT[2]")) == doctest::Approx(95).epsilon(1e-4));
}

TEST_CASE("the ends of a blended leg are the middles of its corners") {
  SteppedRun run(
      "MOVE(100,0,0)\nMOVE(100,100,0) DO\n  AFTER 0mm : DOUT[1] = ON\n  BEFORE 0mm : DOUT[2] = ON\n"
      "ENDMOVE\nMOVE(0,100,0)");
  const RunResult result = run.run();
  CHECK(switched(result, "DOUT[1]") == doctest::Approx(6.375).epsilon(1e-9));
  CHECK(switched(result, "DOUT[2]") == doctest::Approx(11.375).epsilon(1e-9));
}

TEST_CASE("a place beyond the motion is refused before it moves") {
  SteppedRun run("VAR d = 60mm\nMOVE(50,0,0) DO\n  AFTER d : lift = ON\nENDMOVE");
  const RunResult result = run.run();
  REQUIRE(run.task.failure());
  CHECK(run.task.failure()->code == "E530");
  CHECK(run.task.failure()->message == "60 mm is beyond this motion, whose way is 50 mm long");
  CHECK(result.final_joints[0] == 0);
}

TEST_CASE("under an override places stay where they are and LEAD stays a time") {
  SteppedRun run(
      "MOVE(0,0,0)\nMOVE(100,0,0) DO\n  AFTER 40mm : DOUT[1] = ON\n"
      "  AFTER 40mm LEAD 15ms : DOUT[3] = ON\nENDMOVE",
      nullptr, 0.5);
  const RunResult result = run.run();
  const double start = result.lines[1].starts + 2 * 1.375;
  CHECK(switched(result, "DOUT[1]") == doctest::Approx(start + 4).epsilon(1e-9));
  CHECK(switched(result, "DOUT[3]") == doctest::Approx(start + 3.985).epsilon(1e-9));
}

TEST_CASE("path events behind the place where a motion ended early are dropped") {
  SteppedRun run(
      "lift = ON\nMOVE(100,0,0) UNTIL lift_up DO\n  AFTER 90mm : DOUT[1] = ON\nENDMOVE\nSTOP");
  const RunResult result = run.run();
  CHECK(switched(result, "DOUT[1]") == -1);
  CHECK(result.dropped_effects == 1);
}
