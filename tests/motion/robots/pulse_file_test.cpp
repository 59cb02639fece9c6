#include <doctest/doctest.h>

#include <string>

#include "motion/robots/robot_file.h"
#include "motion/robots/robot_library.h"
#include "tests/support/relative.h"

using namespace rob::motion;

namespace {

std::string text_of(const char* name) {
  for (const EmbeddedRobot& robot : embedded_robots())
    if (robot.name == name) return std::string(robot.text);
  FAIL("no such robot");
  return "";
}

std::string edited(const char* name, const std::string& was, const std::string& is) {
  std::string text = text_of(name);
  REQUIRE(text.find(was) != std::string::npos);
  return text.replace(text.find(was), was.size(), is);
}

std::string pulse_error(const std::string& text) {
  try {
    parse_robot_file(text, "arm.toml");
  } catch (const RobotFileError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("S3's arm is moved by pulses under a double loop") {
  const RobotModel robot = embedded_robot("pc104");
  CHECK(robot.servo == ServoStructure::DoubleLoop);
  const PulseDriveData& last = robot.axes[5].pulses;
  CHECK(last.pulse == rob::test::relative(1.7453292519943296e-5));
  CHECK(last.speed_stiffness == 5);
  CHECK(last.ripple == 0.1);
  CHECK(last.ripple_period == rob::test::relative(2.25 * 1.7453292519943296e-2));
  CHECK(embedded_robot("gantry").servo == ServoStructure::Force);
}

TEST_CASE("another structure is a word in the file") {
  const auto servo = [](const char* word) {
    const std::string text = edited("pc104", "servo = \"double_loop\"", word);
    return parse_robot_file(text, "arm.toml").servo;
  };
  CHECK(servo("servo = \"position_loop\"") == ServoStructure::PositionLoop);
  const std::string message =
      pulse_error(edited("pc104", "servo = \"double_loop\"", "servo = \"double\""));
  CHECK(message.find("double_loop") != std::string::npos);
}

TEST_CASE("a pulse train that leaves the axis too far behind is refused") {
  // 60 °/s · 4·30/(1500 + 40)/(1 + 40/1500) = 4.55°, following_limit is 2°.
  const std::string message =
      pulse_error(edited("pc104", "servo = \"double_loop\"", "servo = \"pulse_train\""));
  CHECK(message.find("v_max of axis j1") != std::string::npos);
  CHECK(message.find("0.0795 rad late") != std::string::npos);
}

TEST_CASE("pulses and forces do not mix") {
  std::string text = edited("pc104", "servo = \"double_loop\"", "servo = \"force\"");
  CHECK(pulse_error(text).find("pulse_drive") != std::string::npos);
  text = edited("pc104", "[axis.pulse_drive]", "[axis.pulse]");
  CHECK(pulse_error(text).find("unknown key \"pulse\"") != std::string::npos);
  text = edited("ums7", "look_ahead = 64", "look_ahead = 64\nservo = \"double_loop\"");
  CHECK(pulse_error(text).find("[dynamics] is fed forward as forces") != std::string::npos);
  text = edited("gantry", "look_ahead = 64", "look_ahead = 64\nservo = \"double_loop\"");
  CHECK(pulse_error(text).find("pulse_drive") != std::string::npos);
}

TEST_CASE("a pulse drive that is faster than the simulation is refused") {
  const std::string text =
      edited("pc104", "speed_stiffness = \"5 Nm*s/rad\"", "speed_stiffness = \"100 Nm*s/rad\"");
  CHECK(pulse_error(text).find("pulse_drive of axis j6") != std::string::npos);
  CHECK(pulse_error(edited("pc104", "pulse = \"0.001 deg\"", "pulse = \"0 deg\"")).size() > 0);
}
