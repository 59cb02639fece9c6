#include "motion/robots/robot_file.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "motion/robots/robot_library.h"

using namespace rob::motion;

namespace {

/// A small complete robot; what is wrong in a test is put into it by edit(). Its lines are counted
/// in the tests.
const std::string kGood = R"(name = "table"
description = "a test"
kinematics = "gantry"
law = "paul"
t_acc = "1.375 s"
reference_period = "10 ms"
servo_period = "5 ms"
look_ahead = 64
[[axis]]
name = "x"
kind = "linear"
min = "0 mm"
max = "400 mm"
start = "0 mm"
v_max = "20 mm/s"
a_max = "100 mm/s^2"
j_max = "1000 mm/s^3"
[axis.drive]
inertia = "14 kg"
viscous_friction = "30 N*s/m"
coulomb_friction = "0.3 N"
force_max = "60 N"
encoder_resolution = "1 um"
bandwidth = "40 rad/s"
following_warn = "0.25 mm"
following_limit = "1 mm"
[[axis]]
name = "y"
kind = "linear"
min = "0 mm"
max = "300 mm"
start = "0 mm"
v_max = "20 mm/s"
a_max = "100 mm/s^2"
j_max = "1000 mm/s^3"
[axis.drive]
inertia = "9 kg"
viscous_friction = "20 N*s/m"
coulomb_friction = "0.3 N"
force_max = "60 N"
encoder_resolution = "1 um"
bandwidth = "40 rad/s"
following_warn = "0.25 mm"
following_limit = "1 mm"
[[axis]]
name = "theta"
kind = "rotary"
min = "-180 deg"
max = "180 deg"
start = "0 deg"
v_max = "20 deg/s"
a_max = "100 deg/s^2"
j_max = "1000 deg/s^3"
[axis.drive]
inertia = "0.02 kg*m^2"
viscous_friction = "0.02 Nm*s/rad"
coulomb_friction = "0.002 Nm"
force_max = "2 Nm"
encoder_resolution = "0.001 deg"
bandwidth = "40 rad/s"
following_warn = "0.25 deg"
following_limit = "1 deg"
[[signal]]
name = "lift"
direction = "output"
channel = 0
[[signal]]
name = "down"
direction = "input"
channel = 0
[[signal]]
name = "up"
direction = "input"
channel = 1
[[actuator]]
output = "lift"
off_input = "down"
on_input = "up"
travel_time = "0.5 s"
)";

/// The good file with the first `from` at or behind line `line` replaced.
std::string edit(int line, std::string_view from, std::string_view to) {
  std::size_t begin = 0;
  for (int n = 1; n < line; ++n) begin = kGood.find('\n', begin) + 1;
  const std::size_t at = kGood.find(from, begin);
  REQUIRE(at != std::string::npos);
  return std::string(kGood).replace(at, from.size(), to);
}

std::string error_of(std::string_view text) {
  try {
    parse_robot_file(text, "my.toml");
    return "";
  } catch (const RobotFileError& error) {
    return error.what();
  }
}

std::string in_quotes(std::string_view name) { return std::string("\"").append(name).append("\""); }

/// The error begins with file:line: and says `part`.
void check_error(const std::string& text, int line, std::string_view part) {
  const std::string error = error_of(text);
  CAPTURE(error);
  CHECK(error.starts_with("my.toml:" + std::to_string(line) + ":"));
  CHECK(error.find(part) != std::string::npos);
}

}  // namespace

TEST_CASE("a message shows what cannot be printed, and says all that it has to say") {
  check_error(edit(1, "name = \"table\"", "name = \"ta\\u0000b\\u001B\\nle\""), 1,
              "name: \"ta\\u0000b\\u001B\\u000Ale\" is no name; write a small letter");
  check_error(edit(1, "name = \"table\"", "name = \"table\"\n\"ke\\u0000y\" = 3"), 2,
              "unknown key \"ke\\u0000y\"; known are");
  check_error(edit(1, "travel_time = \"0.5 s\"", "travel_time = \"0.5\\u0000 s\""), 79,
              "\"0.5\\u0000 s\"");
}

