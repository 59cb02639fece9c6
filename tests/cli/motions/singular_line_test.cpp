// A line of the tool close by a singular place, under Paul's law: slow there, and there alone.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "tests/support/rob_command.h"
#include "tests/support/trace_file.h"

using nlohmann::json;
using rob::test::contains;
using rob::test::RobCommand;
using rob::test::TraceRow;

namespace {

constexpr double kPeriod = 0.004;    // s: irb120's references
constexpr double kFastest = 250;     // deg/s, of its axes 1 and 4, the slowest of those that move
constexpr double kStrongest = 2750;  // deg/s²
constexpr double kOneDegree = 3.14159265358979 / 180;

/// From y = −200 mm to 200 mm, `beside` mm from axis 1, about which the wrist turns by half a turn.
std::string line_past_axis_1(double beside, double speed) {
  const std::string x = std::to_string(beside) + "mm";
  return "SIGNAL lamp = DOUT[1]\n"
         "MOVE JOINTS(-85deg, 0deg, 0deg, 0deg, 30deg, 0deg) FINE\n"
         "MOVE POSE(" +
         x +
         ", -200mm, 750mm, 0deg, 0deg, 0deg) FINE\n"
         "MOVEL POSE(" +
         x + ", 200mm, 750mm, 0deg, 0deg, 0deg)" +
         (speed > 0 ? " AT " + std::to_string(speed) + "mm/s" : "") +
         " DO\n  AFTER 210mm : lamp = ON\nENDMOVE\n";
}

/// Axis 1 stands at atan(y/d), so it permits v = w·(d² + y²)/d; elsewhere the speed asked for.
double least_time(double beside, double speed) {
  const double w = kFastest * kOneDegree;
  const double border = std::sqrt(speed * beside / w - beside * beside);
  return 2 * (std::atan(border / beside) / w + (200 - border) / speed);
}

std::vector<TraceRow> rows_of_line(const std::string& file, int line) {
  auto rows = rob::test::parse_trace(rob::test::read_whole_file(file)).rows;
  std::erase_if(rows, [&](const TraceRow& row) { return row.line != line; });
  REQUIRE(rows.size() > 10);
  return rows;
}

void check_limits(const std::vector<TraceRow>& rows) {
  double fastest = 0;
  double strongest = 0;
  for (std::size_t k = 2; k < rows.size(); ++k) {
    for (std::size_t i = 0; i < 6; ++i) {
      const double now = rows[k].q[i] - rows[k - 1].q[i];
      const double before = rows[k - 1].q[i] - rows[k - 2].q[i];
      fastest = std::max(fastest, std::abs(now) / kPeriod);
      strongest = std::max(strongest, std::abs(now - before) / (kPeriod * kPeriod));
    }
  }
  CHECK(fastest <= 1.0005 * kFastest);
  CHECK(strongest <= 1.02 * kStrongest);
}

}  // namespace

TEST_CASE("a line past axis 1 is slow where the axis needs it, and as fast as AT elsewhere") {
  for (const double beside : {2.0, 10.0, 30.0}) {
    for (const double speed : {100.0, 250.0}) {
      if (speed * beside / (kFastest * kOneDegree) <= beside * beside) continue;  // nothing is slow
      CAPTURE(beside);
      CAPTURE(speed);
      const RobCommand rob(line_past_axis_1(beside, speed));
      const std::string file = rob.file("trace.csv");
      const auto result = rob("run", {"--robot", "irb120", "--fast", "--json", "--trace", file});
      REQUIRE(result.exit_code == 0);
      const json report = json::parse(result.out);
      const auto rows = rows_of_line(file, 4);
      check_limits(rows);
      double beyond = 0;
      double fastest = 0;
      for (std::size_t k = 1; k < rows.size(); ++k) {
        const auto& pose = rows[k].pose;
        beyond = std::max({beyond, std::abs(pose[0] - beside), std::abs(pose[2] - 750)});
        fastest = std::max(fastest, (pose[1] - rows[k - 1].pose[1]) / kPeriod);
      }
      CHECK(beyond < 0.001);
      CHECK(fastest == doctest::Approx(speed).epsilon(0.03));
      // S1's ramps take 0.3 s each; what is left is for the change of speed, within jerk.
      const double took = rows.back().t - rows.front().t;
      const double least = least_time(beside, speed);
      CHECK(took >= least);
      CHECK(took <= least + 0.6 + 0.7);
      // The lamp goes on where the tool is 210 mm on.
      const double lit = report["signals"][0]["t"];
      const auto passed = std::find_if(rows.begin(), rows.end(),
                                       [](const TraceRow& row) { return row.pose[1] >= 10; });
      REQUIRE(passed != rows.end());
      CHECK(std::abs(passed->t - lit) <= kPeriod + 1e-9);
    }
  }
}

