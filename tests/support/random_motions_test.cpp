#include "tests/support/random_motions.h"

#include <doctest/doctest.h>

using rob::test::MotionRobot;
using rob::test::random_motions;
using rob::test::RandomMotions;

namespace {

MotionRobot three_axes() {
  MotionRobot robot;
  robot.least = {-200, -200, -200};
  robot.most = {200, 200, 200};
  robot.reach = 150;
  robot.zone = 1;
  robot.least_speed = 20;
  robot.most_speed = 600;
  robot.look_ahead = true;
  return robot;
}

}  // namespace

TEST_CASE("random motions: the same number makes the same program, another number another") {
  CHECK(random_motions(7, three_axes()).text == random_motions(7, three_axes()).text);
  CHECK(random_motions(7, three_axes()).signals == random_motions(7, three_axes()).signals);
  CHECK(random_motions(7, three_axes()).text != random_motions(8, three_axes()).text);
}

TEST_CASE("random motions: the way stays in its box, and each point has its bound") {
  for (std::uint64_t number = 1; number <= 300; ++number) {
    const RandomMotions made = random_motions(number, three_axes());
    CAPTURE(number);
    REQUIRE(made.misses.size() == made.path.points.size());
    CHECK(made.path.points.back() + 1 == made.path.places.size());
    for (const auto& place : made.path.places) REQUIRE(place.cwiseAbs().maxCoeff() <= 200);
    for (const double miss : made.misses) REQUIRE(miss > 0);
  }
}

TEST_CASE("random motions: every kind of statement comes") {
  std::string all;
  for (std::uint64_t number = 1; number <= 300; ++number)
    all += random_motions(number, three_axes()).text;
  for (const char* word :
       {"MOVE(",     "MOVEL(",    "MOVEL BY",  "MOVEC VIA", "MOVES VIA", "PROFILE COSINE",
        "JOG WORLD", "JOG JOINT", "JOG TOOL",  "STOP",      "WAIT ",     "BRAKE",
        "OVERRIDE ", "PATH DO",   "WHEN DIN[", "UNTIL DIN", "ENDMOVE",   "AFTER",
        "BEFORE",    " LEAD ",    " LAG ",     "FINE",      "ZONE 0\n",  "mm ",
        "% ",        "OVER ",     "ACCEL ",    "JERK ",     "DOUT[",     "HALT \"held\""}) {
    CAPTURE(word);
    CHECK(all.find(word) != std::string::npos);
  }
}

TEST_CASE("random motions: an arm has tools, for all of a program or for a part, and turns") {
  MotionRobot arm = three_axes();
  arm.kind = MotionRobot::Kind::Arm;
  std::string all;
  bool tools = false;
  for (std::uint64_t number = 1; number <= 300; ++number) {
    const RandomMotions made = random_motions(number, arm);
    tools = tools || !made.tool.isZero();
    all += made.text;
  }
  CHECK(tools);
  for (const char* word : {"TOOL tip", "WITH tip DO", "WITH none DO", "ENDWITH", "deg/s^2", "deg\n",
                           "AT 30deg/s", "b: "}) {
    CAPTURE(word);
    CHECK(all.find(word) != std::string::npos);
  }
}
