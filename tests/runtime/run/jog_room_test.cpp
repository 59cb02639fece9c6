// Jogs stop short of what is around the robot.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "base/split_mix.h"
#include "base/unit_factors.h"
#include "motion/generate/limit_numbers.h"
#include "motion/robots/robot_library.h"
#include "tests/support/no_allocation.h"
#include "tests/support/stepped_run.h"

using namespace rob::motion;
using rob::SplitMix;
using rob::runtime::RunResult;
using rob::runtime::Snapshot;
using rob::test::SteppedRun;

namespace {

/// A tool of 5 mm before a ball of 10 mm at x = 100 mm.
RobotModel gantry_at_ball() {
  RobotModel robot = embedded_robot("gantry");
  robot.collision.bodies = {{"tool", 4, {Capsule{.radius = 0.005}}}};
  robot.collision.obstacles = {{.name = "ball", .shape = Sphere{{0.1, 0, 0}, 0.01}}};
  return robot;
}

double farthest_x(const SteppedRun& run) {
  double most = 0;
  for (const Snapshot& row : run.rows) most = std::max(most, row.sample.reference.q[0]);
  return 1000 * most;
}

/// From the middle line of a capsule to another body, by a search along it.
double searched_distance(const Capsule& capsule, const Obstacle& obstacle) {
  constexpr int kParts = 100;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= kParts; ++i) {
    const Eigen::Vector3d at =
        capsule.from + (capsule.to - capsule.from) * (static_cast<double>(i) / kParts);
    double here = 0;
    if (const auto* ball = std::get_if<Sphere>(&obstacle.shape)) {
      here = (at - ball->centre).norm() - ball->radius;
    } else if (const auto* box = std::get_if<Box>(&obstacle.shape)) {
      const Eigen::Vector3d seen = place_of(at, inverse(box->centre));
      here = (seen.cwiseAbs() - box->half).cwiseMax(0).norm();
    } else {
      here = at.z() - std::get<HalfSpace>(obstacle.shape).height;
    }
    least = std::min(least, here - capsule.radius);
  }
  return least;
}

}  // namespace

TEST_CASE("a jog stops 5 mm before a body, and goes back from there") {
  for (const Law law : {Law::Paul, Law::LookAhead}) {
    RobotModel robot = gantry_at_ball();
    robot.law = law;
    SteppedRun run("JOG WORLD (x: 20mm/s) FOR 8s\nJOG WORLD (x: 10mm/s) FOR 2s\n", nullptr, 1,
                   robot);
    const RunResult result = run.run();
    CHECK(result.status == "done");
    // The middles are 15 mm apart where the two touch.
    CHECK(farthest_x(run) <= 80);
    CHECK(farthest_x(run) > 79);
    REQUIRE_FALSE(result.events.empty());
    CHECK(result.events[0].kind == "limit");
    CHECK(result.events[0].text == "the jog stops: tool is near ball");
    CHECK(std::ranges::any_of(
        run.rows, [](const Snapshot& row) { return row.sample.limit == limit_number::kBody; }));

    SteppedRun back("JOG WORLD (x: 20mm/s) FOR 8s\nJOG WORLD (x: -20mm/s) FOR 2s\n", nullptr, 1,
                    robot);
    CHECK(back.run().final_joints[0] < 60);
    SteppedRun beside("JOG WORLD (x: 20mm/s) FOR 8s\nJOG WORLD (y: 20mm/s) FOR 2s\n", nullptr, 1,
                      robot);
    CHECK(beside.run().final_joints[1] > 20);
  }
}

TEST_CASE("a jog that begins nearer than 5 mm may part, and not come nearer") {
  RobotModel robot = gantry_at_ball();
  robot.start = JointVector{{0.082, 0, 0}};  // 3 mm
  SteppedRun nearer("JOG WORLD (x: 5mm/s) FOR 3s\nSTOP", nullptr, 1, robot);
  CHECK(nearer.run().final_joints[0] <= 82.1);
  SteppedRun parts("JOG WORLD (x: -20mm/s) FOR 3s\nSTOP", nullptr, 1, robot);
  CHECK(parts.run().final_joints[0] < 60);
}

TEST_CASE("a robot without bodies jogs as it always did") {
  SteppedRun run("JOG WORLD (x: 20mm/s) FOR 5s\nSTOP");
  CHECK(run.run().final_joints[0] == doctest::Approx(100));
}

TEST_CASE("no jog of an arm comes near to what is around it") {
  // Random jogs above the table of the capping cell and beside a ball and a crate; distances by
  // a search along the links.
  RobotModel robot = embedded_robot("lwa4p");
  robot.cell.reset();
  robot.collision.obstacles = {
      {.name = "table", .shape = HalfSpace{0}},
      {.name = "ball", .shape = Sphere{{0.3, 0.35, 0.4}, 0.1}},
      {.name = "crate",
       .shape = Box{{{0.45, -0.3, 0.15}, orientation_from({0.1, 0.2, 0.4})}, {0.1, 0.1, 0.15}}}};
  SplitMix random(3);
  int held = 0;
  double least = 1;
  for (int round = 0; round < 4; ++round) {
    std::string text;
    for (int i = 0; i < 4; ++i) {
      const auto rate = [&](double most) {
        return std::to_string(most * (2 * random.share() - 1));
      };
      const std::string where = i % 2 == 0 ? "WORLD" : "TOOL";
      text += random.share() < 0.4
                  ? "JOG JOINT (j1: " + rate(60) + "deg/s, j2: " + rate(60) +
                        "deg/s, j3: " + rate(60) + "deg/s) FOR 1.2s\n"
                  : "JOG " + where + " (x: " + rate(300) + "mm/s, y: " + rate(300) +
                        "mm/s, z: " + rate(300) + "mm/s) FOR 1.2s\n";
    }
    CAPTURE(text);
    SteppedRun run(text, nullptr, 1, robot);
    run.run();
    for (const Snapshot& row : run.rows) {
      held += row.sample.limit == limit_number::kBody ? 1 : 0;
      const LinkFrames frames = robot.kinematics->frames(row.sample.reference.q);
      for (const Body& body : robot.collision.bodies)
        for (const Capsule& shape : body.shapes)
          for (const Obstacle& obstacle : robot.collision.obstacles) {
            if (body.frame == 0) continue;
            const Pose& frame = frames[static_cast<std::size_t>(body.frame - 1)];
            least = std::min(least, searched_distance(moved(shape, frame), obstacle));
          }
    }
    CHECK(least > 0.0049);
  }
  CHECK(held > 5);
  CHECK(least < 0.02);
  MESSAGE("held in ", held, " references; the least distance was ", 1000 * least, " mm");
}
