// The SO-101, commanded in poses and with its gripper by name: the same program in the simulation
// and on its bus.
#include <doctest/doctest.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "tests/emulators/servo_emulator.h"
#include "tests/support/degrees.h"
#include "tests/support/rob_command.h"

using nlohmann::json;
using rob::test::contains;
using rob::test::kDegree;
using rob::test::ProcessResult;
using rob::test::RobCommand;
using rob::test::ServoEmulator;

namespace {

const std::string kArm = "ROBOT \"so101\"\n";

/// Where the tips are, mm, and how far they lean from level, down, deg.
struct Tips {
  double x;
  double y;
  double z;
  double down;
};

/// By plane geometry, from the published places: the arm stands in an upright plane, 30.399 mm
/// beside axis 1; lift, elbow and wrist all lean it forward. Axis 5 runs along the gripper, 0.178
/// mm beside the plane; from it the tips are 7.9 mm below and 0.218 mm aside. deg.
Tips tips_of(double pan, double lift, double elbow, double wrist, double roll) {
  double ahead = 30.399;
  double up = 94.882 + 54.2;
  double leaning = 0;
  const auto go = [&](double forward, double upward) {
    ahead += forward * std::cos(leaning) + upward * std::sin(leaning);
    up += upward * std::cos(leaning) - forward * std::sin(leaning);
  };
  leaning += lift * kDegree;
  go(28, 112.57);
  leaning += elbow * kDegree;
  go(134.9, 5.2);
  leaning += wrist * kDegree;
  const double turn = roll * kDegree;
  const double below = 7.9 * std::cos(turn) - 0.218 * std::sin(turn);
  const double aside = -0.178 - 7.9 * std::sin(turn) - 0.218 * std::cos(turn);
  go(61.1 + 98.127, -below);
  const double around = -pan * kDegree;
  return {ahead * std::cos(around) - aside * std::sin(around),
          ahead * std::sin(around) + aside * std::cos(around), up, lift + elbow + wrist};
}

/// The last line of a trace, by the names of its columns.
double last_of(const std::string& trace, const std::string& column) {
  std::ifstream file(trace);
  std::string names;
  std::string line;
  std::string last;
  std::getline(file, names);
  while (std::getline(file, line)) last = line;
  std::istringstream heads(names);
  std::istringstream values(last);
  std::string head;
  std::string value;
  while (std::getline(heads, head, ',') && std::getline(values, value, ','))
    if (head == column) return std::stod(value);
  FAIL("no column " << column << " in " << names);
  return 0;
}

/// Where the references of a run end.
Tips reached(const std::string& trace) {
  const auto axis = [&](const char* name) { return last_of(trace, std::string(name)); };
  return tips_of(axis("q1"), axis("q2"), axis("q3"), axis("q4"), axis("q5"));
}

}  // namespace

TEST_CASE("targets of five axes are reached within 0.01 mm, as plane geometry has it") {
  struct Case {
    const char* line;
    double x;
    double y;
    double z;
    double down;
  };
  const Case cases[] = {
      {"MOVE(220, 0, 60, 180, 0)", 220, 0, 60, 90},
      {"MOVEL(190, 60, 50, 180, 0, gripper: 60deg)", 190, 60, 50, 90},
      {"MOVE(x: 180, y: -90, z: 80, a: 180, b: 0)", 180, -90, 80, 90},
      {"MOVE(250, 30, 200, 180, -90)", 250, 30, 200, 0},
      {"MOVE(230, -20, 160, 180, -60)", 230, -20, 160, 30},
      {"MOVE POSE(200mm, 30mm, 60mm, 180deg, 0deg, 10deg)", 200, 30, 60, 90},
  };
  for (const Case& one : cases) {
    CAPTURE(one.line);
    const RobCommand rob(kArm + "MOVE(200, 0, 80, 180, 0)\n" + one.line + "\nSTOP\n");
    const std::string trace = rob.file("trace.csv");
    const ProcessResult result = rob("run", {"--fast", "--trace", trace});
    REQUIRE_MESSAGE(result.exit_code == 0, result.err);
    const Tips at = reached(trace);
    CHECK(std::hypot(at.x - one.x, at.y - one.y, at.z - one.z) < 0.01);
    CHECK(std::abs(at.down - one.down) < 0.01);
  }
}

TEST_CASE("the gripper goes by its name: alone, on a line, and not with a pose") {
  const std::string say = "STOP\nj = JOINTS()\nPRINT ROUND(j[6], 0.1deg)\n";
  const RobCommand rob(kArm + "VAR j = JOINTS()\nMOVE(200, 0, 80, 180, 0, gripper: 40deg)\n" + say +
                       "VAR p = HERE\nMOVE(gripper: 20deg)\n" + say +
                       "PRINT DIST(p, HERE) < 0.001mm\nMOVEL BY (z: -20mm, gripper: 15deg)\n" +
                       say + "MOVE p\n" + say);
  const ProcessResult result = rob("run", {"--fast"});
  REQUIRE_MESSAGE(result.exit_code == 0, result.err);
  CHECK(result.out.starts_with("40deg\n20deg\nTRUE\n35deg\n35deg\n"));
}

