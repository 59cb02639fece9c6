// A curve in short chords beside the curve itself, from outside: the times of whole runs.
#include <doctest/doctest.h>

#include <cmath>
#include <iomanip>
#include <sstream>
#include <string>

#include "tests/support/rob_command.h"

using nlohmann::json;
using rob::test::RobCommand;

namespace {

double seconds(const std::string& program) {
  const auto result = RobCommand(program)("run", {"--fast", "--json"});
  CAPTURE(result.err);
  CHECK(result.exit_code == 0);
  return json::parse(result.out)["measured_s"].get<double>();
}

/// Part of a circle around (0, 40 mm) from the origin on, in the plane of x and y.
struct Arc {
  double x;
  double y;
};
Arc at(double angle) { return {40 * std::sin(angle), 40 - 40 * std::cos(angle)}; }

std::string chords(double length, double angle, const std::string& clauses) {
  const int count = static_cast<int>(std::lround(40 * angle / length));
  std::ostringstream program;
  program << std::fixed << std::setprecision(7);
  Arc last{0, 0};
  for (int i = 1; i <= count; ++i) {
    const Arc next = at(angle * i / count);
    program << "MOVEL BY (" << next.x - last.x << ", " << next.y - last.y << ", 0) " << clauses
            << "\n";
    last = next;
  }
  return program.str() + "STOP\n";
}

std::string arc(double angle, const std::string& clauses) {
  const Arc via = at(angle / 2);
  const Arc end = at(angle);
  std::ostringstream program;
  program << "VAR half = HERE\nhalf.x = half.x + " << via.x << "mm\nhalf.y = half.y + " << via.y
          << "mm\nVAR whole = HERE\nwhole.x = whole.x + " << end.x << "mm\nwhole.y = whole.y + "
          << end.y << "mm\nMOVEC VIA half TO whole " << clauses << " FINE\n";
  return program.str();
}

}  // namespace

// It took 4 to 33 times as long where each chord had corners. What is left are the mean of the
// whole run, which begins before its end is known, and the ends of what is known.
TEST_CASE("an arm takes at most twice as long along short chords as along their arc") {
  for (const char* robot : {"irb120", "pc104", "ums7", "lwa4p"}) {
    const std::string start =
        std::string("ROBOT \"") + robot + "\"\nLAW LOOKAHEAD\nMOVE BY (10, 20, -60) FINE\n";
    const double there = seconds(start);
    const double along_arc = seconds(start + arc(1, "AT 200mm/s")) - there;
    for (const double length : {2.0, 0.2}) {
      CAPTURE(robot);
      CAPTURE(length);
      const std::string lines = chords(length, 1, "AT 200mm/s ZONE 0.1mm");
      CHECK(seconds(start + lines) - there <= 2 * along_arc);
    }
  }
}

TEST_CASE("a straight line in pieces under a bound on jerk is reported as straight") {
  std::string program = "ROBOT \"gantry\"\nLAW LOOKAHEAD\n";
  for (int i = 1; i <= 200; ++i) program += "MOVE(" + std::to_string(0.25 * i) + ", 0, 0)\n";
  const auto result = RobCommand(program)("run", {"--fast", "--json"});
  REQUIRE(result.exit_code == 0);
  const json report = json::parse(result.out);
  CHECK(report["deviation_mm"].get<double>() < 0.001);
  for (const json& line : report["lines"]) {
    if (line["corner_miss_mm"].is_null()) continue;
    CHECK(line["corner_miss_mm"]["planned"].get<double>() < 0.001);
  }
}
