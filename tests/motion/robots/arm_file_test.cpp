#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "motion/kinematics/arm_kinematics.h"
#include "motion/robots/robot_file.h"
#include "motion/robots/robot_library.h"
#include "tests/support/degrees.h"

using namespace rob::motion;
using rob::test::kDegree;

namespace {

/// The file of an arm, with `was` in it replaced.
std::string file_of(const char* name, const std::string& was = "", const std::string& is = "") {
  for (const EmbeddedRobot& robot : embedded_robots()) {
    if (robot.name != name) continue;
    std::string text(robot.text);
    if (!was.empty()) {
      REQUIRE(text.find(was) != std::string::npos);
      text.replace(text.find(was), was.size(), is);
    }
    return text;
  }
  FAIL("no such robot");
  return "";
}

/// What is wrong with a robot's file after the edit, without the place; empty: nothing.
std::string arm_error(const std::string& was, const std::string& is, const char* name = "lwa4p") {
  try {
    parse_robot_file(file_of(name, was, is), "arm.toml");
  } catch (const RobotFileError& error) {
    const std::string text = error.what();
    CHECK(text.starts_with("arm.toml:"));
    return text.substr(text.find(": ") + 2);
  }
  return "";
}

}  // namespace

TEST_CASE("an arm's measures are read from its file") {
  const RobotModel robot = embedded_robot("pc104");
  CHECK(robot.tool_coordinates);
  const auto arm = std::dynamic_pointer_cast<const ArmKinematics>(robot.kinematics);
  REQUIRE(arm);
  const ArmParameters& p = arm->parameters();
  CHECK(p.a1 == 0.150);
  CHECK(p.a2 == -0.150);
  CHECK(p.b == 0);
  CHECK(p.c1 == 0);
  CHECK(p.c2 == 0.570);
  CHECK(p.c3 == 0.650);
  CHECK(p.c4 == 0);
  const std::array<double, 6> offsets{0, 90, 90, 0, 0, 180};
  for (std::size_t i = 0; i < 6; ++i) {
    CHECK(p.sign[i] == 1);
    CHECK(p.offset[i] == doctest::Approx(offsets[i] * kDegree));
  }
  const auto turned =
      std::dynamic_pointer_cast<const ArmKinematics>(embedded_robot("lwa4p").kinematics);
  CHECK(turned->parameters().sign == std::array<double, 6>{1, 1, -1, 1, -1, 1});
}

TEST_CASE("all arms are known by name and stand within their limits, at no singular place") {
  for (const char* name : {"ums7", "pc104", "lwa4p", "puma560", "irb120"}) {
    CAPTURE(name);
    const RobotModel robot = embedded_robot(name);
    const auto arm = std::dynamic_pointer_cast<const ArmKinematics>(robot.kinematics);
    REQUIRE(arm);
    const SingularityDistances far = arm->singularities(robot.start);
    CHECK(far.shoulder > 0.1);
    CHECK(far.elbow > 20 * kDegree);
    CHECK(far.wrist > 20 * kDegree);
  }
}

TEST_CASE("an arm's table is read strictly") {
  CHECK(arm_error("[arm]", "[arms]") == "unknown key \"arms\"; did you mean \"arm\"?");
  CHECK(arm_error("c2 = ", "d2 = ").starts_with("unknown key \"d2\" in arm"));
  CHECK(arm_error("c3 = \"305 mm\"", "") == "c3 of arm: is missing");
  CHECK(arm_error("c2 = \"350 mm\"", "c2 = \"-350 mm\"") ==
        "c2 of arm: \"-350 mm\" is out of range; it must lie from 0.001 to 10 m");
  CHECK(arm_error("c2 = \"350 mm\"", "c2 = \"350 deg\"").starts_with("c2 of arm: "));
  CHECK(arm_error("c2 = \"350 mm\"", "c2 = \"nan mm\"").starts_with("c2 of arm: "));
  CHECK(arm_error("c3 = \"305 mm\"", "c3 = \"0 mm\"") ==
        "c3 of arm: the wrist must be at least 1 mm from axis 3");
  CHECK(
      arm_error("c4 = \"75 mm\"", "c4 = \"-1 mm\"").starts_with("c4 of arm: \"-1 mm\" is out of"));
}

