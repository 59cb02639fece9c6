#include <doctest/doctest.h>

#include <string>

#include "motion/robots/robot_file.h"
#include "motion/robots/robot_library.h"
#include "tests/support/relative.h"

namespace rob::motion {
namespace {

std::string lwa4p() {
  for (const EmbeddedRobot& robot : embedded_robots())
    if (robot.name == "lwa4p") return std::string(robot.text);
  FAIL("no such robot");
  return "";
}

/// What is wrong with the file after the edit, without the place; empty: nothing.
std::string cell_error(const std::string& was, const std::string& is) {
  std::string text = lwa4p();
  REQUIRE(text.find(was) != std::string::npos);
  text.replace(text.find(was), was.size(), is);
  try {
    parse_robot_file(text, "cell.toml");
  } catch (const RobotFileError& error) {
    const std::string what = error.what();
    CHECK(what.starts_with("cell.toml:"));
    return what.substr(what.find(": ") + 2);
  }
  return "";
}

bool refused(const std::string& was, const std::string& is, const char* why) {
  return cell_error(was, is).find(why) != std::string::npos;
}

}  // namespace

TEST_CASE("the tube cell's sensor and surroundings are those of its file") {
  const RobotModel robot = parse_robot_file(lwa4p(), "cell.toml");
  CHECK(robot.force.delay == 0.02);
  CHECK(robot.force.limit == 50);
  CHECK(robot.force.stiffness == test::relative(150e3));
  REQUIRE(robot.cell);
  CHECK(robot.cell->contact.stiffness == test::relative(50e3));
  CHECK(robot.cell->sensor.force_bias == Eigen::Vector3d(1.2, -0.8, 4.5));
  CHECK(robot.cell->gripper.closed_input == 0);
  CHECK(robot.cell->gripper.held_input == 2);
  int tubes = 0;
  int empty = 0;
  for (const RackData& rack : robot.cell->racks)
    (rack.fill == RackData::Fill::Empty ? empty : tubes) += rack.columns * rack.rows;
  CHECK(tubes >= 100);
  CHECK(empty >= 100);
  CHECK(robot.cell->cap_supplies.size() == 1);
  CHECK(robot.cell->sensor.delay == 0.02);
}

TEST_CASE("other tube cells differ by what S4's cells differ by") {
  const RobotModel robot = parse_robot_file(lwa4p(), "cell.toml");
  REQUIRE(robot.cell->spread);
  const CellSpread& spread = *robot.cell->spread;
  CHECK(spread.stiffness.low == test::relative(20e3));
  CHECK(spread.stiffness.high == test::relative(150e3));
  CHECK(spread.friction.low == 0.1);
  CHECK(spread.friction.high == 0.4);
  CHECK(spread.force_noise.high == 0.2);
  CHECK(spread.torque_noise.high == 0.01);
  CHECK(spread.delay.high == 0.02);
  CHECK(spread.slip_torque.low == 1.3);
  CHECK(spread.hole_error == 4e-3);
}

TEST_CASE("every place of the tube cell can be reached by a hand that points down") {
  const RobotModel robot = parse_robot_file(lwa4p(), "cell.toml");
  const double tip = robot.cell->gripper.tip;
  const auto reached = [&](double x, double y, double z) {
    const Pose flange{Eigen::Vector3d(x, y, z + tip), Eigen::Quaterniond(0, 1, 0, 0)};
    const auto q = robot.kinematics->inverse(flange, robot.start);
    if (!q) return false;
    for (int i = 0; i < robot.axis_count(); ++i)
      if ((*q)[i] < robot.axes[static_cast<std::size_t>(i)].min ||
          (*q)[i] > robot.axes[static_cast<std::size_t>(i)].max)
        return false;
    return true;
  };
  for (const RackData& rack : robot.cell->racks)
    for (const int column : {0, rack.columns - 1})
      for (const int row : {0, rack.rows - 1})
        for (const double above : {0.0, 0.17})  // from a hole's face to over standing tubes
          CHECK(
              reached(rack.x + column * rack.pitch, rack.y + row * rack.pitch, rack.face + above));
}

TEST_CASE("nonsense in a cell is refused with a remedy") {
  CHECK(refused("force_sensor = true", "", "needs force_sensor = true"));
  CHECK(refused("held_input = \"part_held\"", "held_input = \"gripper_closed\"",
                "must be another input"));
  CHECK(refused("held_input = \"part_held\"", "held_input = \"part_hold\"",
                "did you mean \"part_held\""));
  CHECK(refused("stiffness = \"50 N/mm\"", "stiffness = \"200 N/mm\"", "to be the greatest"));
  CHECK(refused("stiffness = \"50 N/mm\"", "stiffness = \"50 N\"", "N/m, N/mm"));
  CHECK(refused("delay = \"20 ms\"", "delay = \"2 s\"", "out of range"));
  CHECK(refused("delay = \"20 ms\"", "delay = \"-1 ms\"", "out of range"));
  CHECK(refused("force_noise = \"0.1 N\"", "force_noise = \"-0.1 N\"", "out of range"));
  CHECK(refused("damping_time = \"1 ms\"", "damping_time = \"-1 ms\"", "out of range"));
  CHECK(refused("period = \"1 ms\"", "period = \"0.1 ms\"", "too short for the delay"));
  CHECK(refused("overlap = \"5 mm\"", "overlap = \"25 mm\"", "more than height"));
  CHECK(refused("rise = \"45 deg\"", "rise = \"700 deg\"", "more than turns"));
  CHECK(refused("slip_torque = \"1.4 Nm\"", "slip_torque = \"0.1 Nm\"", "never turns"));
  CHECK(refused("depth = \"50 mm\"", "depth = \"70 mm\"", "below the table"));
  CHECK(refused("error = [\"2.4 mm\"", "error = [\"24 mm\"", "its neighbour's"));
  CHECK(refused("fill = \"tubes\"", "fill = \"full\"", "is not known"));
  CHECK(refused("palm = \"10 mm\"", "palms = \"10 mm\"", "did you mean \"palm\""));
}

TEST_CASE("a spread that a cell could not have is refused") {
  CHECK(refused("\"150 N/mm\"]", "\"151 N/mm\"]", "to be the greatest"));
  CHECK(refused("[\"20 N/mm\", \"150 N/mm\"]", "[\"150 N/mm\", \"20 N/mm\"]", "lower value first"));
  CHECK(refused("[0.1, 0.4]", "[0.4, 0.1]", "lower value first"));
  CHECK(refused("[0.1, 0.4]", "[0.1, 4]", "must be a number from 0 to 2"));
  CHECK(refused("[0.1, 0.4]", "[0.1]", "must be a list of 2"));
  CHECK(refused("\"1 ms\", \"20 ms\"", "\"1 ms\", \"21 ms\"", "to be the greatest"));
  CHECK(refused("\"0.05 Nm\", \"0.3 Nm\"", "\"0.05 Nm\", \"1.3 Nm\"", "never turns"));
  CHECK(refused("hole_error = \"4 mm\"", "hole_error = \"21 mm\"", "its neighbour's"));
  CHECK(refused("hole_error = \"4 mm\"", "hole_eror = \"4 mm\"", "did you mean \"hole_error\""));
}

}  // namespace rob::motion
