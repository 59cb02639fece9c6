#include <doctest/doctest.h>

#include "motion/robots/robot_library.h"
#include "runtime/run/foretell.h"
#include "runtime/run/load.h"

namespace {

rob::runtime::RunResult foretold_zones(const std::string& text, int look_ahead = 0) {
  rob::motion::RobotModel robot = rob::motion::embedded_robot("gantry");
  if (look_ahead > 0) robot.look_ahead = look_ahead;
  const auto program = rob::runtime::compile_program("test.rob", text, robot);
  REQUIRE(program.runnable());
  return rob::runtime::foretell(program, robot);
}

}  // namespace

TEST_CASE("FINE costs its own line one segment of no length, and a STOP behind it nothing") {
  const auto result = foretold_zones("MOVE(100,0,0) FINE\nSTOP\nMOVE(100,100,0)\n");
  REQUIRE(result.lines.size() == 3);
  CHECK(result.lines[0].count == 1);
  CHECK(result.lines[0].planned == doctest::Approx(5 + 2.75));  // 100 mm at 20 mm/s, 2·t_acc
  CHECK(result.lines[0].exact);
  CHECK(result.lines[0].decides.value() == doctest::Approx(7.75));
  CHECK(*result.lines[0].miss_planned == doctest::Approx(0));
  CHECK(result.lines[1].line == 3);
}

TEST_CASE("an exact motion waits until the buffer has room for both of its segments") {
  const std::string text = "FOR i = 1 TO 4 DO\nMOVE BY (20, 0, 0) FINE\nENDFOR\n";
  for (const int look_ahead : {2, 3, 64}) {
    CAPTURE(look_ahead);
    const auto result = foretold_zones(text, look_ahead);
    CHECK(result.planned == doctest::Approx(4 * 2 * 2.75));
    CHECK(result.measured == doctest::Approx(4 * 2 * 2.75));
    CHECK(result.lines[0].count == 4);
    CHECK(result.starved == 0);
    CHECK(result.final_joints[0] == doctest::Approx(80));
  }
}

TEST_CASE("a line with a ZONE of its own owns the time to its earlier decision instant") {
  const auto result = foretold_zones("MOVE(100,0,0) ZONE 0.5s\nMOVE(100,100,0)\n");
  // t from -1.375 s to 5 s - 0.5 s, then from -0.5 s to 5 s - 1.375 s.
  CHECK(result.lines[0].planned == doctest::Approx(5.875));
  CHECK(result.lines[0].decides.value() == doctest::Approx(5.875));
  CHECK(result.lines[1].starts == doctest::Approx(5.875));
  CHECK(result.planned == doctest::Approx(result.measured));
  CHECK(result.planned == doctest::Approx(5.875 + 4.125 + 2.75));
  // 3/16·t_acc·|v2 − v1| = 3/16·0.5 s·20√2 mm/s = 2.65 mm in its middle, a little less at its
  // nearest.
  CHECK(*result.lines[0].miss_planned <= 2.652);
  CHECK(*result.lines[0].miss_planned > 2.6);
}

TEST_CASE("a ZONE that is too tight is widened, with a warning of what it becomes") {
  const auto result = foretold_zones("MOVE(100,0,0) ZONE 1ms\nMOVE(100,100,0)\n");
  REQUIRE(result.findings.size() == 1);
  CHECK(result.findings[0].code == "W640");
  CHECK(result.findings[0].message.find("it becomes ZONE 0.38") != std::string::npos);
}

TEST_CASE("a ZONE length is kept by the corner that follows it") {
  for (const int zone_mm : {5, 8, 12}) {
    const std::string zone = std::to_string(zone_mm);
    const auto result = foretold_zones("MOVE(100,0,0) ZONE " + zone + "mm\nMOVE(0,0,0) ZONE " +
                                       zone + "mm\nMOVE(0,9,0)");
    CHECK(*result.lines[0].miss_planned <= zone_mm);
    CHECK(*result.lines[1].miss_planned <= zone_mm);
  }
}