TEST_CASE("signs and offsets of an arm are lists of six") {
  const std::string signs = "signs = [1, 1, -1, 1, -1, 1]";
  const std::string six = "signs of arm: must be a list of 6, as [first, second, …]";
  CHECK(arm_error(signs, "signs = [1, 1, -1, 1, -1]") == six);
  CHECK(arm_error(signs, "signs = 1") == six);
  CHECK(arm_error(signs, "signs = [1, 1, 0, 1, -1, 1]") == "signs of arm: each must be 1 or -1");
  CHECK(arm_error(signs, "signs = [1, 1, 1.0, 1, -1, 1]") == "signs of arm: each must be 1 or -1");
  const std::string offsets = "offsets = [\"0 deg\", \"0 deg\"";
  CHECK(arm_error(offsets, "offsets = [\"0 deg\"")
            .starts_with("offsets of arm: must be a list of 6"));
  CHECK(arm_error(offsets, "offsets = [\"0 deg\", 0")
            .starts_with("offsets of arm: must be a number with its unit"));
  CHECK(arm_error(offsets, "offsets = [\"0 deg\", \"500 deg\"")
            .starts_with("offsets of arm: \"500 deg\" is out of range"));
}

TEST_CASE("an arm has six rotary axes and a table [arm], a gantry has none") {
  CHECK(arm_error("kinematics = \"arm\"", "kinematics = \"gantry\"") ==
        "kinematics: a gantry has two or three linear axes, then at most a rotary one");
  CHECK(arm_error("kind = \"rotary\"", "kind = \"linear\"") != "");
  std::string gantry = file_of("gantry");
  gantry.replace(gantry.find("[[axis]]"), 0, "[arm]\na1 = \"0 mm\"\n\n");
  CHECK_THROWS_WITH_AS(parse_robot_file(gantry, "my.toml"),
                       doctest::Contains("arm: a gantry has none"), RobotFileError);
}

TEST_CASE("what targets of a chain leave to the place is said in its file, and fits its axes") {
  using Coordinates = std::vector<int>;
  const auto of = [](const char* name, const std::string& was = "", const std::string& is = "") {
    return parse_robot_file(file_of(name, was, is), "my.toml");
  };
  CHECK(of("ur5e").coordinates == Coordinates{0, 1, 2, 3, 4, 5});
  CHECK(of("fr3").coordinates == Coordinates{0, 1, 2, 3, 4, 5});
  CHECK(of("t3").coordinates == Coordinates{0, 1, 2, 5});
  CHECK(of("t3").axes[2].kind == AxisKind::Linear);
  CHECK(of("t3").kinematics->coordinate(3) == 5);  // c
  const std::string law = "law = \"lookahead\"";
  const std::string free = "free = \"c\"  # five axes: the place decides c";
  const RobotModel five = of("so101");
  CHECK(five.tool_coordinates);
  CHECK(five.coordinates == Coordinates{0, 1, 2, 3, 4});
  CHECK(five.kinematics->freedom() == Freedom::C);
  CHECK(arm_error(law, law + "\nfree = \"c\"", "ur5e") ==
        "free: \"c\" is of five axes, where the place decides c");
  CHECK(arm_error("free = \"ab\"", "free = \"c\"", "t3") ==
        "free: \"c\" is of five axes, where the place decides c");
  CHECK(arm_error(free, "free = \"ab\"", "so101") ==
        "free: \"ab\" is of four axes, which turn the tool about z alone");
  CHECK(arm_error("law = \"paul\"", "law = \"paul\"\nfree = \"ab\"") ==
        "free: belongs to kinematics = \"chain\"");
  // Without it four axes are commanded as they are.
  CHECK_FALSE(of("t3", "free = \"ab\"  # its shaft always points down", "").tool_coordinates);
  CHECK_FALSE(of("so101", free, "").tool_coordinates);
}

TEST_CASE("a gripper's axis is the last of a chain's robot, and moves no tool") {
  CHECK(parse_robot_file(file_of("so101"), "my.toml").gripper == 5);
  CHECK(embedded_robot("ur5e").gripper == -1);
  const std::string gripper = "[gripper]\naxis = \"gripper\"";
  CHECK(arm_error(gripper, "[gripper]\naxis = \"roll\"", "so101") ==
        "axis of gripper: must be the last axis, which is gripper");
  CHECK(arm_error("[chain]", "[gripper]\naxis = \"wrist3\"\n[chain]", "ur5e") ==
        "axis of gripper: has [axis.joint]: a gripper does not move the tool");
  CHECK(arm_error("[arm]", "[gripper]\naxis = \"a6\"\n[arm]") ==
        "gripper: belongs to kinematics = \"chain\"");
}
