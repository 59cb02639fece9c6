// Shapes and obstacles of a robot file.
#include <doctest/doctest.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "motion/robots/robot_clearance.h"
#include "motion/robots/robot_file.h"
#include "motion/robots/robot_library.h"

using namespace rob::motion;

namespace {

/// The gantry's file with these tables at its end.
RobotModel shaped_gantry(const std::string& tables) {
  for (const EmbeddedRobot& robot : embedded_robots())
    if (robot.name == "gantry")
      return parse_robot_file(std::string(robot.text) + "\n" + tables, "my.toml");
  throw std::logic_error("no gantry");
}

void check_shape_refused(const std::string& tables, const std::string& part) {
  std::string error;
  try {
    shaped_gantry(tables);
  } catch (const RobotFileError& refused) {
    error = refused.what();
  }
  CAPTURE(tables);
  CAPTURE(error);
  CHECK(error.find("my.toml:") == 0);
  CHECK(error.find(part) != std::string::npos);
}

const std::string kTool = R"(
[[flange.shape]]
kind = "capsule"
from = ["0 mm", "0 mm", "0 mm"]
to = ["0 mm", "0 mm", "80 mm"]
radius = "2 cm"
)";

}  // namespace

TEST_CASE("a robot file says what can hit what") {
  const std::string metres = R"(
[[flange.shape]]
kind = "capsule"
from = ["0 mm", "0 mm", "0 mm"]
to = ["0 mm", "0 mm", "80 mm"]
radius = "20 mm"
[[obstacle]]
name = "crate"
kind = "box"
size = ["100 mm", "200 mm", "300 mm"]
place = ["500 mm", "0 mm", "150 mm"]
turn = ["0 deg", "0 deg", "90 deg"]
[[obstacle]]
name = "floor"
kind = "table"
height = "-50 mm"
)";
  const RobotModel robot = shaped_gantry(metres);
  REQUIRE(robot.collision.bodies.size() == 1);
  CHECK(robot.collision.bodies[0].name == "flange");
  CHECK(robot.collision.clearance == 0.010);
  const Clearance clearance = clearance_of(robot);
  REQUIRE(clearance.pairs().size() == 2);
  // Turned by 90°, the crate's edge of 200 mm lies along x: it begins at x = 400 mm.
  const LinkFrames frames = clearance.frames(JointVector{{0.1, 0, 0}});
  CHECK(clearance.distance(clearance.pairs()[0], frames) == doctest::Approx(0.3 - 0.02));
  CHECK(clearance.distance(clearance.pairs()[1], frames) == doctest::Approx(0.05 - 0.02));
}

TEST_CASE("a robot without shapes has nothing to hit") {
  CHECK(clearance_of(embedded_robot("gantry")).pairs().empty());
}

TEST_CASE("the tube handler's cell stands around it") {
  const RobotModel& robot = embedded_robot("lwa4p");
  const Clearance clearance = clearance_of(robot);
  std::vector<std::string> around_the_hand;
  std::vector<std::string> around_the_wrist;
  for (const Clearance::Pair& pair : clearance.pairs()) {
    if (!pair.obstacle) continue;
    const std::string& name = clearance.name_of_other(pair);
    if (clearance.name_of_body(pair) == "flange") around_the_hand.push_back(name);
    if (clearance.name_of_body(pair) == "wrist") around_the_wrist.push_back(name);
  }
  CHECK(around_the_hand == std::vector<std::string>{"table"});  // it works at the racks
  CHECK(around_the_wrist ==
        std::vector<std::string>{"table", "rack_1", "rack_2", "rack_3", "rack_4", "rack_5"});
  // At the start nothing touches.
  const LinkFrames frames = clearance.frames(robot.start);
  for (const Clearance::Pair& pair : clearance.pairs()) CHECK(clearance.distance(pair, frames) > 0);
}

