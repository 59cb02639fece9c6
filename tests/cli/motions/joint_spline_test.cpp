// MOVES through joints, and MOVEL … EULER, from outside.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "tests/support/rob_command.h"
#include "tests/support/trace_file.h"

using nlohmann::json;
using rob::test::contains;
using rob::test::ProcessResult;
using rob::test::RobCommand;
using rob::test::TraceRow;

namespace {

using Joints = std::array<double, 6>;  // deg

const std::array<Joints, 3> kThrough{Joints{40, 10, -20, 10, 30, 0},
                                     Joints{-20, 30, 10, 60, -30, 90},
                                     Joints{-60, 0, 0, 60, 45, -90}};

std::string joints_text(const Joints& joints) {
  std::string text;
  for (const double value : joints)
    text += (text.empty() ? "JOINTS(" : ", ") + std::to_string(value) + "deg";
  return text + ")";
}

std::string through_all(const std::string& clauses = "") {
  return "ROBOT \"irb120\"\nMOVES VIA " + joints_text(kThrough[0]) + ", " +
         joints_text(kThrough[1]) + " TO " + joints_text(kThrough[2]) + " " + clauses + "\n";
}

std::vector<TraceRow> rows_on_arm(const std::string& program, std::vector<std::string> more = {}) {
  const RobCommand rob(program);
  more.insert(more.end(), {"--fast", "--trace", rob.file("t.csv")});
  const ProcessResult result = rob("run", more);
  REQUIRE_MESSAGE(result.exit_code == 0, result.err);
  return rob::test::parse_trace(rob::test::read_whole_file(rob.file("t.csv"))).rows;
}

/// deg: how near the straight line from one row to the next comes to a point.
double distance_to(const std::vector<TraceRow>& rows, const Joints& point) {
  double best = std::numeric_limits<double>::infinity();
  for (std::size_t k = 1; k < rows.size(); ++k) {
    double along = 0;
    double square = 0;
    for (std::size_t i = 0; i < point.size(); ++i) {
      const double step = rows[k].q[i] - rows[k - 1].q[i];
      along += (point[i] - rows[k - 1].q[i]) * step;
      square += step * step;
    }
    const double share = square > 0 ? std::clamp(along / square, 0.0, 1.0) : 0;
    double off = 0;
    for (std::size_t i = 0; i < point.size(); ++i) {
      const double at = rows[k - 1].q[i] + share * (rows[k].q[i] - rows[k - 1].q[i]);
      off = std::max(off, std::abs(at - point[i]));
    }
    best = std::min(best, off);
  }
  return best;
}

std::string check_refuses(const std::string& program) {
  const ProcessResult result = RobCommand(program)("check");
  CHECK(result.exit_code == 65);
  return result.err;
}

}  // namespace

TEST_CASE("MOVES through joints meets them all within the limits of the axes, without a stop") {
  constexpr std::array<double, 6> kSpeed{250, 250, 250, 320, 320, 420};  // deg/s, irb120.toml
  for (const std::string law : {"paul", "lookahead"}) {
    CAPTURE(law);
    const auto rows = rows_on_arm(through_all(), {"--law", law});
    for (const Joints& point : kThrough) CHECK(distance_to(rows, point) < 0.02);
    double slowest = std::numeric_limits<double>::infinity();
    for (std::size_t k = 1; k < rows.size(); ++k) {
      const double period = rows[k].t - rows[k - 1].t;
      double share = 0;
      for (std::size_t i = 0; i < kSpeed.size(); ++i) {
        const double speed = std::abs(rows[k].q[i] - rows[k - 1].q[i]) / period;
        CHECK(speed < kSpeed[i] * 1.005);
        // The velocity that is told is that of the references: nothing jumps.
        CHECK(std::abs(rows[k].q[i] - rows[k - 1].q[i] -
                       period * (rows[k].qd[i] + rows[k - 1].qd[i]) / 2) < 0.02);
        share = std::max(share, speed / kSpeed[i]);
      }
      if (k > rows.size() / 4 && k < 3 * rows.size() / 4) slowest = std::min(slowest, share);
    }
    CHECK(slowest > 0.05);
  }
}

TEST_CASE("AT, FINE, UNTIL, WITH and ZONE stand behind MOVES through joints as behind others") {
  const auto measured = [](const std::string& program) {
    return json::parse(RobCommand(program)("run", {"--fast", "--json"}).out);
  };
  const double fast = measured(through_all())["measured_s"];
  const json slow = measured(through_all("AT 20%"));
  CHECK(slow["measured_s"].get<double>() > 3 * fast);
  CHECK(slow["findings"].empty());
  const json until = measured(through_all("AT 20% UNTIL CLOCK > 1s") + "PRINT HIT\n");
  CHECK(until["output"][0] == "TRUE");
  CHECK(until["lines"][0]["ended"] == "hit");
  // So slow that a corner is faster than a stop.
  const std::string next = "MOVE JOINTS(0deg, 0deg, 0deg, 0deg, 30deg, 0deg) AT 20%\n";
  const auto miss = [&](const std::string& clause) {
    const json report = measured("LAW LOOKAHEAD\n" + through_all(clause) + next);
    return report["lines"][0]["corner_miss_mm"]["planned"].get<double>();
  };
  // In the last period, of 4 ms, an axis goes 45,000 deg/s³·(4 ms)³/6 = 0.0005 deg: 3 µm at 0.4 m.
  CHECK(miss("FINE") < 5e-3);
  CHECK(miss("AT 20% ZONE 5mm") > 0.5);
  CHECK(miss("AT 20% ZONE 5mm") < 5.01);
  CHECK(measured("ROBOT \"irb120\"\nTOOL cup = POSE(0mm, 0mm, 100mm, 0deg, 0deg, 0deg)\n" +
                 through_all("WITH cup AT 50mm/s").substr(15))["status"] == "done");
  CHECK(measured(through_all() + "MOVEL BY (0, 0, -10) AT 50mm/s\n")["status"] == "done");
}

