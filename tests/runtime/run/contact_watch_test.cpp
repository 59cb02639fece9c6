// What `rob check` finds in the way of a robot.
#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "motion/robots/robot_library.h"
#include "runtime/run/foretell.h"
#include "runtime/run/run.h"

using namespace rob::motion;
using rob::runtime::Contact;
using rob::runtime::ExitCode;
using rob::runtime::RunResult;

namespace {

/// S1's gantry with a round tool of 10 mm, among these things.
RobotModel gantry_among(std::vector<Obstacle> things) {
  RobotModel robot = embedded_robot("gantry");
  robot.collision.bodies = {{"tool", 4, {Capsule{.radius = 0.005}}}};
  robot.collision.obstacles = std::move(things);
  return robot;
}

RunResult foretold_on(const RobotModel& robot, const std::string& text) {
  const auto program = rob::runtime::compile_program("t.rob", text, robot);
  REQUIRE(program.runnable());
  return rob::runtime::foretell(program, robot);
}

std::vector<std::string> found_in(const RunResult& result) {
  std::vector<std::string> texts;
  for (const auto& found : result.findings)
    texts.push_back(std::to_string(found.place.line) + " " + found.code + " " + found.message);
  return texts;
}

const Obstacle kBall{.name = "ball", .shape = Sphere{{0.1, 0.04, 0}, 0.01}};

}  // namespace

TEST_CASE("a motion that hits something is an error, with the time and the axes") {
  // From (40, 40) along x at 20 mm/s. Paul's start from rest takes 2.75 s and 27.5 mm, so that
  // after t seconds x = 40 + 20·(t − 1.375). The tool's middle comes within 15 + 0.5 mm of the
  // ball's at x = 84.5, after 2.225 + 1.375 = 3.6 s.
  const RunResult result =
      foretold_on(gantry_among({kBall}), "MOVE(40, 40, 0) FINE\nMOVE(140, 40, 0)\nMOVE(40, 40, 0)");
  REQUIRE(result.contact.has_value());
  const Contact& contact = *result.contact;
  CHECK(contact.line == 2);
  CHECK(contact.body == "tool");
  CHECK(contact.other == "ball");
  CHECK(contact.at == doctest::Approx(3.6).epsilon(0.01));
  CHECK(contact.q[0] == doctest::Approx(0.0845).epsilon(0.005));
  CHECK(result.exit_code == ExitCode::ProgramError);
  REQUIRE(result.error.has_value());
  CHECK(result.error->code == "E580");
  CHECK(result.error->message.starts_with("tool hits ball 3.6"));
  CHECK(result.error->message.find(" s after the start of line 2, at JOINTS(84.") !=
        std::string::npos);
}

TEST_CASE("what is passed closely is a warning, once a line") {
  Obstacle beside = kBall;
  beside.shape = Sphere{{0.1, 0.063, 0}, 0.01};  // 8 mm beside the way
  const RobotModel robot = gantry_among({beside});
  CHECK(found_in(foretold_on(robot, "MOVE(40, 40, 0) FINE\nMOVE(140, 40, 0)")) ==
        std::vector<std::string>{"2 W680 tool passes ball at a distance of 8 mm"});
  CHECK(found_in(foretold_on(robot, "MOVE(40, 40, 0) FINE\nMOVE(140, 36, 0)")).empty());
}

TEST_CASE("the time of a contact counts from its own motion, not from the first of its line") {
  // Twenty motions of one line; the fourth goes from x = 30 to 40 and comes within 15.5 mm of the
  // ball, whose middle is at 52, at x = 36.5.
  Obstacle ahead = kBall;
  ahead.shape = Sphere{{0.052, 0.04, 0}, 0.01};
  const RunResult result =
      foretold_on(gantry_among({ahead}),
                  "MOVE(0, 40, 0) FINE\nFOR i = 1 TO 20 DO\nMOVE(10 * i, 40, 0) FINE\nENDFOR");
  REQUIRE(result.contact.has_value());
  CHECK(result.contact->line == 3);
  CHECK(result.contact->q[0] == doctest::Approx(0.0365).epsilon(0.01));
  CHECK(result.contact->at > 0);
  CHECK(result.contact->at < 5.5);  // what such a motion takes from rest to rest
}