TEST_CASE("a complete robot file is read") {
  const RobotModel robot = parse_robot_file(kGood, "my.toml");
  CHECK(robot.name == "table");
  CHECK(robot.axes[0].drive.inertia == 14);
  CHECK(robot.axes[0].drive.encoder_resolution == 1e-6);
  CHECK(robot.axes[1].max == 0.3);
  CHECK(robot.look_ahead == 64);
  CHECK(robot.actuators[0].input_on == 1);
}

TEST_CASE("a missing entry is refused, at its table") {
  check_error(edit(1, "t_acc = \"1.375 s\"\n", ""), 1, "t_acc: is missing");
  check_error(edit(9, "max = \"400 mm\"\n", ""), 9, "max of axis x: is missing");
  check_error(edit(18, "inertia = \"14 kg\"\n", ""), 18, "inertia of drive of axis x: is missing");
  check_error("name = \"a\"\ndescription = \"\"\n", 1, "is missing");
}

TEST_CASE("an unknown key is refused with what was probably meant, never ignored") {
  check_error(edit(15, "v_max", "v_maks"), 15,
              "unknown key \"v_maks\" in axis 1; did you mean "
              "\"v_max\"?");
  check_error(edit(1, "look_ahead = 64", "look_ahead = 64\ncolour = 3"), 9,
              "unknown key \"colour\"; known are");
  check_error(edit(19, "inertia", "inertya"), 19, "did you mean \"inertia\"?");
}

TEST_CASE("the column points at what is wrong") {
  CHECK(error_of(edit(15, "\"20 mm/s\"", "\"0 mm/s\"")).starts_with("my.toml:15:9: "));
}

TEST_CASE("a double key is refused") {
  check_error(edit(1, "law = \"paul\"", "law = \"paul\"\nlaw = \"paul\""), 5, "law");
}

TEST_CASE("a value of the wrong type is refused") {
  check_error(edit(5, "\"1.375 s\"", "1.375"), 5, "number with its unit, in quotation marks");
  check_error(edit(8, "64", "\"64\""), 8, "whole number from 2 to 16384");
  check_error(edit(8, "64", "64.5"), 8, "whole number");
  check_error(edit(1, "\"table\"", "7"), 1, "text in quotation marks");
  check_error(edit(66, "channel = 0", "channel = true"), 66, "whole number from 0 to 63");
}

TEST_CASE("a unit that does not fit is refused") {
  check_error(edit(15, "20 mm/s", "20 mm"), 15, "unit of something else");
  check_error(edit(15, "20 mm/s", "20 deg/s"), 15, "unit of something else");
  check_error(edit(15, "20 mm/s", "20"), 15, "has no unit");
  check_error(edit(51, "20 deg/s", "20 mm/s"), 51, "unit of something else");
}

TEST_CASE("zero, negative and absurd values are refused") {
  for (const char* value : {"0 mm/s", "-20 mm/s", "20000 m/s", "1e-9 mm/s"})
    check_error(edit(15, "20 mm/s", value), 15, "out of range; it must lie from 1e-06 to 10 m/s");
  check_error(edit(5, "1.375 s", "0 s"), 5, "out of range");
  check_error(edit(6, "10 ms", "10 s"), 6, "out of range");
  check_error(edit(13, "400 mm", "400 m"), 13, "out of range");
  check_error(edit(16, "100 mm", "0 mm"), 16, "out of range");
  check_error(edit(17, "1000 mm", "-1 mm"), 17, "out of range");
  check_error(edit(19, "14 kg", "0 kg"), 19, "out of range");
  check_error(edit(20, "30", "-1"), 20, "out of range");
  check_error(edit(23, "1 um", "0 um"), 23, "out of range");
  check_error(edit(8, "64", "1"), 8, "from 2 to 16384");
  check_error(edit(8, "64", "100000000000000000"), 8, "from 2 to 16384");
  check_error(edit(79, "0.5 s", "0 s"), 79, "out of range");
}

