// Programs for arms from outside.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>

#include "tests/motion/kinematics/arms.h"
#include "tests/support/rob_command.h"
#include "tests/support/trace_file.h"

using nlohmann::json;
using rob::test::contains;
using rob::test::ProcessResult;
using rob::test::RobCommand;

namespace {

json run(const std::string& text, const std::vector<std::string>& more = {}) {
  std::vector<std::string> arguments{"--fast", "--json"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return json::parse(RobCommand(text)("run", arguments).out);
}

rob::test::TraceFile traced(const std::string& text) {
  const RobCommand rob(text);
  const ProcessResult result = rob("run", {"--fast", "--trace", rob.file("t.csv")});
  CHECK(result.exit_code == 0);
  CHECK(result.err == "");  // no warning of following errors either
  std::ifstream file(rob.file("t.csv"));
  return rob::test::parse_trace(std::string(std::istreambuf_iterator<char>(file), {}));
}

/// The tool's measured pose: encoders count thousandths of a degree, some 0.01 mm at the tool.
void check_pose(const json& report, double x, double y, double z, double a, double b, double c) {
  const json& pose = report["final"]["pose"];
  const double expected[] = {x, y, z, a, b, c};
  const char* const names[] = {"x", "y", "z", "a", "b", "c"};
  for (std::size_t i = 0; i < 6; ++i) {
    CAPTURE(names[i]);
    const double off = pose[names[i]].get<double>() - expected[i];
    CHECK(std::abs(i < 3 ? off : std::remainder(off, 360)) < 0.5);
  }
}

}  // namespace

TEST_CASE("every arm goes where it is sent, and back to where it started") {
  for (const char* name :
       {"ums7", "pc104", "lwa4p", "puma560", "irb120", "ur5e", "ur10e", "lwa4p_urdf", "fr3"}) {
    CAPTURE(name);
    const std::string robot = std::string("ROBOT \"") + name + "\"\n";
    const json report = run(robot +
                            "VAR start = HERE\nVAR stood = JOINTS()\n"
                            "MOVE BY (20, 30, -40) FINE\nVAR there = HERE\n"
                            "ASSERT ABS(there.x - start.x - 20mm) < 0.001mm\n"
                            "ASSERT ABS(there.y - start.y - 30mm) < 0.001mm\n"
                            "ASSERT ABS(there.z - start.z + 40mm) < 0.001mm\n"
                            "ASSERT TURN(there, start) < 0.001deg\n"
                            "ASSERT DIST(FORWARD(JOINTS()), there) < 0.001mm\n"
                            "MOVE start FINE\n"
                            "ASSERT DIST(HERE, start) < 0.001mm\n"
                            "ASSERT DIST(FORWARD(JOINTS(start, near: stood)), start) < 0.001mm\n");
    INFO(report.dump());
    CHECK(report["status"] == "done");
  }
}

TEST_CASE("a program's jog moves the tool no faster than it says, by the published table") {
  const auto& arms = rob::test::published_arms();
  const auto lwa4p = std::ranges::find(arms, "lwa4p", &rob::test::PublishedArm::name);
  const auto tip = [&](const rob::test::TraceRow& row) {
    rob::motion::JointVector q(6);
    for (int i = 0; i < 6; ++i) q[i] = row.q[static_cast<std::size_t>(i)] * rob::test::kDegree;
    return Eigen::Vector3d(rob::test::dh_forward(*lwa4p, q).topRightCorner<3, 1>() * 1000);
  };
  for (const char* jog : {"JOG WORLD (z: 250mm/s) FOR 0.6s\n", "JOG TOOL (z: -250mm/s) FOR 0.6s\n",
                          "JOG JOINT (0deg/s, -60deg/s, 0deg/s, 0deg/s, 0deg/s, 0deg/s) FOR 0.6s "
                          "AT 250mm/s\n"}) {
    CAPTURE(jog);
    const auto rows = traced(std::string("ROBOT \"lwa4p\"\n") + jog).rows;
    double fastest = 0;  // mm/s
    for (std::size_t i = 1; i < rows.size(); ++i) {
      const double way = (tip(rows[i]) - tip(rows[i - 1])).norm();
      fastest = std::max(fastest, way / (rows[i].t - rows[i - 1].t));
    }
    CHECK(fastest <= 1.005 * 250);
    CHECK(fastest >= 0.99 * 250);
  }
}

TEST_CASE("an arm's target is its tool's place and orientation") {
  const std::string robot = "ROBOT \"ums7\"\n";
  check_pose(run(robot + "MOVE(500, 0, 300, 180, 0, 0)\n"), 500, 0, 300, 180, 0, 0);
  // Three components keep the orientation, names keep the rest, BY goes along the world's axes.
  check_pose(run(robot + "MOVE(500, 0, 300, 180, 0, 0)\nMOVE(500, 200, 300)\n"), 500, 200, 300, 180,
             0, 0);
  check_pose(run(robot + "MOVE(500, 0, 300, 180, 0, 0)\nMOVE(z: 350mm, c: 30deg)\n"), 500, 0, 350,
             180, 0, 30);
  check_pose(run(robot + "MOVE(500, 0, 300, 180, 0, 0)\nMOVE BY (0, -50, 20)\n"), 500, -50, 320,
             180, 0, 0);
  check_pose(run(robot + "MOVE POSE(450mm, 100mm, 400mm, 180deg, 0deg, 90deg)\n"), 450, 100, 400,
             180, 0, 90);
}

TEST_CASE("a tool on an arm's flange brings its tip to the target") {
  const json report =
      run("ROBOT \"ums7\"\nTOOL pen = POSE(0mm, 0mm, 120mm)\n"
          "WITH pen DO\n  MOVE(500, 0, 200, 180, 0, 0)\nENDWITH\n");
  check_pose(report, 500, 0, 320, 180, 0, 0);  // the flange stands 120 mm higher
}

TEST_CASE("a place out of an arm's reach is refused beforehand, with how much is lacking") {
  // lwa4p spans 655 mm from axis 2, 205 mm up. Upright at z = 1000 mm its wrist is 925 mm up.
  const RobCommand rob(
      "ROBOT \"lwa4p\"\nMOVE(300, 0, 300, 180, 0, 0)\nMOVE(0, 0, 1000, 0, 0, 0)\n");
  for (const char* command : {"check", "run"}) {
    const ProcessResult result = rob(command);
    CHECK(result.exit_code == 65);
    CHECK(contains(result.err, "test.rob:3:5: error[E333]: lwa4p cannot bring its tool to"));
    CHECK(contains(result.err, "its wrist would have to be 65 mm farther out than it reaches"));
    CHECK(contains(result.err,
                   "the nearest that it reaches is POSE(0mm, 0mm, 935mm, 0deg, 0deg, 0deg)"));
  }
}

TEST_CASE("joints beyond a limit are refused with their axis") {
  const RobCommand rob("ROBOT \"irb120\"\nMOVE JOINT 3 TO 75deg\n");
  const ProcessResult result = rob("run", {"--fast"});
  CHECK(result.exit_code == 65);
  CHECK(contains(result.err, "axis j3: 75 deg is beyond 70 deg"));
  // Reached by lengths, and by no axis 3 that the arm has: close above its own shoulder.
  const ProcessResult folded =
      RobCommand("ROBOT \"irb120\"\nMOVE(0, 0, 470, 0, 0, 0)\n")("run", {"--fast"});
  CHECK(folded.exit_code == 65);
  CHECK(contains(folded.err, "axis j"));
}

TEST_CASE("a program for an arm that asks for more than Paul's law is compiled, and not run") {
  const RobCommand rob("ROBOT \"lwa4p\"\nMOVE(400, 0, 120, 180, 0, 0) ACCEL 1m/s^2\n");
  CHECK(rob("compile").exit_code == 0);
  for (const char* command : {"check", "run", "test"}) {
    CAPTURE(command);
    const ProcessResult result = rob(command);
    CHECK(result.exit_code == 65);
    CHECK(contains(result.err, "ACCEL is not possible on lwa4p"));
  }
}

TEST_CASE("an arm's run is the same to the bit each time") {
  const std::string text =
      "ROBOT \"irb120\"\nMOVE(350, 50, 400, 180, 0, 170)\nMOVE BY (0, -100, 50)\nMOVE BY (0, 0, "
      "60)\n";
  const json first = run(text);
  CHECK(first["status"] == "done");
  CHECK(first == run(text));
}

TEST_CASE("the UMS-7 feels the weight of its hand, and its servo holds it") {
  const auto trace = traced(
      "ROBOT \"ums7\"\nMOVE JOINTS(0deg, 0deg, 90deg, 0deg, 0deg, 0deg)\nWAIT 4s\n"
      "MOVE JOINTS(0deg, 0deg, 90deg, 90deg, 90deg, 0deg)\nWAIT 4s\n");
  // The hand level, 2.35 Nm at its wrist, behind a gear of 90 %; friction may hold 0.15 Nm of it.
  const double weight = 2.35 / 0.9;
  std::size_t stretched = 0;
  while (trace.rows[stretched].t < 6) ++stretched;
  CHECK(std::abs(trace.rows[stretched].drive[4] + weight) < 0.15);
  CHECK(std::abs(trace.rows[stretched].drive[3]) < 0.15);
  // Turned to the side: axis 4 bears it.
  CHECK(std::abs(trace.rows.back().drive[3] - weight) < 0.15);
  CHECK(std::abs(trace.rows.back().drive[4]) < 0.15);
}

TEST_CASE("a load that the UMS-7's servo does not know is in its drives") {
  std::ifstream file(std::string(ROB_SOURCE_DIR) + "/motion/robots/ums7.toml");
  std::string arm(std::istreambuf_iterator<char>(file), {});
  arm.insert(arm.find("[dynamics]"), "[simulation]\npayload = \"1 kg\"\n\n");
  const RobCommand rob("MOVE JOINTS(0deg, 0deg, 90deg, 0deg, 0deg, 0deg)\nWAIT 15s\n");
  std::ofstream(rob.file("loaded.toml")) << arm;
  const ProcessResult result =
      rob("run", {"--fast", "--robot", rob.file("loaded.toml"), "--trace", rob.file("t.csv")});
  CHECK(result.exit_code == 0);
  std::ifstream trace(rob.file("t.csv"));
  const auto last =
      rob::test::parse_trace(std::string(std::istreambuf_iterator<char>(trace), {})).rows.back();
  // 9.8 N at 100 mm from the wrist, at 500 mm from axis 3 and 900 mm from axis 2, and the hand;
  // friction of the axes may hold 0.15, 1 and 5 Nm of it.
  const double hand = 2.35 + 9.80665 * 0.1;
  CHECK(std::abs(last.drive[4] + hand / 0.9) < 0.15);
  CHECK(std::abs(last.drive[2] + (hand + 9.80665 * 0.4) / 0.9) < 1);
  CHECK(std::abs(last.drive[1] + (hand + 9.80665 * 0.8) / 0.9) < 5);
}

TEST_CASE("the UMS-7 stands with 3 kg that LOAD tells of, and is pulled off its place without") {
  std::ifstream file(std::string(ROB_SOURCE_DIR) + "/motion/robots/ums7.toml");
  std::string arm(std::istreambuf_iterator<char>(file), {});
  arm.insert(arm.find("[dynamics]"), "[simulation]\npayload = \"3 kg\"\n\n");
  const auto stand = [&](const std::string& told) {
    const RobCommand rob(told + "WAIT 3s\nMOVE JOINT 1 BY 20deg FINE\n");
    std::ofstream(rob.file("loaded.toml")) << arm;
    return rob("run", {"--fast", "--robot", rob.file("loaded.toml")});
  };
  const ProcessResult untold = stand("");
  CHECK(untold.exit_code == 70);
  CHECK(contains(untold.err, "E502"));
  const ProcessResult told = stand("LOAD 3kg\n");
  CHECK(told.exit_code == 0);
  CHECK(told.err == "");
  // As a TOOL's MASS it counts from its first motion on, which is at once here.
  const ProcessResult tool = stand(
      "TOOL jaws = POSE(0mm, 0mm, 0mm) MASS 3kg\nMOVE JOINT 6 BY 5deg FINE WITH jaws\n"
      "LOAD 0kg\n");
  CHECK(tool.exit_code == 70);  // its last motion is without the jaws, and with their weight
  const ProcessResult worn = stand(
      "TOOL jaws = POSE(0mm, 0mm, 0mm) MASS 3kg\nMOVE JOINT 6 BY 5deg FINE WITH jaws\nWAIT 3s\n"
      "LOAD 3kg\n");
  CHECK(worn.exit_code == 0);
}

TEST_CASE("a load whose weight alone is too much is refused with its axis and place") {
  // 20 kg at 180 mm from axis 5, and the hand's 2.35 Nm: 37.7 Nm where the hand lies level, and
  // more than the 30 Nm that its gear bears from 52.8 deg on.
  const RobCommand rob(
      "ROBOT \"ums7\"\nLAW LOOKAHEAD\nLOAD 20kg COG (0mm, 0mm, 80mm)\nMOVE JOINT 5 BY -90deg "
      "FINE\n");
  const ProcessResult refused = rob("check");
  CHECK(refused.exit_code == 65);
  CHECK(contains(refused.err, "test.rob:4:1: error[E567]: axis q5 would bear "));
  CHECK(contains(refused.err, "more than its 30 Nm, by weight alone"));
}

TEST_CASE("rule 13: MOVE takes the joints nearest to where it begins, and none of them wraps") {
  // -10 and 350 degrees of the last axis are one pose, and both lie within its limits.
  const json report =
      run("ROBOT \"irb120\"\n"
          "VAR low = JOINTS(0deg, 0deg, 0deg, 0deg, 30deg, -10deg)\n"
          "VAR high = JOINTS(0deg, 0deg, 0deg, 0deg, 30deg, 350deg)\n"
          "ASSERT DIST(FORWARD(low), FORWARD(high)) < 0.001mm\n"
          "ASSERT TURN(FORWARD(low), FORWARD(high)) < 0.001deg\n"
          "VAR j = low\n"
          "MOVE low FINE\nMOVE FORWARD(high) FINE\nj = JOINTS()\n"
          "ASSERT ABS(j[6] + 10deg) < 0.001deg\n"
          "MOVE high FINE\nMOVE FORWARD(low) FINE\nj = JOINTS()\n"
          "ASSERT ABS(j[6] - 350deg) < 0.001deg\n"
          // Where the motion before it is under way, from where that will end.
          "MOVE low\nMOVE high\nMOVE FORWARD(low)\nSTOP\nj = JOINTS()\n"
          "ASSERT ABS(j[6] - 350deg) < 0.001deg\n");
  CHECK(report["status"] == "done");
  CHECK(report["error"].is_null());
}

TEST_CASE("the UMS-7 follows at full speed through its whole range") {
  const auto trace = traced(
      "ROBOT \"ums7\"\nMOVE JOINTS(150deg, -100deg, 20deg, 170deg, -110deg, 260deg)\n"
      "MOVE JOINTS(-150deg, 40deg, 210deg, -170deg, 110deg, -260deg)\n"
      "MOVE JOINTS(150deg, -100deg, 90deg, 170deg, -110deg, 260deg)\n");
  for (const auto& row : trace.rows)
    for (std::size_t i = 0; i < 6; ++i) REQUIRE(std::abs(row.q[i] - row.measured[i]) < 0.5);
}

TEST_CASE("every axis of every arm jogs as fast as it can, and its servo follows") {
  for (const char* robot : {"ums7", "pc104", "lwa4p", "puma560", "irb120"}) {
    for (std::size_t axis = 0; axis < 6; ++axis) {
      CAPTURE(robot);
      CAPTURE(axis);
      std::string rates;
      for (std::size_t i = 0; i < 6; ++i) {
        rates += i == 0 ? "" : ", ";
        rates += i == axis ? "9999deg/s" : "0deg/s";
      }
      const json report = run("JOG JOINT (" + rates + ") FOR 0.15s\n", {"--robot", robot});
      CHECK(report["status"] == "done");
      CHECK(report["events"] == json::array());  // no warning of following errors either
      CHECK(std::next(report["peak"].begin(), static_cast<int>(axis)).value()["v"] > 10);
    }
  }
}

TEST_CASE("a SCARA goes to x, y, z and c, along lines, too; it has no other angles") {
  const json report =
      run("ROBOT \"t3\"\nMOVE (300, -100, -20, 0)\nMOVEL (300, 100, -20, 90) AT 200mm/s FINE\n"
          "ASSERT DIST(HERE, POSE(300mm, 100mm, -20mm)) < 0.001mm\nMOVE (c: 30deg) FINE\nSTOP\n");
  INFO(report.dump());
  CHECK(report["status"] == "done");
  check_pose(report, 300, 100, -20, 180, 0, 30);
  const RobCommand leaning("ROBOT \"t3\"\nMOVE POSE(200mm, 150mm, -100mm, 150deg, 0deg, 10deg)\n");
  const ProcessResult refused = leaning("check", {});
  CHECK(refused.exit_code == 65);
  CHECK(contains(refused.err, "E333"));
  CHECK(contains(refused.err,
                 "the nearest that it reaches is POSE(200mm, 150mm, -100mm, 180deg, 0deg, 10deg)"));
}

TEST_CASE("a line of a chain that leaves its reach is refused with line, place and nearest pose") {
  const RobCommand rob(
      "ROBOT \"ur5e\"\nMOVE (-450, -150, 350, 180, 0, 90) FINE\n"
      "MOVEL BY (-1000mm, 0mm, 0mm) AT 100mm/s\n");
  const ProcessResult result = rob("check", {});
  CHECK(result.exit_code == 65);
  CHECK(contains(result.err, ":3:"));
  CHECK(contains(result.err, "the nearest that it reaches is POSE(-"));
}
