#include "runtime/files/points_file.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>
#include <string>

#include "base/split_mix.h"
#include "motion/robots/robot_file.h"
#include "motion/robots/robot_library.h"
#include "runtime/files/files.h"
#include "runtime/files/point_digits.h"
#include "runtime/run/foretell.h"
#include "runtime/run/load.h"
#include "runtime/run/run.h"
#include "runtime/words/pose_values.h"
#include "tests/support/file_error.h"
#include "tests/support/scratch_folder.h"

using rob::runtime::load_points;
using rob::runtime::parse_points;
using rob::runtime::Points;
using rob::runtime::PointsFile;
using rob::runtime::read_file;
using rob::test::message_of;
using rob::test::ScratchFolder;

namespace {

const rob::motion::RobotModel& gantry() {
  static const rob::motion::RobotModel robot = rob::motion::embedded_robot("gantry");
  return robot;
}

const std::string kRobot = "ROBOT \"gantry\"\n";
// As it is written: the gantry's axes are the place of its flange, the third one turns it about z.
const std::string kWhichRobot =
    "ROBOT \"gantry\" JOINTS(100mm, 200mm, 51deg) POSE(100mm, 200mm, 0mm, 0deg, 0deg, 51deg)";

std::string point(const std::string& name) {
  return name +
         " = POSE(40mm, 20mm, 0mm, 0deg, 0deg, 90deg) JOINTS(40mm, 20mm, 90deg) IN world TOOL none "
         "TAUGHT \"2026-11-21\"\n";
}

/// "line:column code" of the first error; empty where there is none.
std::string first_error(const std::string& text) {
  const Points points = parse_points(text, gantry());
  if (!points.diagnostics.has_errors()) return "";
  const rob::lang::Diagnostic& found = points.diagnostics.all().front();
  return std::to_string(found.place.line) + ":" + std::to_string(found.place.column) + " " +
         found.code;
}

}  // namespace

TEST_CASE("a point is read in metres and radians, with its joints") {
  const Points points = parse_points(kRobot + "\n// taught by hand\n" + point("pick"), gantry());
  REQUIRE_FALSE(points.diagnostics.has_errors());
  REQUIRE(points.points.size() == 1);
  const Points::Point& pick = points.points[0];
  CHECK(pick.value.name == "pick");
  CHECK(pick.value.frame.empty());
  CHECK(pick.tool.empty());
  CHECK(pick.taught == "2026-11-21");
  CHECK(pick.value.pose.position.x == 0.040);
  CHECK(pick.value.pose.position.y == 0.020);
  // A quarter turn about z is the quaternion (cos 45deg, 0, 0, sin 45deg).
  CHECK(std::abs(pick.value.pose.rotation.w - std::numbers::sqrt2 / 2) < 1e-15);
  CHECK(std::abs(pick.value.pose.rotation.k - std::numbers::sqrt2 / 2) < 1e-15);
  REQUIRE(pick.joints.size() == 3);
  CHECK(pick.joints[2] == doctest::Approx(std::numbers::pi / 2));
}

TEST_CASE("what is written is read back the same, sorted by name") {
  const std::string sorted = kWhichRobot + "\n" + point("Above") + point("nest") + point("Pick");
  const Points points =
      parse_points(kRobot + point("Pick") + point("nest") + point("Above"), gantry());
  CHECK(points_text(points, gantry()) == sorted);
  CHECK(points_text(parse_points(sorted, gantry()), gantry()) == sorted);
}