TEST_CASE("limits that contradict each other are refused") {
  check_error(edit(12, "0 mm", "400 mm"), 12, "min of axis x: must be less than max");
  check_error(edit(14, "0 mm", "401 mm"), 14, "start of axis x: must lie from min to max");
  check_error(edit(25, "0.25 mm", "2 mm"), 25, "more than following_limit");
  // 14 kg at 0.1 m/s² and 30 N·s/m at 0.02 m/s and 0.3 N are 2.3 N.
  check_error(edit(22, "60 N", "2 N"), 22, "a_max at v_max takes 2.3 N");
}

TEST_CASE("a count that no axis can move in a servo period is refused: it would always be a jump") {
  // x: 2·20 mm/s·5 ms = 0.2 mm
  check_error(edit(23, "1 um", "0.21 mm"), 23,
              "encoder_resolution of drive of axis x: 0.00021 m a count is more than the axis"
              " can move in a servo_period (0.0002 m): every run would end in E504");
  CHECK(error_of(edit(23, "1 um", "0.19 mm")) == "");
  check_error(edit(15, "20 mm/s", "0.05 mm/s"), 23, "every run would end in E504");
}

TEST_CASE("a servo that is slower than its references, or a hundred times as fast, is refused") {
  check_error(edit(7, "5 ms", "10.1 ms"), 7, "must not be longer than reference_period");
  CHECK(parse_robot_file(edit(7, "5 ms", "3 ms"), "my.toml").servo_period == 0.003);
  CHECK(parse_robot_file(edit(7, "5 ms", "10 ms"), "my.toml").servo_period == 0.010);
  check_error(edit(7, "5 ms", "0.05 ms"), 7, "not be more than 100 times as long");
  CHECK(parse_robot_file(edit(7, "5 ms", "0.1 ms"), "my.toml").servo_period == 0.0001);
  check_error(edit(5, "1.375 s", "5 ms"), 5, "less than reference_period");
}

TEST_CASE("jerk may be left out, and is then unlimited") {
  const RobotModel robot = parse_robot_file(edit(17, "j_max = \"1000 mm/s^3\"\n", ""), "my.toml");
  CHECK(std::isinf(robot.axes[0].j_max));
  CHECK(robot.axes[1].j_max == 1);
  for (const char* value : {"0 mm/s^3", "inf mm/s^3", "nan mm/s^3"})
    CHECK(error_of(edit(17, "1000 mm/s^3", value)).starts_with("my.toml:17:"));
}

TEST_CASE("a robot without t_acc has the look-ahead law alone") {
  const std::string without = edit(5, "t_acc = \"1.375 s\"\n", "");
  check_error(without, 1, "t_acc: is missing: Paul's law needs it; law = \"lookahead\" does not");
  std::string ahead = without;
  ahead.replace(ahead.find("\"paul\""), 6, "\"lookahead\"");
  const RobotModel robot = parse_robot_file(ahead, "my.toml");
  CHECK(robot.law == Law::LookAhead);
  CHECK(robot.t_acc == 0);
  // Limits of which Paul's law could make nothing.
  ahead.replace(ahead.find("100 mm/s^2"), 10, "20 mm/s^2");
  CHECK(parse_robot_file(ahead, "my.toml").axes[0].a_max == 0.02);
  // With a t_acc it can be run under both, and has to keep what Paul's needs.
  std::string both = edit(4, "paul", "lookahead");
  CHECK(parse_robot_file(both, "my.toml").t_acc == 1.375);
  both.replace(both.find("100 mm/s^2"), 10, "20 mm/s^2");
  check_error(both, 16, "Paul's law needs 1.5*v_max/t_acc");
}