TEST_CASE("robots that are commanded in their axes go through joints, too") {
  const std::string program =
      "MOVES VIA JOINTS(10deg, 20deg, -10deg, 0deg, 5deg, 0deg) "
      "TO JOINTS(20deg, 0deg, 0deg, 10deg, 0deg, 10deg)\n";
  const ProcessResult result = RobCommand(program)("run", {"--fast", "--robot", "so101", "--json"});
  CHECK_MESSAGE(result.exit_code == 0, result.err);
  CHECK(json::parse(result.out)["final"]["joints"][0] == doctest::Approx(20));
}

TEST_CASE("what is wrong with MOVES through joints is refused, with place and remedy") {
  const std::string robot = "ROBOT \"irb120\"\n";
  const std::string j = joints_text(kThrough[0]);
  const std::string k = joints_text(kThrough[1]);
  const std::string mixed =
      check_refuses(robot + "MOVES VIA " + j + ", (350, 0, 250) TO " + k + "\n");
  CHECK(contains(mixed, "test.rob:2:"));
  CHECK(contains(mixed, "joints or through places, not through both"));
  CHECK(contains(mixed, "FORWARD(j)"));
  CHECK(contains(check_refuses(robot + "MOVEC VIA " + j + " TO " + k + "\n"), "MOVEC"));
  CHECK(contains(check_refuses(robot + "MOVES VIA " + j + ", " + j + " TO " + k + "\n"), "E564"));
  CHECK(
      contains(check_refuses(robot + "MOVES VIA JOINTS(200deg, 0deg, 0deg, 0deg, 0deg, 0deg) TO " +
                             k + "\n"),
               "E401"));
  // The curve swings beyond points that are within the limit of 165 deg.
  CHECK(contains(check_refuses(robot + "MOVES VIA JOINTS(150deg, 0deg, 0deg, 0deg, 0deg, 0deg), "
                                       "JOINTS(164deg, 30deg, 0deg, 0deg, 0deg, 0deg) TO "
                                       "JOINTS(0deg, 30deg, 0deg, 0deg, 0deg, 0deg)\n"),
                 "axis j1 would pass its limit of 165 deg"));
}

TEST_CASE("along MOVEL with EULER the angles change evenly with the way") {
  const std::string from = "ROBOT \"irb120\"\nMOVE(350, -100, 250, 180, 0, 180) FINE\n";
  const std::string line = "MOVEL POSE(350mm, 100mm, 250mm, 165deg, -25deg, 150deg) AT 100mm/s";
  const auto off = [&](const std::string& clause) {
    double most = 0;
    for (const TraceRow& row : rows_on_arm(from + line + clause + "\n")) {
      if (row.line != 3) continue;
      const double share = (row.pose[1] + 100) / 200;
      const std::array<double, 3> wanted{180 - 15 * share, -25 * share, 180 - 30 * share};
      for (std::size_t i = 0; i < wanted.size(); ++i)
        most = std::max(most, std::abs(std::remainder(row.pose[3 + i] - wanted[i], 360.0)));
    }
    return most;
  };
  CHECK(off(" EULER") < 0.005);
  CHECK(off("") > 0.5);
}

TEST_CASE("EULER is refused near b = 90 deg, and where no line is") {
  const std::string robot = "ROBOT \"irb120\"\nMOVE(350, 0, 250, 180, 0, 180) FINE\n";
  const std::string steep =
      check_refuses(robot + "MOVEL POSE(350mm, 50mm, 250mm, 0deg, 89.5deg, 0deg) EULER\n");
  CHECK(contains(steep, "test.rob:3:1: error[E566]"));
  CHECK(contains(steep, "at the end of this line, within 1 deg of 90 deg"));
  CHECK(contains(check_refuses(robot + "MOVE(350, 50, 250) EULER\n"),
                 "EULER stands after MOVEL alone"));
  CHECK(contains(check_refuses("LAW LOOKAHEAD\nPATH EULER DO\nMOVEL(10, 0, 0)\nENDPATH\n"),
                 "EULER does not stand after PATH"));
  CHECK(
      contains(check_refuses(robot + "MOVEL(350, 50, 250) EULER EULER\n"), "EULER is given twice"));
}

TEST_CASE("EULER is no reserved word") {
  const ProcessResult result = RobCommand(
      "ROBOT \"irb120\"\nCONST euler = POSE(350mm, 100mm, 250mm, 180deg, 0deg, 180deg)\n"
      "MOVE(350, -100, 250, 180, 0, 180) FINE\nMOVEL euler EULER AT 100mm/s FINE\nMOVEL euler\n")(
      "run", {"--fast"});
  CHECK_MESSAGE(result.exit_code == 0, result.err);
}