TEST_CASE("who leaves a contact is told how deep it is") {
  Obstacle crate = kBall;
  crate.name = "crate";
  crate.shape = Box{{{0.0, 0.04, 0}, Eigen::Quaterniond::Identity()}, {0.02, 0.2, 0.2}};
  const RobotModel robot = gantry_among({crate});
  CHECK(found_in(foretold_on(robot, "MOVE(100, 0, 0)")) ==
        std::vector<std::string>{"1 W680 tool leaves crate, which it touches: 25 mm deep"});
  const RunResult pressed = foretold_on(robot, "MOVE(0, 20, 0) FINE\nMOVE(60, 20, 0)");
  CHECK_FALSE(pressed.error.has_value());
  // From near its side on to its middle.
  crate.shape = Box{{{0.04, 0, 0}, Eigen::Quaterniond::Identity()}, {0.045, 0.2, 0.2}};
  const RunResult deeper = foretold_on(gantry_among({crate}), "MOVE(20, 0, 0)");
  REQUIRE(deeper.error.has_value());
  CHECK(deeper.error->code == "E581");
}

TEST_CASE("a rounded corner is part of the way") {
  // The corner at (140, 40) misses its point by some millimetres: a ball just outside of it is
  // passed, and is hit where the robot stops in the corner.
  Obstacle outside = kBall;
  outside.shape = Sphere{{0.1455, 0.0345, 0}, 0.003};
  const RobotModel robot = gantry_among({outside});
  const std::string ends = "MOVE(140, 140, 0)";
  CHECK_FALSE(foretold_on(robot, "MOVE(40, 40, 0) FINE\nMOVE(140, 40, 0)\n" + ends).contact);
  CHECK(foretold_on(robot, "MOVE(40, 40, 0) FINE\nMOVE(140, 40, 0) FINE\n" + ends).contact);
}

TEST_CASE("who begins in contact may leave, and not press on") {
  Obstacle here = kBall;
  here.shape = Sphere{{0.005, 0, 0}, 0.005};
  const RobotModel robot = gantry_among({here});
  REQUIRE(robot.start.isZero());
  CHECK_FALSE(foretold_on(robot, "MOVE(0, 20, 0)").contact);
  const RunResult pressed = foretold_on(robot, "MOVE(60, 0, 0)");
  REQUIRE(pressed.error.has_value());
  CHECK(pressed.error->code == "E581");
}

TEST_CASE("the elbow of the capping arm must stay above the table") {
  // θ2 = 140°: the elbow is at 205 + 350·cos 140° = −63 mm.
  const RobotModel& robot = embedded_robot("lwa4p");
  const RunResult result =
      foretold_on(robot, "MOVE JOINTS(-150deg, 140deg, 140deg, 0deg, 0deg, 0deg)");
  REQUIRE(result.error.has_value());
  CHECK(result.error->code == "E580");
  REQUIRE(result.contact.has_value());
  CHECK(result.contact->other == "table");
  CHECK_FALSE(foretold_on(robot, "MOVE JOINTS(30deg, 40deg, -80deg, 0deg, -60deg, 0deg)").error);
}

TEST_CASE("in a run a motion is proved before it is queued") {
  // run() itself foretells nothing under Paul's law.
  const RobotModel robot = gantry_among({kBall});
  const auto result_of = [&](const std::string& text) {
    const auto program = rob::runtime::compile_program("t.rob", text, robot);
    REQUIRE(program.runnable());
    rob::runtime::RunOptions options;
    options.fast = true;
    return rob::runtime::run(program, robot, options, {});
  };
  const RunResult stopped =
      result_of("MOVE(40, 40, 0) FINE\nMOVE(140, 40, 0)\nPRINT \"not reached\"");
  REQUIRE(stopped.error.has_value());
  CHECK(stopped.error->code == "E580");
  CHECK(stopped.error->place.line == 2);
  // 44.5 of 100 mm.
  CHECK(stopped.error->message.starts_with("tool hits ball "));
  CHECK(stopped.exit_code == ExitCode::Fault);
  CHECK(stopped.output.empty());
  // It stands where the last motion that was proved has ended.
  CHECK(stopped.final_joints.at(0) == doctest::Approx(40));

  const RunResult caught = result_of(
      "MOVE(40, 40, 0) FINE\nTRY\nMOVE(140, 40, 0)\nRESCUE why\nMOVE(40, 100, 0)\nENDTRY\n"
      "MOVE(140, 100, 0)\nSTOP");
  CHECK_FALSE(caught.error.has_value());
  CHECK(caught.final_joints.at(0) == doctest::Approx(140));

  // Along a line of the tool, and for one that goes round.
  CHECK(result_of("MOVE(40, 40, 0) FINE\nMOVEL(140, 40, 90)").error.has_value());
  CHECK_FALSE(
      result_of("MOVE(40, 40, 0) FINE\nMOVEC VIA (100, 80, 0) TO (160, 40, 0)").error.has_value());
}