TEST_CASE("look-ahead's corners miss by what the file says, else by 1 mm and 1 deg") {
  const RobotModel robot = parse_robot_file(kGood, "my.toml");
  CHECK(robot.zone.distance == 0.001);
  CHECK(robot.zone.angle == std::numbers::pi / 180);
  const std::string zoned =
      edit(1, "look_ahead = 64", "zone = \"5 mm\"\nzone_angle = \"3 deg\"\nlook_ahead = 64");
  CHECK(parse_robot_file(zoned, "my.toml").zone.distance == 0.005);
  CHECK(parse_robot_file(zoned, "my.toml").zone.angle == doctest::Approx(std::numbers::pi / 60));
  for (const char* value : {"0 mm", "-1 mm", "2 m", "5"}) {
    const std::string line = std::string("zone = \"") + value + "\"\nlook_ahead = 64";
    CHECK(error_of(edit(1, "look_ahead = 64", line)).starts_with("my.toml:8:8: zone"));
  }
}

TEST_CASE("Paul's corners must keep within the acceleration and the jerk of every axis") {
  // 1.5·0.02/1.375 = 0.0218 m/s²; 3·0.02/1.375² = 0.0317 m/s³.
  check_error(edit(16, "100 mm/s^2", "21 mm/s^2"), 16, "1.5*v_max/t_acc = 0.02182 m/s^2");
  check_error(edit(17, "1000 mm/s^3", "31 mm/s^3"), 17, "3*v_max/t_acc^2 = 0.03174 m/s^3");
  check_error(edit(16, "100 mm/s^2", "22 mm/s^2"), 5, "stop on the path within 1 s");
}

TEST_CASE("names are names, and stand once") {
  check_error(edit(28, "\"y\"", "\"x\""), 28, "another axis of this name");
  check_error(edit(68, "\"down\"", "\"lift\""), 68, "another signal or axis of this name");
  check_error(edit(68, "\"down\"", "\"theta\""), 68, "another signal or axis of this name");
  for (const char* name : {"", "X", "1x", "x y", "é", "abcdefghijklmnopqrstuvwxyz_0123456"})
    check_error(edit(10, "\"x\"", in_quotes(name)), 10, "is no name");
}

TEST_CASE("channels lie within range and belong to one signal each way") {
  check_error(edit(66, "channel = 0", "channel = 64"), 66, "whole number from 0 to 63");
  check_error(edit(66, "channel = 0", "channel = -1"), 66, "whole number from 0 to 63");
  check_error(edit(74, "channel = 1", "channel = 0"), 74, "is that of signal down");
}

TEST_CASE("channels without a name are counted where the file says so") {
  const RobotModel silent = parse_robot_file(edit(1, "", ""), "file.toml");
  CHECK(silent.outputs == 1);  // as many as have names
  CHECK(silent.inputs == 2);
  const RobotModel counted = parse_robot_file(edit(1, "", "inputs = 16\noutputs = 64\n"), "f.toml");
  CHECK(counted.outputs == 64);
  CHECK(counted.inputs == 16);
  check_error(edit(1, "", "inputs = 65\n"), 1, "whole number from 0 to 64");
  check_error(edit(1, "", "inputs = 1\n"), 1, "a signal has channel 1");
}

TEST_CASE("an actuator is driven by an output and seen by two inputs") {
  check_error(edit(76, "\"lift\"", "\"up\""), 76, "is not known");
  check_error(edit(77, "\"down\"", "\"dwn\""), 77, "did you mean \"down\"?");
  check_error(edit(78, "\"up\"", "\"down\""), 78, "another input than off_input");
}

TEST_CASE("unknown words are refused with what was probably meant") {
  check_error(edit(4, "\"paul\"", "\"pual\""), 4, "did you mean \"paul\"?");
  check_error(edit(11, "\"linear\"", "\"sideways\""), 11,
              "is not known; known are \"linear\", \"rotary\"");
}

