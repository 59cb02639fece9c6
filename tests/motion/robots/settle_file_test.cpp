// settle_distance, settle_angle and settle_time of a robot file.
#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "motion/robots/robot_file.h"
#include "motion/robots/robot_library.h"
#include "tests/support/degrees.h"

using namespace rob::motion;

namespace {

/// The gantry's file with these lines before its first table. Its encoders count 1 um, 0.001 deg.
RobotModel gantry_with(const std::string& lines) {
  for (const EmbeddedRobot& robot : embedded_robots()) {
    if (robot.name != "gantry") continue;
    std::string text(robot.text);
    text.insert(text.find("[[axis]]"), lines);
    return parse_robot_file(text, "my.toml");
  }
  throw std::logic_error("no gantry");
}

void check_refused(const std::string& lines, const std::string& part) {
  std::string error;
  try {
    gantry_with(lines);
  } catch (const RobotFileError& refused) {
    error = refused.what();
  }
  CAPTURE(lines);
  CAPTURE(error);
  CHECK(error.find("my.toml:") == 0);
  CHECK(error.find(part) != std::string::npos);
}

}  // namespace

TEST_CASE("no built-in robot has a window, and 1 s is what FINE with a distance has") {
  for (const EmbeddedRobot& robot : embedded_robots()) {
    const SettleWindow window = embedded_robot(robot.name).settle;
    CHECK_FALSE(window.present());
    CHECK(window.time == 1);
  }
}

TEST_CASE("each key of the window may be left out") {
  const SettleWindow whole =
      gantry_with(
          "settle_distance = \"0.1 mm\"\nsettle_angle = \"0.2 deg\"\nsettle_time = \"500 ms\"\n")
          .settle;
  CHECK(whole.distance == doctest::Approx(1e-4));
  CHECK(whole.angle == doctest::Approx(0.2 * rob::test::kDegree));
  CHECK(whole.time == 0.5);
  const SettleWindow distance = gantry_with("settle_distance = \"0.1 mm\"\n").settle;
  CHECK(distance.present());
  CHECK(std::isinf(distance.angle));
  CHECK(distance.time == 1);
  const SettleWindow angle = gantry_with("settle_angle = \"0.2 deg\"\n").settle;
  CHECK(angle.present());
  CHECK(std::isinf(angle.distance));
  const SettleWindow time = gantry_with("settle_time = \"3 s\"\n").settle;
  CHECK_FALSE(time.present());
  CHECK(time.time == 3);
}

TEST_CASE("a window that is absurd, or finer than an encoder counts, is refused") {
  check_refused("settle_distance = \"0 mm\"\n", "settle_distance: \"0 mm\" is out of range");
  check_refused("settle_distance = \"-1 mm\"\n", "out of range");
  check_refused("settle_distance = \"2 m\"\n", "out of range");
  check_refused("settle_distance = \"1 deg\"\n", "unit of something else");
  check_refused("settle_angle = \"90 deg\"\n", "out of range");
  check_refused("settle_time = \"5 ms\"\n", "out of range");  // a reference_period is 10 ms
  check_refused("settle_time = \"61 s\"\n", "out of range");
  check_refused("settle_angle = \"0.0005 deg\"\n",
                "settle_angle: is less than a count of axis theta");
}
