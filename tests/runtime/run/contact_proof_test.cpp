// What is proved of motions that nobody has foretold, and what is taken from foretelling.
#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "base/split_mix.h"
#include "motion/robots/robot_library.h"
#include "runtime/run/foretell.h"
#include "runtime/run/run.h"
#include "tests/support/stepped_run.h"

using namespace rob::motion;
using rob::SplitMix;
using rob::runtime::ExitCode;
using rob::runtime::Foretold;
using rob::runtime::RunOptions;
using rob::runtime::RunResult;
using rob::runtime::Snapshot;
using rob::test::SteppedRun;

namespace {

constexpr double kToolRadius = 0.001;  // m
constexpr double kBallRadius = 0.002;

RobotModel bare_gantry(Law law) {
  RobotModel robot = embedded_robot("gantry");
  robot.law = law;
  return robot;
}

/// With a ball as its tool, and this in its way.
RobotModel gantry_before(Law law, const Eigen::Vector3d& ball) {
  RobotModel robot = bare_gantry(law);
  robot.collision.bodies = {{"tool", 4, {Capsule{.radius = kToolRadius}}}};
  robot.collision.obstacles = {{.name = "ball", .shape = Sphere{ball, kBallRadius}}};
  return robot;
}

RunResult run_after(const RobotModel& robot, const std::string& text, Foretold foretold) {
  const auto program = rob::runtime::compile_program("t.rob", text, robot);
  REQUIRE(program.runnable());
  RunOptions options;
  options.fast = true;
  options.foretold = &foretold;
  return rob::runtime::run(program, robot, options, {});
}

RunResult run_unforeseen(const RobotModel& robot, const std::string& text) {
  return run_after(robot, text, {});
}

/// As `rob run` does.
RunResult run_as_foretold(const RobotModel& robot, const std::string& text) {
  const auto program = rob::runtime::compile_program("t.rob", text, robot);
  REQUIRE(program.runnable());
  RunResult ahead = rob::runtime::foretell(program, robot);
  REQUIRE_FALSE(ahead.contact);
  return run_after(robot, text, rob::runtime::foretold_by(std::move(ahead)));
}

Eigen::Vector3d place_of_tool(const Snapshot& row) {
  const JointVector& q = row.sample.reference.q;
  return {q[0], q[1], 0};
}

std::vector<Eigen::Vector3d> tool_way(Law law, const std::string& text) {
  SteppedRun run(text, nullptr, 1, bare_gantry(law));
  run.run();
  std::vector<Eigen::Vector3d> way;
  for (const Snapshot& row : run.rows) way.push_back(place_of_tool(row));
  return way;
}

/// The least distance of a point from a polyline, by its pieces.
double from_line(const std::vector<Eigen::Vector3d>& line, const Eigen::Vector3d& point) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    constexpr int kParts = 20;
    for (int k = 0; k <= kParts; ++k)
      least = std::min(least, (line[i] + (line[i + 1] - line[i]) * k / kParts - point).norm());
  }
  return least;
}

std::string move_to(const Eigen::Vector3d& at, const std::string& how) {
  return "MOVE(" + std::to_string(1000 * at.x()) + ", " + std::to_string(1000 * at.y()) + ", 0)" +
         how + "\n";
}

}  // namespace

TEST_CASE("what foretelling has followed is not judged anew") {
  // The ball is in the corner's point, which the robot does not reach; and behind the place where
  // UNTIL or a WHEN ends the motion.
  for (const Law law : {Law::Paul, Law::LookAhead}) {
    CAPTURE(law_name(law));
    const RobotModel corner = gantry_before(law, {0.1535, 0.0965, 0});
    const RunResult rounded = run_as_foretold(
        corner, "MOVE(100,100,0) FINE\nMOVE(150,100,0)\nMOVE(150,150,0) FINE\nSTOP");
    CHECK(rounded.exit_code == ExitCode::Done);
    CHECK(rounded.final_joints.at(1) == doctest::Approx(150));
    const RobotModel behind = gantry_before(law, {0.22, 0.05, 0});
    for (const std::string text :
         {"MOVE(190,50,0) FINE\nMOVE(250,50,0) AT 10mm/s UNTIL HERE.x > 194mm\nMOVE(190,60,0)",
          "WHEN HERE.x > 194mm : BRAKE\nMOVE(190,50,0) FINE\nMOVE(250,50,0) AT 10mm/s\n"
          "MOVE(190,60,0)"}) {
      CAPTURE(text);
      const RunResult ended = run_as_foretold(behind, text);
      CHECK(ended.exit_code == ExitCode::Done);
      // And if nobody has foretold it, the whole way is judged.
      const RunResult refused = run_unforeseen(behind, text);
      REQUIRE(refused.error.has_value());
      CHECK(refused.error->code == "E580");
    }
  }
}

TEST_CASE("where a run leaves what was foretold its motions are proved") {
  // The foretold program goes beside the ball, the one that runs goes through it.
  const RobotModel robot = gantry_before(Law::Paul, {0.15, 0.1, 0});
  const std::string begins = "MOVE(100,100,0) FINE\n";
  const auto aside = rob::runtime::compile_program("t.rob", begins + "MOVE(100,150,0)", robot);
  const RunResult through =
      run_after(robot, begins + "MOVE(200,100,0)",
                rob::runtime::foretold_by(rob::runtime::foretell(aside, robot)));
  REQUIRE(through.error.has_value());
  CHECK(through.error->code == "E580");
  CHECK(through.final_joints.at(0) == doctest::Approx(100));
}

TEST_CASE("a contact in a corner that nobody has foreseen is found, and few others are told") {
  // Random corners, and a ball beside their points; the references of a robot without bodies say
  // what would be hit.
  for (const Law law : {Law::Paul, Law::LookAhead}) {
    CAPTURE(law_name(law));
    SplitMix random(5);
    int hits = 0;
    int in_corners = 0;
    int false_alarms = 0;
    for (int round = 0; round < 24; ++round) {
      const auto place = [&] {
        return Eigen::Vector3d(0.05 + 0.2 * random.share(), 0.05 + 0.2 * random.share(), 0);
      };
      const std::vector<Eigen::Vector3d> points{place(), place(), place()};
      const std::string zone = round % 2 == 0 ? "" : " ZONE 20mm";
      const std::string text = move_to(points[0], " FINE") + move_to(points[1], zone) +
                               move_to(points[2], " FINE") + "STOP";
      const std::vector<Eigen::Vector3d> way = tool_way(law, text);
      const double reach = 0.012 * random.share();
      const Eigen::Vector3d into =
          ((points[0] - points[1]).normalized() + (points[2] - points[1]).normalized())
              .normalized();
      const Eigen::Vector3d ball = points[1] + reach * into;
      const double contact = kToolRadius + kBallRadius + 0.0005;
      const double from_way = from_line(way, ball);
      const double from_points =
          from_line({Eigen::Vector3d::Zero(), points[0], points[1], points[2]}, ball);
      const RunResult result = run_unforeseen(gantry_before(law, ball), text);
      CAPTURE(text);
      CAPTURE(ball.transpose());
      CAPTURE(from_way);
      if (from_way < contact) {
        ++hits;
        in_corners += from_points > contact ? 1 : 0;
        CHECK(result.error.has_value());
      } else if (from_points > contact) {
        false_alarms += result.error.has_value() ? 1 : 0;
      }
    }
    CHECK(hits > 3);
    CHECK(in_corners > 0);
    MESSAGE(law_name(law), ": ", hits, " hits, ", in_corners, " in corners, ", false_alarms,
            " false alarms");
    CHECK(false_alarms <= 5);
  }
}
