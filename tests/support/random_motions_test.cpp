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
       {"MOVE(",      "MOVEL(",  "MOVEL BY", "MOVEC VIA", "MOVES VIA", "PROFILE COSINE",
        "JOG WORLD",  "STOP",    "WAIT ",    "BRAKE",     "OVERRIDE ", "WHEN DIN[1] : HALT",
        "UNTIL DIN[", "ENDMOVE", "AFTER",    "BEFORE",    "FINE",      "ZONE 0\n",
        "mm ",        "% ",      "OVER ",    "ACCEL ",    "JERK ",     "DOUT["}) {
    CAPTURE(word);
    CHECK(all.find(word) != std::string::npos);
  }
}
