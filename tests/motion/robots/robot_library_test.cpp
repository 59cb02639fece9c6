#include "motion/robots/robot_library.h"

#include <doctest/doctest.h>

#include <sys/stat.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numbers>
#include <string>
#include <utility>

#include "motion/robots/robot_file.h"
#include "tests/support/scratch_folder.h"

using namespace rob::motion;

namespace {

const RobotSignal& signal(const RobotModel& robot, std::string_view name) {
  return *std::find_if(robot.signals.begin(), robot.signals.end(),
                       [&](const RobotSignal& s) { return s.name == name; });
}

}  // namespace

TEST_CASE("the gantry is S1's") {
  const RobotModel robot = embedded_robot("gantry");
  CHECK(robot.name == "gantry");
  CHECK(robot.law == Law::Paul);
  CHECK(robot.reference_period == 0.01);
  CHECK(robot.servo_period == 0.005);
  CHECK(robot.t_acc == 1.375);
  REQUIRE(robot.axis_count() == 3);
  const char* names[] = {"x", "y", "theta"};
  const double min[] = {0, 0, -std::numbers::pi};
  const double max[] = {0.4, 0.3, std::numbers::pi};
  const double unit[] = {0.001, 0.001, std::numbers::pi / 180};
  for (std::size_t i = 0; i < 3; ++i) {
    const Axis& axis = robot.axes[i];
    CHECK(axis.name == names[i]);
    CHECK(axis.kind == (i < 2 ? AxisKind::Linear : AxisKind::Rotary));
    CHECK(axis.min == doctest::Approx(min[i]));
    CHECK(axis.max == doctest::Approx(max[i]));
    CHECK(axis.v_max == doctest::Approx(20 * unit[i]));
    CHECK(axis.a_max == doctest::Approx(100 * unit[i]));
    CHECK(axis.j_max == doctest::Approx(1000 * unit[i]));
    CHECK(robot.start[static_cast<int>(i)] == 0);
  }
  REQUIRE(robot.kinematics);
  CHECK(robot.kinematics->axes() == 3);
}

TEST_CASE("the gantry lifts and grips by signals that take time") {
  const RobotModel robot = embedded_robot("gantry");
  CHECK(robot.signals.size() == 6);
  CHECK(robot.inputs == 16);
  CHECK(robot.outputs == 16);
  CHECK(signal(robot, "lift").output);
  CHECK(signal(robot, "gripper").output);
  for (const char* name : {"lift_up", "lift_down", "gripper_open", "gripper_closed"})
    CHECK_FALSE(signal(robot, name).output);
  REQUIRE(robot.actuators.size() == 2);
  const TwoPositionActuator& lift = robot.actuators[0];
  CHECK(lift.output == signal(robot, "lift").channel);
  CHECK(lift.input_on == signal(robot, "lift_up").channel);
  CHECK(lift.input_off == signal(robot, "lift_down").channel);
  CHECK(lift.travel_time == 0.5);
  const TwoPositionActuator& gripper = robot.actuators[1];
  CHECK(gripper.output == signal(robot, "gripper").channel);
  CHECK(gripper.input_on == signal(robot, "gripper_closed").channel);
  CHECK(gripper.input_off == signal(robot, "gripper_open").channel);
  CHECK(gripper.travel_time == 0.1);
}

TEST_CASE("every robot that Rob carries can be read and is called as its file") {
  REQUIRE_FALSE(robot_names().empty());
  for (const std::string_view name : robot_names()) CHECK(embedded_robot(name).name == name);
}

TEST_CASE("an unknown robot is refused, with the name that was probably meant") {
  CHECK_THROWS_WITH_AS(embedded_robot("gantyr"),
                       "there is no robot 'gantyr'; did you mean 'gantry'?", RobotFileError);
  try {
    embedded_robot("hexapod");
    FAIL("hexapod is not known");
  } catch (const RobotFileError& error) {
    CHECK(std::string(error.what()).find("known are fr3") != std::string::npos);
  }
}

TEST_CASE("a robot is loaded by its name, or by its file") {
  CHECK(load_robot("puma560").name == "puma560");
  CHECK(load_robot(std::string(ROB_SOURCE_DIR) + "/tests/bench/xy.toml").name == "xy");
  CHECK_THROWS_WITH_AS(load_robot("pumma560"),
                       "there is no robot 'pumma560'; did you mean 'puma560'?", RobotFileError);
}

TEST_CASE("a robot file that cannot be read is named, with the reason and the remedy") {
  const rob::test::ScratchFolder scratch;
  const auto refuses = [](const std::string& file, const std::string& why) {
    CHECK_THROWS_WITH_AS(load_robot(file), ("cannot read '" + file + "': " + why).c_str(),
                         RobotFileUnreadable);
  };
  refuses(scratch.file("none.toml"), "No such file or directory; check the name and the folder");
  std::filesystem::create_directory(scratch.file("folder.toml"));
  refuses(scratch.file("folder.toml"), "it is a folder; name a file");
  REQUIRE(::mkfifo(scratch.file("pipe.toml").c_str(), S_IRWXU) == 0);
  refuses(scratch.file("pipe.toml"), "it is a pipe; name a file");
  std::filesystem::create_symlink("/dev/zero", scratch.file("zero.toml"));
  refuses(scratch.file("zero.toml"), "it is a device; name a file");
  std::ofstream(scratch.file("long.toml")) << "name = 1";
  std::filesystem::resize_file(scratch.file("long.toml"), std::uintmax_t{3} << 20U);
  refuses(scratch.file("long.toml"), "3 MiB; at most 1 MiB are read");
}

TEST_CASE("what is wrong in a robot file is told with its place") {
  const rob::test::ScratchFolder scratch;
  const std::string file = scratch.file("mine.toml");
  std::ofstream(file) << "name = \"mine\"\nkinematics = \n";
  try {
    load_robot(file);
    FAIL("a value is missing");
  } catch (const RobotFileError& error) {
    CHECK(std::string(error.what()).starts_with(file + ":2:"));
  }
}

TEST_CASE("the robots of the look-ahead benches load: three linear axes, jerk unlimited") {
  for (const auto& [name, axes] : {std::pair{"xy.toml", 3}, std::pair{"xyza.toml", 4}}) {
    const std::string file = std::string(ROB_SOURCE_DIR) + "/tests/bench/" + name;
    std::ifstream in(file);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    const RobotModel robot = parse_robot_file(text, file);
    CHECK(robot.law == Law::LookAhead);
    CHECK(robot.axis_count() == axes);
    CHECK(robot.kinematics->axes() == axes);
    CHECK(robot.reference_period == 0.001);
    for (const Axis& axis : robot.axes) {
      const double unit = axis.kind == AxisKind::Linear ? 1e-3 : std::numbers::pi / 180;
      CHECK(axis.v_max == doctest::Approx(1000 * unit));
      CHECK(axis.a_max == doctest::Approx(1000 * unit));
      CHECK(std::isinf(axis.j_max));
    }
  }
}