TEST_CASE("a gantry has two or three linear axes, then at most a rotary one") {
  const std::size_t y = kGood.find("[[axis]]\nname = \"y\"");
  const std::size_t theta = kGood.find("[[axis]]\nname = \"theta\"");
  const std::size_t end = kGood.find("[[signal]]");
  const std::string axis_y = kGood.substr(y, theta - y);
  const auto without = [](std::size_t from, std::size_t to) {
    return std::string(kGood).erase(from, to - from);
  };
  check_error(without(y, theta), 3, "two or three linear axes, then at most a rotary one");
  CHECK(parse_robot_file(without(theta, end), "my.toml").kinematics->axes() == 2);
  std::string four = without(0, 0);
  four.insert(theta, std::string(axis_y).replace(axis_y.find("\"y\""), 3, "\"z\""));
  const RobotModel robot = parse_robot_file(four, "my.toml");
  CHECK(robot.kinematics->axes() == 4);
  CHECK(robot.kinematics->coordinate(3) == 5);  // theta turns about z
  for (const auto& [name, part] : {std::pair{"\"a\"", 3}, std::pair{"\"b\"", 4}}) {
    std::string turned = four;
    turned.replace(turned.find("\"theta\""), 7, name);
    CHECK(parse_robot_file(turned, "my.toml").kinematics->coordinate(3) == part);
  }
}

TEST_CASE("tables are written as tables, and axes are few") {
  std::string text = kGood;
  text.erase(text.find("[[signal]]"));
  const std::string nine_axes = [&] {
    std::string many = text;
    const std::size_t x = text.find("[[axis]]");
    const std::size_t y = text.find("[[axis]]", x + 1);
    for (int i = 0; i < 6; ++i) many += text.substr(x, y - x);
    return many;
  }();
  check_error(nine_axes, 9, "more than 8 axes");
  check_error("signal = 3\n" + text, 1, "written as tables [[signal]]");
  check_error("signal = [3]\n" + text, 1, "written as tables [[signal]]");
  check_error("axis = []\n" + text.substr(0, text.find("[[axis]]")), 1, "is missing");
  check_error(edit(18, "[axis.drive]\n", "drive = 3\n[axis.deive]\n"), 19, "unknown key \"deive\"");
}

TEST_CASE("what is no TOML is refused with its place, whatever it is") {
  check_error(edit(15, "v_max =", "v_max"), 15, "");
  check_error(std::string("name = \"a\"\n\0\xff\xfe garbage", 21), 2, "");
  check_error("name = \"never closed\nlaw = 3\n", 1, "");
  CHECK_FALSE(error_of("").empty());
  CHECK_FALSE(error_of(std::string(100'000, '[')).empty());
  CHECK_FALSE(error_of("name = " + std::string(100'000, '[')).empty());
}

TEST_CASE("a file cut off anywhere is refused or read, and never does harm") {
  for (std::size_t length = 0; length < kGood.size(); length += 7) {
    const std::string error = error_of(kGood.substr(0, length));
    CHECK((error.empty() || error.starts_with("my.toml:")));
  }
}

TEST_CASE("an arm has six rotary axes") {
  const RobotModel arm = embedded_robot("lwa4p");
  CHECK(arm.axis_count() == 6);
  CHECK(arm.tool_coordinates);
  CHECK(arm.force_sensor);
  CHECK(arm.kinematics->axes() == 6);
  CHECK_FALSE(embedded_robot("ums7").force_sensor);
  CHECK(error_of(edit(3, "gantry", "arm")) ==
        "my.toml:3:14: kinematics: an arm has six rotary axes");
}

TEST_CASE("a robot has a force sensor if its file says so") {
  const RobotModel robot =
      parse_robot_file(edit(8, "look", "force_sensor = true\nlook"), "my.toml");
  CHECK(robot.force_sensor);
  CHECK_FALSE(robot.tool_coordinates);
  CHECK(error_of(edit(8, "look", "force_sensor = \"yes\"\nlook"))
            .find("force_sensor: must be true or false") != std::string::npos);
}
