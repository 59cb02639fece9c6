// Motions along paths of the tool, from outside.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "tests/support/rob_command.h"

using nlohmann::json;
using rob::test::contains;
using rob::test::ProcessResult;
using rob::test::RobCommand;

namespace {

const std::string kIrb120 = "ROBOT \"irb120\"\n";

json run_arm(const std::string& text) {
  return json::parse(RobCommand(kIrb120 + text)("run", {"--fast", "--json"}).out);
}

/// check and run refuse the motion of line 3 alike, with all of `parts`.
void refuses_path(const std::string& program, const std::vector<std::string>& parts) {
  const RobCommand rob(program);
  for (const char* const command : {"check", "run"}) {
    CAPTURE(program);
    CAPTURE(command);
    const ProcessResult result =
        rob(command, std::string(command) == "run" ? std::vector<std::string>{"--fast"}
                                                   : std::vector<std::string>{});
    CHECK(result.exit_code != 0);
    CHECK(contains(result.err, "test.rob:3:1: error["));
    for (const std::string& part : parts) CHECK_MESSAGE(contains(result.err, part), result.err);
  }
}

}  // namespace

TEST_CASE("faults 8 to 10: a line that cannot be gone is refused with axis, place and remedy") {
  // 655 mm from axis 2 to the wrist, 75 mm behind the flange, from 600 mm on.
  refuses_path(
      "ROBOT \"lwa4p\"\nMOVE(600, 0, 205, 0, 90, 0) FINE\n"
      "MOVEL BY (200, 0, 0) AT 50mm/s\n",
      {"E560", "the tool would leave the reach of lwa4p at 130", "mm of 200 mm",
       "farther out than it reaches", "help: choose a way that stays in reach"});
  refuses_path(
      kIrb120 + "MOVE(320, -120, 250, 180, 0, 180) FINE\nMOVEL(320, -120, 900) AT 100mm/s\n",
      {"E561", "axis j5 would pass its limit of 120 deg at 424", "mm of 650 mm",
       "help: shorten the way, or begin it in another posture"});
  // Axis 6 alone turns, through 400 deg; 90 deg is the same orientation as 450 deg.
  refuses_path(kIrb120 +
                   "MOVE JOINTS(0deg, 0deg, 0deg, 0deg, 90deg, 350deg) FINE\n"
                   "MOVEL FORWARD(JOINTS(0deg, 0deg, 0deg, 0deg, 90deg, 90deg))\n",
               {"E561", "axis j6 would pass its limit of 400 deg at 5", "deg of 100 deg",
                "help: the target can be reached in another posture"});
}

TEST_CASE("a line close by a singular place names it") {
  refuses_path(kIrb120 + "MOVE(200, 0.3, 750, 0, 0, 0) FINE\nMOVEL(-200, 0.3, 750) AT 100mm/s\n",
               {"E562", "axis j1 would have to turn too fast at 200", "mm of 400 mm",
                "the wrist is nearly above axis 1 there", "help: lead the way past that place"});
}

TEST_CASE("half a turn, an arc of three points on a line and a spline that stands are refused") {
  refuses_path(kIrb120 + "MOVE(350, 0, 300, 180, 0, 180) FINE\nMOVEL(350, 50, 300, 180, 0, 0)\n",
               {"E563", "the tool would turn by 180 deg"});
  refuses_path(
      kIrb120 + "MOVE(350, 0, 300, 180, 0, 180) FINE\nMOVEC VIA (350, 20, 300) TO (350, 50, 300)\n",
      {"E564", "they lie on a line"});
  refuses_path(
      kIrb120 + "MOVE(350, 0, 300, 180, 0, 180) FINE\nMOVES VIA (350, 0, 300) TO (350, 50, 300)\n",
      {"E564", "half a turn apart"});
}

TEST_CASE("a spline with points too close together beside its length is refused by that name") {
  refuses_path(kIrb120 +
                   "MOVE(350, 0, 300, 180, 0, 180) FINE\n"
                   "MOVES VIA (350, 0.01, 300) TO (350, 50, 300)\n",
               {"E565", "points too close together beside its length"});
}