TEST_CASE("straight down axis 5 keeps its value with c left out, and gives c to a whole pose") {
  const std::string roll = "STOP\nj = JOINTS()\nPRINT ROUND(j[5], 0.0001deg)\n";
  const RobCommand rob(kArm +
                       "VAR j = JOINTS()\nMOVE JOINT 5 TO 20deg\nMOVE(200, 0, 60, 180, 0)\n" +
                       roll + "MOVEL(190, 60, 50, 180, 0)\n" + roll +
                       "MOVE POSE(200mm, 30mm, 60mm, 180deg, 0deg, 40deg)\nSTOP\nPRINT "
                       "ROUND(HERE.c, 0.001deg)\n");
  const ProcessResult result = rob("run", {"--fast"});
  REQUIRE_MESSAGE(result.exit_code == 0, result.err);
  CHECK_MESSAGE(result.out.starts_with("20deg\n20deg\n40deg\n"), result.out);
}

TEST_CASE("what a gripper cannot do is refused before anything moves") {
  for (const char* line : {"MOVE(gripper: 101deg)", "MOVEL(190, 60, 50, 180, 0, gripper: 101deg)",
                           "MOVE(x: 210mm, gripper: 101deg)"}) {
    CAPTURE(line);
    const RobCommand rob(kArm + "MOVE(200, 0, 80, 180, 0)\n" + line + "\n");
    const ProcessResult result = rob("check", {});
    CHECK(result.exit_code == 65);
    CHECK(contains(result.err, ":3:"));
    CHECK(contains(result.err, "gripper"));
    CHECK(contains(result.err, "100 deg"));
  }
}

TEST_CASE("a whole pose must have the c that the place gives; elsewhere its message has it") {
  const RobCommand rob(kArm + "MOVE POSE(160mm, 160mm, 160mm, 180deg, -60deg, 0deg)\n");
  const ProcessResult result = rob("check", {});
  CHECK(result.exit_code == 65);
  // From (−0.396 aside) the arm points to 45 deg, and a little beside.
  CHECK_MESSAGE(contains(result.err, "45."), result.err);
}

TEST_CASE(
    "the SO-101 in the simulation and over feetech: goes to the same places in the same time") {
  const RobCommand rob(kArm +
                       "MOVE JOINTS(30deg, 20deg, -20deg, 60deg, 0deg, 60deg)\nMOVE JOINTS(-30deg, "
                       "20deg, -20deg, 60deg, 90deg, 10deg)\nSTOP\n");
  const ProcessResult simulated = rob("run", {"--fast", "--json"});
  REQUIRE_MESSAGE(simulated.exit_code == 0, simulated.err);
  ServoEmulator bus(ServoEmulator::Kind::Feetech, 6);
  const ProcessResult wired = rob("run", {"--json", "--backend", "feetech:" + bus.path()});
  REQUIRE_MESSAGE(wired.exit_code == 0, wired.err);
  const double planned = json::parse(simulated.out)["planned_s"];
  CHECK(json::parse(wired.out)["planned_s"].get<double>() ==
        doctest::Approx(planned).epsilon(0.01));
  CHECK(bus.moved_for() == doctest::Approx(planned).epsilon(0.1));
  const double end[] = {-30, 20, -20, 60, 90, 10};
  for (int id = 1; id <= 6; ++id) {
    CAPTURE(id);
    CHECK(std::abs(bus.position(id) - (2048 + end[id - 1] * 4096 / 360)) < 1);
    CHECK(std::abs(json::parse(simulated.out)["final"]["joints"][static_cast<std::size_t>(id - 1)]
                       .get<double>() -
                   end[id - 1]) < 1);
  }
}

TEST_CASE("over feetech the gripper's servo alone turns with gripper:") {
  const RobCommand rob(kArm + "MOVE(gripper: 45deg)\nSTOP\n");
  ServoEmulator bus(ServoEmulator::Kind::Feetech, 6);
  const ProcessResult wired = rob("run", {"--backend", "feetech:" + bus.path()});
  REQUIRE_MESSAGE(wired.exit_code == 0, wired.err);
  for (int id = 1; id <= 5; ++id) CHECK(std::abs(bus.position(id) - 2048) < 1);
  CHECK(std::abs(bus.position(6) - (2048 + 45 * 4096 / 360)) < 1);
}

TEST_CASE("a point that was taught is gone to on the SO-101, and the gripper stays") {
  const RobCommand rob(
      kArm +
      "POINT part\nMOVE JOINTS(10deg, 20deg, 0deg, 0deg, 0deg, 30deg)\nTEACH part\nMOVE "
      "JOINTS(0deg, 0deg, 0deg, 0deg, 0deg, 50deg)\nMOVE part\nSTOP\n");
  const ProcessResult result = rob("run", {"--fast", "--json"});
  REQUIRE_MESSAGE(result.exit_code == 0, result.err);
  const json joints = json::parse(result.out)["final"]["joints"];
  CHECK(std::abs(joints[0].get<double>() - 10) < 0.2);
  CHECK(std::abs(joints[5].get<double>() - 50) < 0.2);
}
