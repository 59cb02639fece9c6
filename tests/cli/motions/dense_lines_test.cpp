// The times of whole runs, from outside: a curve in short chords beside the curve itself, and lines
// with a zone beside the same with stops.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <iterator>
#include <numbers>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/rob_command.h"
#include "tests/support/some_of.h"
#include "tests/support/trace_file.h"

using nlohmann::json;
using rob::test::RobCommand;
using rob::test::some_of;

namespace {

double seconds(const std::string& program, std::vector<std::string> options = {}) {
  options.insert(options.end(), {"--fast", "--json"});
  const auto result = RobCommand(program)("run", options);
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

// The goal of an arc: a fiftieth. Chords of 2 mm took 1.4 to 1.9 times as long before they crowded,
// and chords of 0.02 mm up to 4.5 times while the program was not waited for.
TEST_CASE("an arm takes no longer along short chords than along their arc") {
  for (const char* robot : some_of("irb120", "pc104", "ums7", "lwa4p")) {
    const std::string start =
        std::string("ROBOT \"") + robot + "\"\nLAW LOOKAHEAD\nMOVE BY (10, 20, -60) FINE\n";
    const double there = seconds(start);
    const double along_arc = seconds(start + arc(1, "AT 200mm/s")) - there;
    for (const double length : {2.0, 0.5, 0.2, 0.02}) {
      CAPTURE(robot);
      CAPTURE(length);
      const std::string lines = chords(length, 1, "AT 200mm/s ZONE 0.1mm");
      CHECK(seconds(start + lines) - there <= 1.02 * along_arc);
    }
  }
}

// Such a leg is cut in two: its first part belongs to the curve. The second ran at up to six times
// its AT.
TEST_CASE("a long leg after a dense curve keeps its AT") {
  constexpr double kSpeed = 30;  // mm/s
  for (const char* robot : {"irb120", "pc104"}) {
    for (const char* zone : {"0.5mm", "5mm"}) {
      CAPTURE(robot);
      CAPTURE(zone);
      const std::string clauses = std::string("AT 30mm/s ZONE ") + zone;
      const RobCommand rob(std::string("ROBOT \"") + robot + "\"\nLAW LOOKAHEAD\n" +
                           "MOVE BY (10, 20, -60) FINE\n" + chords(0.2, 0.25, clauses) +
                           "MOVEL BY (19, 6, 0) " + clauses + "\n");
      const std::string file = rob.file("trace.csv");
      REQUIRE(rob("run", {"--fast", "--trace", file}).exit_code == 0);
      const auto rows = rob::test::parse_trace(rob::test::read_whole_file(file)).rows;
      double fastest = 0;
      for (std::size_t k = 1; k < rows.size(); ++k) {
        if (rows[k - 1].line < 4) continue;
        double square = 0;
        for (std::size_t i = 0; i < 3; ++i)
          square += std::pow(rows[k].pose[i] - rows[k - 1].pose[i], 2);
        fastest = std::max(fastest, std::sqrt(square) / (rows[k].t - rows[k - 1].t));
      }
      CHECK(fastest <= 1.01 * kSpeed);
      CHECK(fastest >= 0.95 * kSpeed);
    }
  }
}

// Gentle bends and sharp ones, in legs of 1 to 20 mm: a curve, a corner or a stop, whichever is the
// soonest.
TEST_CASE("no arm is slower along bends of any kind than with a stop at each point") {
  for (const char* robot : some_of("irb120", "pc104", "lwa4p")) {
    for (const double length : {1.0, 5.0, 20.0}) {
      for (const double turn : {0.1, 0.5, 1.5}) {
        for (const char* zone : {"0.1mm", "2mm"}) {
          CAPTURE(robot);
          CAPTURE(length);
          CAPTURE(turn);
          CAPTURE(zone);
          const std::string start =
              std::string("ROBOT \"") + robot + "\"\nLAW LOOKAHEAD\nMOVE BY (10, 20, -60) FINE\n";
          const auto lines = [&](const std::string& clauses) {
            std::ostringstream program;
            program << std::fixed << std::setprecision(5) << start;
            for (int k = 0; k < 6; ++k) {
              const double heading = k % 2 == 0 ? turn : 0;
              program << "MOVEL BY (" << length * std::cos(heading) << ", "
                      << length * std::sin(heading) << ", 0) AT 250mm/s " << clauses << "\n";
            }
            return program.str();
          };
          CHECK(seconds(lines(std::string("ZONE ") + zone)) <= seconds(lines("FINE")) + 1e-6);
        }
      }
    }
  }
}

// As a curve the first took 1.49 times as long as with stops, and the second 1.08.
TEST_CASE("sharp short legs of an arm become no curve where stops are faster") {
  const char* const sharp =
      "ROBOT \"pc104\"\nLAW LOOKAHEAD\nMOVE BY (10, 20, -60) FINE\n"
      "MOVEL BY (9.386, 9.446, 1.46) ZONE 2mm\n"
      "MOVEL BY (-3.2, -17.941, -6.351) ZONE 2mm\n"
      "MOVEL BY (0.052, 10.743, 1.932) ZONE 2mm\n";
  const std::string zigzag =
      "ROBOT \"ums7\"\nLAW LOOKAHEAD\nMOVE BY (10, 20, -60) FINE\n"
      "MOVEL BY (0.3026, -1.9770, 0.2880) AT 100mm/s ZONE 0.05mm\n"
      "MOVEL BY (0.2370, -1.9859, 0.3184) AT 100mm/s ZONE 0.05mm\n"
      "MOVEL BY (1.9755, -0.3119, 0.2634) AT 100mm/s ZONE 0.05mm\n"
      "MOVEL BY (-0.7055, -1.8714, -0.0867) AT 100mm/s ZONE 0.05mm\n"
      "MOVEL BY (-0.5685, 1.9175, -0.2023) AT 100mm/s ZONE 0.05mm\n"
      "MOVEL BY (-0.0882, 1.9981, 0.1954) AT 100mm/s ZONE 0.05mm\n"
      "MOVEL BY (-1.7313, -1.0013, -0.3333) AT 100mm/s ZONE 0.05mm\n"
      "MOVEL BY (1.5169, -1.3034, -0.1282) AT 100mm/s ZONE 0.05mm\n"
      "MOVEL BY (-1.9387, 0.4914, 0.0571) AT 100mm/s ZONE 0.05mm\n"
      "MOVEL BY (1.9928, -0.1698, -0.2333) AT 100mm/s ZONE 0.05mm\n";
  for (const std::string& program : {std::string(sharp), zigzag}) {
    CAPTURE(program);
    const std::regex zone("ZONE [0-9.]+mm");
    CHECK(seconds(program) <= seconds(std::regex_replace(program, zone, "FINE")) + 1e-6);
  }
}

// A run of two legs pays at both of its ends for its longer mean. Where its second corner was a
// stop that was forgotten: 1.07, 1.04 and 1.04 of the time with stops.
TEST_CASE("a run of two legs under a bound on jerk is made only where it is faster than a stop") {
  struct Polyline {
    double speed, jerk, zone;  // mm/s, mm/s³, mm
    std::vector<std::array<double, 2>> points;
  };
  const Polyline polylines[] = {
      {300,
       30000,
       0.1,
       {{-17.615, 7.039},
        {-34.975, -10.580},
        {-26.234, -36.071},
        {-36.430, -11.208},
        {-40.346, -30.093},
        {-23.642, -22.384}}},
      {300,
       3000,
       1,
       {{9.950, 19.348},
        {4.993, -0.510},
        {-20.609, -6.900},
        {-21.673, -26.255},
        {-24.032, -14.131},
        {-13.548, -10.913}}},
      {100,
       10000,
       0.1,
       {{2.518, 6.744},
        {0.608, 13.753},
        {4.297, 13.746},
        {-1.154, 11.749},
        {2.745, 11.809},
        {5.295, 7.524}}},
  };
  for (const Polyline& polyline : polylines) {
    CAPTURE(polyline.zone);
    const auto program = [&](bool stops) {
      std::ostringstream text;
      text << "LAW LOOKAHEAD\n";
      for (const auto& [x, y] : polyline.points) {
        text << "MOVE(" << x << ", " << y << ", 0) AT " << polyline.speed
             << "mm/s ACCEL 1000mm/s^2 JERK " << polyline.jerk << "mm/s^3 ";
        text << (stops ? "FINE" : "ZONE " + std::to_string(polyline.zone) + "mm") << "\n";
      }
      return text.str();
    };
    const std::vector<std::string> xy = {"--robot", ROB_SOURCE_DIR "/tests/bench/xy.toml"};
    CHECK(seconds(program(false), xy) <= seconds(program(true), xy) + 1e-6);
  }
}

// A curve of the first took 1.11 of the time with stops, of the second 0.96; both overlap.
TEST_CASE("legs to and fro under a bound on jerk overlap where that is faster than a curve") {
  for (const double turn : {std::acos(-1.0), std::acos(0.0)}) {
    CAPTURE(turn);
    std::ostringstream lines;
    lines << std::fixed << std::setprecision(4) << "LAW LOOKAHEAD\n";
    Arc place{0, 0};
    for (int k = 0; k < 40; ++k) {
      const double heading = k % 2 == 0 ? 0 : turn;
      place = {place.x + 5 * std::cos(heading), place.y + 5 * std::sin(heading)};
      lines << "MOVE(" << place.x << ", " << place.y
            << ", 0) AT 1000mm/s ACCEL 1000mm/s^2 JERK 10000mm/s^3 ZONE 0.1mm\n";
    }
    const std::vector<std::string> xy = {"--robot", ROB_SOURCE_DIR "/tests/bench/xy.toml"};
    const std::string stops = std::regex_replace(lines.str(), std::regex("ZONE 0.1mm"), "FINE");
    CHECK(seconds(lines.str(), xy) <= 0.8 * seconds(stops, xy));
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

// What a program of a CAM system looks like. Of the time of the circle itself, d/v + v/a + a/j;
// 1.67 to 2.47 of it while a leg among the short ones could not be longer than 8 periods.
TEST_CASE("chords of mixed lengths of a circle take its time under a bound on jerk, too") {
  constexpr double kRadius = 40, kTurn = 2 * std::numbers::pi;
  constexpr double kLengths[] = {0.01, 0.1, 2, 0.1, 0.01, 0.01, 2, 2, 0.1, 0.01, 0.1};
  for (const double speed : some_of(150.0, 100.0)) {
    std::ostringstream program;
    program << std::fixed << std::setprecision(4);
    std::size_t k = 0;
    for (double angle = 0; angle < kTurn; ++k) {
      angle = std::min(angle + kLengths[k % std::size(kLengths)] / kRadius, kTurn);
      program << "MOVE(" << at(angle).x << ", " << at(angle).y << ", 0) AT " << speed
              << "mm/s JERK 100000mm/s^3 ZONE 0.2mm\n";
    }
    const double best = kTurn * kRadius / speed + speed / 1000 + 1000 / 1e5;
    CAPTURE(speed);
    CHECK(seconds(program.str(), {"--robot", ROB_SOURCE_DIR "/tests/bench/xy.toml"}) <=
          1.06 * best);
  }
}
