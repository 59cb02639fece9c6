// What `rob check` tells of the slowest places of a path under the look-ahead law.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "tests/support/rob_command.h"
#include "tests/support/trace_file.h"

using nlohmann::json;
using rob::test::contains;
using rob::test::RobCommand;

namespace {

const std::string kXyFile = std::string(ROB_SOURCE_DIR) + "/tests/bench/xy.toml";

json slow_places(const std::string& program, std::vector<std::string> more = {}) {
  more.emplace_back("--json");
  return json::parse(RobCommand(program)("check", more).out)["slow_places"];
}

// The hand turns about a line by which axes 4 and 6 are nearly in one.
const std::string kByTheWrist =
    "LAW LOOKAHEAD\n"
    "MOVE JOINTS(0deg, 10deg, 10deg, -70deg, 20deg, 70deg) FINE\n"
    "MOVEL FORWARD(JOINTS(0deg, 10deg, 10deg, 80deg, 20deg, -80deg)) AT 300mm/s\n";

}  // namespace

TEST_CASE("a sharp corner is told with the speed that its zone leaves") {
  const std::string program =
      "MOVE(200, 0, 0) AT 300mm/s ZONE 0.1mm\nMOVE(200, 200, 0) AT 300mm/s ZONE 5mm\n"
      "MOVE(0, 200, 0) AT 300mm/s\n";
  const json places = slow_places(program, {"--robot", kXyFile});
  REQUIRE(places.size() == 1);  // the corner at 5 mm is gone at √(8·5/√2·1000) = 168 mm/s
  const json& place = places[0];
  CHECK(place["line"] == 1);
  CHECK(place["corner"] == true);
  CHECK(place["limit"] == "acceleration");
  CHECK(place["near"] == nullptr);
  CHECK(place["asked_mm_s"] == doctest::Approx(300));
  // docs/motion.md: it misses by l·√2/4, and v² = 2l·a, with 1000 mm/s².
  const double half = 0.1 * 4 / std::sqrt(2.0);
  CHECK(place["speed_mm_s"] == doctest::Approx(std::sqrt(2 * half * 1000)).epsilon(0.03));
  CHECK(place["at_mm"] > 200 - half - 0.05);
  const std::string table = RobCommand(program)("check", {"--robot", kXyFile}).out;
  CHECK(contains(table, "slowest: line 1, in a corner 199.7 mm on: 23.8 of 300 mm/s; axis "));
}

TEST_CASE("a place by the wrist's singularity is told with the axis that holds the speed") {
  // With jerk bounded that would hold it.
  std::string arm =
      rob::test::read_whole_file(std::string(ROB_SOURCE_DIR) + "/motion/robots/irb120.toml");
  for (std::size_t at; (at = arm.find("j_max")) != std::string::npos;)
    arm.erase(at, arm.find('\n', at) - at);
  const RobCommand rob(kByTheWrist);
  std::ofstream(rob.file("free.toml")) << arm;
  const std::vector<std::string> on_it{"--robot", rob.file("free.toml")};
  const json places = slow_places(kByTheWrist, on_it);
  REQUIRE(places.size() == 1);
  const json& place = places[0];
  CHECK(place["line"] == 3);
  CHECK(place["axis"] == "j4");
  CHECK(place["limit"] == "speed");
  CHECK(place["near"] == "wrist");
  CHECK(place["corner"] == false);
  CHECK(place["text"] == "axis j4 speed near the wrist singularity");

  const std::string file = rob.file("trace.csv");
  REQUIRE(rob("run", {"--fast", "--trace", file, "--robot", on_it[1]}).exit_code == 0);
  const auto rows = rob::test::parse_trace(rob::test::read_whole_file(file)).rows;
  const double t = place["t"];
  const auto row = std::ranges::find_if(rows, [&](const auto& r) { return r.t > t - 1e-6; });
  REQUIRE(row != rows.end());
  // θ5 is least there, and axis 4 as fast as it may be: 320 deg/s.
  CHECK(std::abs(row->qd[3]) == doctest::Approx(320).epsilon(0.02));
  CHECK(std::ranges::all_of(rows, [](const auto& r) { return std::abs(r.qd[3]) <= 320 + 1e-3; }));
  CHECK(std::ranges::all_of(
      rows, [&](const auto& r) { return std::abs(r.q[4]) > std::abs(row->q[4]) - 0.05; }));
  CHECK(place["speed_mm_s"] == doctest::Approx(row->rate * 1000));
}

TEST_CASE("an axis that cannot do what AT asks for is told, however even the motion is") {
  const json places = slow_places("LAW LOOKAHEAD\nMOVE(400, 0, 0) AT 100mm/s\n");
  REQUIRE(places.size() == 1);
  CHECK(places[0]["text"] == "axis x speed");
  CHECK(places[0]["speed_mm_s"] == doctest::Approx(20));
  CHECK(places[0]["corner"] == false);
}

TEST_CASE("starts, stops, what nothing was asked of, and Paul's law have no slow places") {
  const std::string even =
      "MOVE(100, 0, 0) AT 15mm/s\nMOVE(200, 0, 0) AT 15mm/s FINE\nMOVE(0, 0, 0)\n";
  CHECK(slow_places("LAW LOOKAHEAD\n" + even).empty());
  CHECK(slow_places(even).empty());
  CHECK(slow_places("LAW LOOKAHEAD\nMOVE(100, 0, 0) ZONE 0.01mm\nMOVE(100, 100, 0)\n").empty());
  CHECK_FALSE(contains(RobCommand("LAW LOOKAHEAD\n" + even)("check").out, "slowest"));
}

TEST_CASE("of many slow places the three slowest are told, a line once") {
  std::string program = "LAW LOOKAHEAD\nFOR i = 1 TO 3 DO\n";
  for (const char* zone : {"0.4", "0.1", "0.3", "0.2"})
    program += std::string("MOVE BY (100, 0, 0) AT 300mm/s ZONE ") + zone +
               "mm\nMOVE BY (-100, 100, 0) AT 300mm/s FINE\n";
  const json places = slow_places(program + "ENDFOR\n", {"--robot", kXyFile});
  REQUIRE(places.size() == 3);
  CHECK(places[0]["line"] == 5);
  CHECK(places[1]["line"] == 9);
  CHECK(places[2]["line"] == 7);
}