TEST_CASE("without AT such a line takes a time like that of the look-ahead law") {
  for (const double beside : {10.0, 30.0}) {
    CAPTURE(beside);
    double took[2] = {};
    for (const bool ahead : {false, true}) {
      const RobCommand rob((ahead ? "LAW LOOKAHEAD\n" : "") + line_past_axis_1(beside, 0));
      const json report = json::parse(rob("run", {"--robot", "irb120", "--fast", "--json"}).out);
      REQUIRE(report["status"] == "done");
      for (const json& line : report["lines"])
        if (line["line"] == (ahead ? 5 : 4)) took[ahead ? 1 : 0] = line["measured_s"];
    }
    CHECK(took[0] <= 2.5 * took[1]);
  }
}

TEST_CASE("W601 tells where an axis holds the speed, and how much longer that takes") {
  const RobCommand rob(line_past_axis_1(10, 250));
  const std::string told =
      rob("check", {"--robot", "irb120"}).err + rob("check", {"--robot", "irb120"}).out;
  // y = ±√(250·10/w − 100) = ±21.7 mm; the planner looks at a place every few tenths of a mm.
  CHECK(contains(told, "W601]: AT asks for more than the axes can do: axis j1 holds it from 178."));
  CHECK(contains(told, " to 221."));
  CHECK(contains(told, " mm of 400 mm, and the motion takes "));
  CHECK(contains(told, " s longer"));
}

TEST_CASE("corners beside singular places keep jerk, or are stops") {
  // A small zone asks for a short corner, in which the wrist turns fast: third differences of the
  // references were three times j_max.
  const RobCommand rob(
      "LAW PAUL\n"
      "MOVE JOINTS(5.018deg, 0.091deg, 28.889deg, 15.155deg, 1deg, 2.24deg) FINE\n"
      "MOVEL FORWARD(JOINTS(-1.487deg, 4.833deg, 27.212deg, 27.031deg, 40deg, 53.107deg))"
      " OVER 3.1s ZONE 1mm\n"
      "MOVEL FORWARD(JOINTS(1.474deg, 11.202deg, 34.74deg, 71.114deg, 5deg, 62.222deg))"
      " AT 50% ZONE 1mm\n"
      "MOVEL FORWARD(JOINTS(-2.174deg, 4.604deg, 30.512deg, 64.07deg, 1deg, 19.77deg))"
      " AT 500mm/s FINE\n");
  const std::string file = rob.file("trace.csv");
  const auto result = rob("run", {"--robot", "lwa4p", "--fast", "--trace", file});
  REQUIRE(result.exit_code == 0);
  CHECK(contains(result.err + result.out, "W641"));
  const auto rows = rob::test::parse_trace(rob::test::read_whole_file(file)).rows;
  const double period = rows[1].t - rows[0].t;
  double most[6] = {};
  for (std::size_t k = 3; k < rows.size(); ++k) {
    for (std::size_t i = 0; i < 6; ++i) {
      const auto q = [&](std::size_t at) { return rows[at].q[i]; };
      const double third = q(k) - 3 * q(k - 1) + 3 * q(k - 2) - q(k - 3);
      most[i] = std::max(most[i], std::abs(third) / (period * period * period));
    }
  }
  for (std::size_t i = 0; i < 6; ++i) CHECK(most[i] <= 1.1 * (i < 3 ? 5000 : 8000));  // lwa4p.toml
}