TEST_CASE("what is wrong with a shape or an obstacle is refused where it stands") {
  check_shape_refused(kTool, "has an unknown unit");  // cm
  std::string tool = kTool;
  tool.replace(tool.find("2 cm"), 4, "0 mm");
  check_shape_refused(tool, "radius");
  tool = kTool;
  tool.replace(tool.find("capsule"), 7, "cone");
  check_shape_refused(tool, "kind");
  check_shape_refused("[[obstacle]]\nname = \"a\"\nkind = \"box\"\n", "size");
  check_shape_refused("[[obstacle]]\nname = \"a\"\nkind = \"sphere\"\nsize = \"1 mm\"\n",
                      "does not belong to an obstacle of this kind");
  const std::string table = "[[obstacle]]\nname = \"a\"\nkind = \"table\"\nheight = \"0 mm\"\n";
  check_shape_refused(table + table, "another obstacle of this name");
  check_shape_refused("[[apart]]\nfirst = \"flange\"\nsecond = \"moon\"\n", "no body or obstacle");
  check_shape_refused("[[obstacle]]\nname = \"a\"\nkind = \"tabel\"\n", "table");
  check_shape_refused(kTool.substr(0, kTool.find("2 cm")) +
                          "2 mm\"\n[[obstacle]]\nname = \"flange\"\n" +
                          "kind = \"table\"\nheight = \"0 mm\"\n",
                      "a body of the robot has this name");
  check_shape_refused(table + "[[apart]]\nfirst = \"a\"\nsecond = \"a\"\n", "the same as `first`");
}

TEST_CASE("base and flange get another name where an axis has theirs") {
  std::string text;
  for (const EmbeddedRobot& robot : embedded_robots())
    if (robot.name == "irb120") text = robot.text;
  const std::string first_axis = "name = \"j1\"";
  REQUIRE(text.find(first_axis) != std::string::npos);
  text.replace(text.find(first_axis), first_axis.size(), "name = \"base\"");
  const std::string capsule =
      "kind = \"capsule\"\nfrom = [\"0 mm\", \"0 mm\", \"0 mm\"]\n"
      "to = [\"0 mm\", \"0 mm\", \"80 mm\"]\nradius = \"20 mm\"\n";
  text.insert(text.find("[axis.drive]"), "[[axis.shape]]\n" + capsule);
  const RobotModel robot = parse_robot_file(text + "\n[[base.shape]]\n" + capsule, "my.toml");
  std::vector<std::string> names;
  for (const Body& body : robot.collision.bodies) names.push_back(body.name);
  CHECK(names == std::vector<std::string>{"foot", "base"});
}

TEST_CASE("a mesh has a file, a place and a turn") {
  const std::string mesh = "[[obstacle]]\nname = \"a\"\nkind = \"mesh\"\n";
  check_shape_refused(mesh, "file");
  check_shape_refused(mesh + "file = \"a.stl\"\nradius = \"1 mm\"\n",
                      "does not belong to an obstacle of this kind");
}

TEST_CASE("meshes wait for who can read them, with the place where they are named") {
  const RobotModel robot = shaped_gantry(
      "[[obstacle]]\nname = \"rack\"\nkind = \"mesh\"\nfile = \"rack.stl\"\n"
      "place = [\"1 m\", \"0 m\", \"0 m\"]\n");
  REQUIRE(robot.collision.meshes.size() == 1);
  const MeshObstacle& mesh = robot.collision.meshes.front();
  CHECK(mesh.name == "rack");
  CHECK(mesh.file == "rack.stl");
  CHECK(mesh.place.position.x() == 1);
  CHECK(mesh.where.starts_with("my.toml:"));
}

TEST_CASE("the arms in the box have shapes, and touch nothing at their start") {
  for (const char* name : {"lwa4p", "lwa4p_urdf", "ur5e", "ur10e", "fr3", "t3"}) {
    CAPTURE(name);
    const RobotModel& robot = embedded_robot(name);
    const Clearance clearance = clearance_of(robot);
    CHECK(clearance.pairs().size() >= 3);
    const LinkFrames at_start = clearance.frames(robot.start);
    for (const Clearance::Pair& pair : clearance.pairs()) {
      CAPTURE(clearance.name_of_body(pair));
      CAPTURE(clearance.name_of_other(pair));
      CHECK(clearance.distance(pair, at_start) > 0.005);
    }
  }
}