TEST_CASE("comments and blank lines stay where their points go") {
  const std::string above = "// cell 3\n\n";
  const std::string pick = "// beside the \"left\" box\n// mind the hose\n" + point("pick");
  const std::string at = point("at");
  const std::string remarked = at.substr(0, at.size() - 1) + "  // measured, \"twice\"\n";
  const std::string robot = kWhichRobot + "  // the old one\n";
  const Points points =
      parse_points(above + robot + pick + "\n" + remarked + "\n// the end\n", gantry());
  REQUIRE_FALSE(points.diagnostics.has_errors());
  const std::string written =
      above + robot + "\n" + remarked + pick + "\n// the end\n";  // at comes before pick
  CHECK(points_text(points, gantry()) == written);
  CHECK(points_text(parse_points(written, gantry()), gantry()) == written);
  CHECK(parse_points("\xEF\xBB\xBF// with CR LF\r\n" + kRobot, gantry()).robot.above ==
        "// with CR LF\n");
}

TEST_CASE("a point that is taught anew keeps its comments") {
  const ScratchFolder folder;
  const std::string file = folder.file("cell.points");
  std::ofstream(file) << "// first\n" + kRobot + "// here // and\n" + point("pick") +
                             "// behind all\n";
  PointsFile keeper(file, gantry());
  const std::vector<double> joints{0.05, 0.06, 0};
  const rob::lang::PoseValue pose{{0.05, 0.06, 0}, {1, 0, 0, 0}};
  REQUIRE_FALSE(keeper.keep({"PICK", "", "", pose, {}, joints}).has_value());
  REQUIRE_FALSE(keeper.keep({"place", "", "", pose, {}, joints}).has_value());
  const std::string text = read_file(file, 10'000);
  CHECK(text.starts_with("// first\n" + kWhichRobot + "\n// here // and\nPICK = POSE(50mm, "));
  CHECK(text.find("\nplace = ") != std::string::npos);
  CHECK(text.ends_with("\"\n// behind all\n"));
}

TEST_CASE("a file that is not as TEACH writes it is refused with the place") {
  CHECK(first_error("").empty());
  CHECK(first_error(kRobot).empty());
  CHECK(first_error(point("pick")) == "1:1 E546");
  CHECK(first_error(kRobot + "pick = 3\n") == "2:8 E546");
  CHECK(first_error(kRobot + "pick = POSE(40, 20mm, 0mm, 0deg, 0deg, 0deg)\n") == "2:13 E546");
  CHECK(first_error(kRobot + "pick = POSE(40mm, 20mm\n") == "2:23 E546");
  CHECK(first_error(kRobot + point("pick") + "MOVE(1,2,3)\n") == "3:1 E546");
  CHECK(first_error(kRobot + point("pick") + point("PICK")) == "3:1 E548");
  CHECK(first_error("ROBOT \"ums7\"\n" + point("pick")) == "1:7 E547");
  CHECK(first_error(std::string("ROBOT \"gantry\"\n\0", 16)) == "2:1 E103");
  CHECK(first_error(kRobot + "pick\xff = 1") == "2:5 E104");
}

TEST_CASE("points that were taught on a robot of the same name and another geometry are refused") {
  const auto pick = [](const std::string& x, const std::string& c, const std::string& rest) {
    return kRobot + "pick = POSE(" + x + ", 20mm, 0mm, 0deg, 0deg, " + c + ")" + rest +
           " TAUGHT \"2026-11-21\"\n";
  };
  const std::string joints = " JOINTS(40mm, 20mm, 90deg) ";
  CHECK(first_error(pick("40.01mm", "90.01deg", joints + "IN world TOOL none")).empty());
  CHECK(first_error(pick("41mm", "90deg", joints + "IN world TOOL none")) == "2:1 E547");
  CHECK(first_error(pick("40mm", "89deg", joints + "IN world TOOL none")) == "2:1 E547");
  // -270deg is the same turn.
  CHECK(first_error(pick("40mm", "-270deg", joints + "IN world TOOL none")).empty());
  // What the frame and the tool are is not known here; without joints there is nothing to compare.
  CHECK(first_error(pick("41mm", "90deg", joints + "IN pallet TOOL none")).empty());
  CHECK(first_error(pick("41mm", "90deg", joints + "IN world TOOL cup")).empty());
  CHECK(first_error(pick("41mm", "90deg", " IN world")).empty());
}

TEST_CASE("fault 55: points in a frame are refused where the file was taught on another geometry") {
  const std::string in_a_frame =
      "pick = POSE(1mm, 2mm, 0mm, 0deg, 0deg, 0deg) JOINTS(40mm, 20mm, 0deg) IN pallet TOOL cup "
      "TAUGHT \"2026\"\n";
  const auto refused = [&](const std::string& place) {
    return first_error("ROBOT \"gantry\" JOINTS(100mm, 200mm, 51deg) " + place + "\n" + in_a_frame);
  };
  CHECK(refused("POSE(100mm, 200mm, 0mm, 0deg, 0deg, 51deg)").empty());
  CHECK(refused("POSE(101mm, 200mm, 0mm, 0deg, 0deg, 51deg)") == "1:7 E547");
  CHECK(refused("POSE(100mm, 200mm, 0mm, 0deg, 0deg, 50deg)") == "1:7 E547");
  CHECK(refused("POSE(100mm, 200mm, 0mm, 0deg, 0deg)") == "1:78 E546");
  CHECK(refused("") == "1:44 E546");
}

TEST_CASE("fault 55: what an arm's file tells of its geometry shows every length, angle and sign") {
  const auto files = rob::motion::embedded_robots();
  const auto file = std::ranges::find(files, "irb120", &rob::motion::EmbeddedRobot::name);
  const std::string_view text = file->text;
  const std::string header =
      points_text(Points{}, rob::motion::parse_robot_file(std::string(text), "irb120.toml"));
  const auto taught_on = [&](const std::string& was, const std::string& is) {
    std::string other(text);
    REQUIRE(other.find(was) != std::string::npos);
    other.replace(other.find(was), was.size(), is);
    const auto robot = rob::motion::parse_robot_file(other, "irb120.toml");
    return !parse_points(header, robot).diagnostics.has_errors();
  };
  CHECK(taught_on("c2 = \"270 mm\"", "c2 = \"0.27 m\""));
  for (const char* const length :
       {"a1 = \"0 mm\"", "a2 = \"-70 mm\"", "b = \"0 mm\"", "c1 = \"290 mm\"", "c2 = \"270 mm\"",
        "c3 = \"302 mm\"", "c4 = \"72 mm\""}) {
    CAPTURE(length);
    const std::string name(length, 2);
    CHECK_FALSE(taught_on(length, name + (name == "b " ? "= \"1 mm\"" : " = \"281 mm\"")));
  }
  for (int axis = 0; axis < 6; ++axis) {
    CAPTURE(axis);
    std::string signs = "signs = [1, 1, 1, 1, 1, 1]";
    signs.insert(signs.find('1') + 3 * static_cast<std::size_t>(axis), "-");
    CHECK_FALSE(taught_on("signs = [1, 1, 1, 1, 1, 1]", signs));
  }
  CHECK_FALSE(taught_on("\"90 deg\", \"0 deg\"", "\"90 deg\", \"1 deg\""));
}

TEST_CASE("MOVE goes to a point's joints only where they still bring the tool to it") {
  const ScratchFolder folder;
  const std::string program = folder.file("cell.rob");
  const std::string points = rob::runtime::points_file_of(program);
  const auto run = [&](const std::string& text, std::size_t axis = 0) {
    const auto loaded = rob::runtime::compile_program(program, text, gantry(), points);
    REQUIRE(loaded.runnable());
    rob::runtime::RunOptions options;
    options.fast = true;
    return rob::runtime::run(loaded, gantry(), options, {}).final_joints.at(axis);
  };
  // With the tool the axis stands 20 mm before its tip.
  CHECK(run("POINT pick\nTOOL pen = POSE(20mm, 0mm, 0mm)\n"
            "WITH pen DO\nMOVE(60, 0, 0)\nTEACH pick\nENDWITH\n") == doctest::Approx(40));
  const Points::Point kept = load_points(points, gantry()).points.at(0);
  CHECK(kept.tool == "pen");
  CHECK(kept.joints.at(0) == doctest::Approx(0.040));
  CHECK(kept.value.pose.position.x == doctest::Approx(0.060));
  CHECK(run("POINT pick\nMOVE pick\n") == doctest::Approx(60));
  CHECK(run("POINT pick\nTOOL pen = POSE(25mm, 0mm, 0mm)\nMOVE pick WITH pen\n") ==
        doctest::Approx(35));
  // Half a turn to either side is the same pose: from 90deg the joints are not the nearest ones.
  std::ofstream(points) << kRobot + "pick = POSE(40mm, 0mm, 0mm, 0deg, 0deg, 180deg) " +
                               "JOINTS(50mm, 0mm, -180deg) IN pallet TOOL none TAUGHT \"2026\"\n";
  const std::string go = "POINT pick\nMOVE(0, 0, 90)\nMOVE pick\n";
  const std::string as_then = "FRAME pallet = POSE(10mm, 0mm, 0mm)\n" + go;
  const std::string moved = "FRAME pallet = POSE(15mm, 0mm, 0mm)\n" + go;
  CHECK(run(as_then) == doctest::Approx(50));
  CHECK(run(as_then, 2) < 0);
  CHECK(run(moved) == doctest::Approx(55));
  CHECK(run(moved, 2) > 0);
}

TEST_CASE("rule 17: a run uses the points as they were when it was loaded, the next the new ones") {
  const ScratchFolder folder;
  const std::string program = folder.file("cell.rob");
  const std::string points = rob::runtime::points_file_of(program);
  const auto edited = [&](const std::string& x) {
    std::ofstream(points) << kRobot + "pick = POSE(" + x + ", 0mm, 0mm, 0deg, 0deg, 0deg) " +
                                 "IN world TAUGHT \"2026\"\n";
  };
  const auto load = [&] {
    return rob::runtime::compile_program(
        program, "POINT pick, place\nTEACH place\nMOVE pick\nPRINT pick.x\n", gantry(), points);
  };
  const auto end_of = [](const rob::runtime::LoadedProgram& loaded) {
    rob::runtime::RunOptions options;
    options.fast = true;
    return rob::runtime::run(loaded, gantry(), options, {}).final_joints.at(0);
  };
  edited("40mm");
  const auto loaded = load();
  edited("70mm");
  // TEACH writes the file while the program runs, and leaves there what was edited.
  CHECK(end_of(loaded) == doctest::Approx(40));
  CHECK(end_of(load()) == doctest::Approx(70));
}

TEST_CASE("all errors of a file are found, not the first alone") {
  const Points points = parse_points(kRobot + "a = 1\n" + point("b") + "c = 2\n", gantry());
  CHECK(points.diagnostics.error_count() == 2);
  CHECK(points.points.size() == 1);
}

TEST_CASE("a point is taught into a file, and what was edited meanwhile stays") {
  const ScratchFolder folder;
  const std::string file = folder.file("a.points");
  PointsFile points(file, gantry());
  const std::vector<double> joints{0.040, 0.020, 0};
  CHECK_FALSE(points.keep({"pick", "", "", {{0.040, 0.020, 0}, {1, 0, 0, 0}}, {}, joints}));
  std::ofstream(file, std::ios::app) << point("nest");
  CHECK_FALSE(
      points.keep({"PICK", "pallet", "cup", {{0.050, 0.020, 0}, {1, 0, 0, 0}}, {}, joints}));
  const Points kept = load_points(file, gantry());
  REQUIRE(kept.points.size() == 2);
  CHECK(kept.points[0].value.name == "nest");
  CHECK(kept.points[1].value.name == "PICK");
  CHECK(kept.points[1].value.frame == "pallet");
  CHECK(kept.points[1].tool == "cup");
  CHECK(kept.points[1].value.pose.position.x == 0.050);
}

TEST_CASE("a file that cannot be used is not overwritten by TEACH") {
  const ScratchFolder folder;
  const std::string file = folder.file("a.points");
  const std::string text = "ROBOT \"ums7\"\n" + point("pick");
  std::ofstream(file) << text;
  CHECK(message_of([&] { load_points(file, gantry()); }).find("E547") != std::string::npos);
  PointsFile points(file, gantry());
  const std::vector<double> joints{0, 0, 0};
  const auto refusal = points.keep({"pick", "", "", {{0, 0, 0}, {1, 0, 0, 0}}, {}, joints});
  REQUIRE(refusal);
  CHECK(refusal->code == "E549");
  CHECK(read_file(file, 1000) == text);
}

TEST_CASE(
    "a MOVE to a bare point goes to its joints, where another place of them has the same pose") {
  const ScratchFolder folder;
  const std::string file = (folder.path() / "cell.points").string();
  // -180deg and 180deg of the axis are one pose.
  std::ofstream(file) << kRobot
                      << "park = POSE(40mm, 20mm, 0mm, 0deg, 0deg, 180deg) JOINTS(40mm, 20mm, "
                         "-180deg) IN world TOOL none TAUGHT \"2026-11-21\"\n";
  const auto final_theta = [&](const std::string& text) {
    const auto program = rob::runtime::compile_program("cell.rob", text, gantry(), file);
    return rob::runtime::foretell(program, gantry()).final_joints.at(2);
  };
  const std::string begin = "POINT park\nMOVE(0, 0, 170) FINE\n";
  CHECK(final_theta(begin + "MOVE park") == doctest::Approx(-180));
  CHECK(final_theta(begin + "MOVEL park") == doctest::Approx(180));
  CHECK(final_theta(begin + "VAR p = park\nMOVE p") == doctest::Approx(180));
  // A TEACH that has not been executed leaves the joints of the file.
  CHECK(final_theta(begin + "IF DIN[1] THEN TEACH park\nMOVE park") == doctest::Approx(-180));
}

namespace {

using rob::runtime::PointDigits;
using rob::runtime::rounded_angles;

/// A point taught at random joints within the limits.
Points::Point taught_anywhere(const rob::motion::RobotModel& robot, rob::SplitMix& random) {
  Points::Point point;
  for (const rob::motion::Axis& axis : robot.axes)
    point.joints.push_back(axis.min + (axis.max - axis.min) * random.share());
  const Eigen::Map<const Eigen::VectorXd> q(point.joints.data(), robot.axis_count());
  point.value = {"p", "", rob::runtime::to_lang(robot.kinematics->forward(q))};
  point.taught = "now";
  return point;
}

}  // namespace

TEST_CASE("a point is saved with 0.001 mm and 0.0001 deg") {
  Points points =
      parse_points(kRobot +
                       "p = POSE(40.00049mm, -0.0004mm, 1.0005001mm, 0deg, 0deg, 30.00005001deg) "
                       "JOINTS(12.3456789mm, 1.0004999mm, 89.99996deg) IN world TAUGHT \"x\"\n",
                   gantry());
  // The pose and the joints here do not belong together, so only what is written is looked at.
  CHECK(points.diagnostics.error_count() == 1);
  points = parse_points(kRobot + point("p"), gantry());
  points.points[0].value.pose = {{0.04000049, -0.0000004, 0.0010005001}, {}};
  points.points[0].joints = {0.0123456789, 0.0010004999, 89.99996 * std::numbers::pi / 180};
  CHECK(point_text(points.points[0], gantry()) ==
        "p = POSE(40mm, 0mm, 1.001mm, 0deg, 0deg, 0deg) JOINTS(12.346mm, 1mm, 90deg) IN world TOOL "
        "none TAUGHT \"2026-11-21\"");
}

TEST_CASE("an encoder that measures finer keeps its digits") {
  rob::motion::RobotModel robot = gantry();
  robot.axes[1].drive.encoder_resolution = 0.05e-6;  // 0.00005 mm: five digits
  const PointDigits digits = rob::runtime::digits_of(robot);
  CHECK(digits.joints[0].digits == 3);
  CHECK(digits.joints[1].digits == 5);
  CHECK(digits.joints[2].digits == 4);
  CHECK(digits.length == 5);
  CHECK(digits.angle == 6);
  CHECK(rob::runtime::digits_of(gantry()).length == 3);
}

TEST_CASE("a joint is never rounded beyond an end of its axis, nor is the pose of a gantry") {
  rob::motion::RobotModel robot = gantry();
  robot.axes[0].max = 0.1234568;                            // 123.4568 mm: 123.457 mm is beyond
  robot.axes[2].min = -100.12345 * std::numbers::pi / 180;  // -100.1235deg is beyond
  rob::lang::TaughtPoint point{.name = "p", .frame = "", .tool = "", .pose = {}};
  point.joints = {robot.axes[0].max, 0.0123456, robot.axes[2].min};
  const Eigen::Map<const Eigen::VectorXd> q(point.joints.data(), 3);
  point.pose = rob::runtime::to_lang(robot.kinematics->forward(q));
  rob::runtime::round_as_kept(robot, point);
  CHECK(point.joints[0] == doctest::Approx(0.123456).epsilon(1e-12));
  CHECK(point.joints[1] == doctest::Approx(0.012346).epsilon(1e-12));
  CHECK(point.joints[2] == doctest::Approx(-100.1234 * std::numbers::pi / 180).epsilon(1e-12));
  CHECK(point.pose.position.x == doctest::Approx(0.123456).epsilon(1e-12));
  CHECK(point.pose.position.y == doctest::Approx(0.012346).epsilon(1e-12));
  const auto turned = rob::lang::pose_math::to_fixed(point.pose.rotation);
  CHECK(turned.c == doctest::Approx(-100.1234 * std::numbers::pi / 180).epsilon(1e-12));
  // The file has the same, also where it is written again with what others have changed.
  const Points::Point in_file{{"p", "", point.pose}, point.joints, "", "now"};
  CHECK(point_text(in_file, robot)
            .starts_with("p = POSE(123.456mm, 12.346mm, 0mm, 0deg, 0deg, -100.1234deg) "
                         "JOINTS(123.456mm, 12.346mm, "
                         "-100.1234deg)"));
  const Points::Point by_hand{{"p", "", point.pose}, {0.1234568, 0, 0}, "", "now"};
  CHECK(point_text(by_hand, robot).find("JOINTS(123.456mm, ") != std::string::npos);
}

TEST_CASE("TEACH leaves in the program what the next run reads, to the bit, on every robot") {
  rob::SplitMix random(17);
  for (const std::string_view name : rob::motion::robot_names()) {
    const rob::motion::RobotModel robot = rob::motion::embedded_robot(name);
    if (robot.kinematics == nullptr) continue;
    CAPTURE(std::string(name));
    for (std::size_t i = 0; i < 200; ++i) {
      Points::Point taught = taught_anywhere(robot, random);
      if (i < 2 * robot.axes.size()) {  // at each end of each axis
        const rob::motion::Axis& axis = robot.axes[i / 2];
        taught.joints[i / 2] = i % 2 == 0 ? axis.min : axis.max;
      }
      const Eigen::Map<const Eigen::VectorXd> q(taught.joints.data(), robot.axis_count());
      rob::lang::TaughtPoint point{.name = "p", .frame = "", .tool = "", .pose = {}};
      point.pose = rob::runtime::to_lang(robot.kinematics->forward(q));
      point.joints = taught.joints;
      rob::runtime::round_as_kept(robot, point);
      taught.value.pose = point.pose;
      taught.joints = point.joints;
      Points points;
      points.points.push_back(taught);
      const Points read = parse_points(points_text(points, robot), robot);
      REQUIRE_FALSE(read.diagnostics.has_errors());
      CHECK(read.points[0].joints == point.joints);
      CHECK(read.points[0].value.pose == point.pose);
      for (std::size_t axis = 0; axis < robot.axes.size(); ++axis) {
        CHECK(point.joints[axis] >= robot.axes[axis].min - 1e-12);
        CHECK(point.joints[axis] <= robot.axes[axis].max + 1e-12);
      }
    }
  }
}

TEST_CASE("what TEACH has kept is what the program goes on with") {
  const std::string text =
      "POINT w\nMOVE(100 / 3, 0, 10) FINE\nTEACH w\nPRINT w.x\n"
      "MOVE(0, 0, 0)\nMOVE w FINE\nPRINT HERE.x";
  const auto program = rob::runtime::compile_program("w.rob", text, gantry(), "");
  const auto result = rob::runtime::foretell(program, gantry());
  REQUIRE(result.output.size() == 2);
  CHECK(result.output[0] == "33.333mm");
  CHECK(result.output[1] == "33.333mm");
}

TEST_CASE("rounded points are read on every robot, bring the tool there, and stay as they are") {
  // The bounds are those within which MOVE goes to the joints of a point.
  constexpr double kPlace = 5e-5;
  constexpr double kTurn = 1e-5;
  rob::SplitMix random(7);
  for (const std::string_view name : rob::motion::robot_names()) {
    const rob::motion::RobotModel robot = rob::motion::embedded_robot(name);
    if (robot.kinematics == nullptr) continue;
    CAPTURE(std::string(name));
    for (int i = 0; i < 300; ++i) {
      Points points;
      points.points.push_back(taught_anywhere(robot, random));
      const std::string text = points_text(points, robot);
      CAPTURE(text);
      const Points read = parse_points(text, robot);
      REQUIRE_FALSE(read.diagnostics.has_errors());
      CHECK(points_text(read, robot) == text);
      const Points::Point& found = read.points.at(0);
      const Eigen::Map<const Eigen::VectorXd> q(found.joints.data(), robot.axis_count());
      const auto there = rob::runtime::to_lang(robot.kinematics->forward(q));
      using rob::lang::pose_math::operator-;
      CHECK(rob::lang::pose_math::length(there.position - found.value.pose.position) < kPlace);
      CHECK(rob::lang::pose_math::turn(there, found.value.pose) < kTurn);
    }
  }
}

TEST_CASE("angles near a quarter turn about y and near half turns are written the same again") {
  rob::SplitMix random(11);
  for (int i = 0; i < 20'000; ++i) {
    const auto near = [&](double angle) {
      const double beside = (random.share() - 0.5) * std::pow(10.0, -8 * random.share());
      return (angle + (i % 3 == 0 ? 0.0 : beside)) * std::numbers::pi / 180;
    };
    const double b = i % 2 == 0 ? 90 : -90;
    const auto rotation = rob::lang::pose_math::from_fixed(
        {near(i % 5 < 3 ? 180 : -180), near(i % 7 == 0 ? 0 : b), near(360 * random.share() - 180)});
    const rob::lang::FixedAngles once = rounded_angles(rotation, 4);
    constexpr double kRadians = std::numbers::pi / 180;
    const auto again =
        rob::lang::pose_math::from_fixed({once.a * kRadians, once.b * kRadians, once.c * kRadians});
    const rob::lang::FixedAngles twice = rounded_angles(again, 4);
    CAPTURE(once.a);
    CAPTURE(once.b);
    CAPTURE(once.c);
    CHECK(once.a == twice.a);
    CHECK(once.b == twice.b);
    CHECK(once.c == twice.c);
    // Rounded twice at most, three angles each time.
    CHECK(rob::lang::pose_math::turn({{}, rotation}, {{}, again}) < 6 * 0.00005 * kRadians * 1.01);
  }
}