TEST_CASE("the report tells of lines, arcs and splines what it tells of all motions") {
  const json report = run_arm(
      "MOVE(320, -120, 250, 180, 0, 180) FINE\n"
      "MOVEL(320, 120, 250) AT 100mm/s\n"                             // 240 mm
      "MOVEC VIA (370, 70, 250) TO (320, 20, 250) AT 100mm/s FINE\n"  // π·50 mm
      "MOVEL BY (0, 0, 50) AT 50mm/s\n"
      "STOP\nASSERT ABS(HERE.x - 320mm) < 0.001mm AND ABS(HERE.z - 300mm) < 0.001mm\n");
  INFO(report.dump());
  REQUIRE(report["status"] == "done");
  const json& lines = report["lines"];
  CHECK(lines[1]["planned_s"].get<double>() == doctest::Approx(2.4));
  CHECK(lines[2]["planned_s"].get<double>() == doctest::Approx(0.5 * 3.14159265 + 0.6));
  CHECK(lines[3]["planned_s"].get<double>() == doctest::Approx(1));
  for (const json& line : lines)
    CHECK(std::abs(line["planned_s"].get<double>() - line["measured_s"].get<double>()) < 0.005);
  // The way along the arc, less the corner into it, and that of the line before.
  const double way = lines[1]["s_mm"].get<double>() + lines[2]["s_mm"].get<double>();
  CHECK(way > 240 + 0.5 * 3.1415 * 100 - 40);
  CHECK(way < 240 + 0.5 * 3.1416 * 100);
  CHECK(lines[1]["corner_miss_mm"]["planned"].get<double>() > 1);
  CHECK(std::abs(lines[1]["corner_miss_mm"]["planned"].get<double>() -
                 lines[1]["corner_miss_mm"]["measured"].get<double>()) < 0.1);
}

TEST_CASE("places on a line and an arc are passed when the tool is there") {
  const json report = run_arm(
      "SIGNAL lamp = DOUT[1]\n"
      "MOVE(320, -100, 250, 180, 0, 180) FINE\nVAR begun = CLOCK\n"
      "MOVEL(320, 100, 250) AT 100mm/s DO\n  AFTER 50mm : lamp = ON\nENDMOVE\n"
      "MOVEC VIA (370, 50, 250) TO (320, 0, 250) AT 100mm/s DO\n  AFTER 78.54mm : lamp = OFF\n"
      "ENDMOVE\n");
  REQUIRE(report["status"] == "done");
  const json& lines = report["lines"];
  const auto instant = [&](int i) {
    const json& s = report["signals"][static_cast<std::size_t>(i)];
    return s["t"].get<double>();
  };
  // From rest t = 0 comes t_acc = 0.3 s behind the beginning; 50 mm at 100 mm/s; half of the arc.
  const double zero = lines[1]["starts_s"].get<double>() + 0.3;
  CHECK(std::abs(instant(0) - (zero + 0.5)) < 0.005);
  CHECK(std::abs(instant(1) - (zero + 2 + 0.7854)) < 0.005);
}

TEST_CASE("UNTIL ends a line on the line, and the next one begins there") {
  const json report = run_arm(
      "SIGNAL touch = DIN[1]\n"
      "MOVE(320, -100, 250, 180, 0, 180) FINE\n"
      "MOVEL(320, 100, 250) AT 100mm/s UNTIL CLOCK > 2.5s OR touch\n"
      "ASSERT HIT\nVAR p = HERE\n"
      "ASSERT ABS(p.x - 320mm) < 0.001mm AND ABS(p.z - 250mm) < 0.001mm\n"
      "ASSERT p.y > -100mm AND p.y < 50mm\n"
      "MOVEL BY (0, 0, 40) AT 100mm/s FINE\n"
      "ASSERT DIST(HERE, p + (0mm, 0mm, 40mm)) < 0.001mm\n");
  INFO(report.dump());
  CHECK(report["status"] == "done");
}

TEST_CASE("the gantry, too, runs arcs, splines, spirals and profiles") {
  const RobCommand rob(
      "MOVE(100, 0, 0) FINE\nMOVEC VIA (150, 50, 0) TO (100, 100, 0) AT 20mm/s FINE\n"
      "ASSERT ABS(HERE.y - 100mm) < 0.001mm\n"
      "MOVES VIA (120, 150, 30), (80, 160, 60) TO (40, 100, 0) AT 15mm/s FINE\n"
      "SPIRAL FROM 4mm TURNS 3 AT 4mm/s\nSTOP\n"
      "ASSERT DIST(HERE, POSE(44mm, 100mm, 0mm)) < 0.001mm\n"
      "MOVE(40, 40, 0) PROFILE COSINE OVER 8s\n");
  const json report = json::parse(rob("run", {"--fast", "--json"}).out);
  INFO(report.dump());
  REQUIRE(report["status"] == "done");
  // 50·π mm at 20 mm/s, whose components never exceed 20 mm/s, and the stop.
  CHECK(report["lines"][1]["planned_s"].get<double>() ==
        doctest::Approx(2.5 * 3.14159265 + 2.75).epsilon(1e-4));
  CHECK(report["lines"].back()["planned_s"].get<double>() == doctest::Approx(8));
}
