#include <doctest/doctest.h>

#include <string>

#include "motion/robots/robot_file.h"
#include "motion/robots/robot_library.h"
#include "tests/support/relative.h"

using namespace rob::motion;

namespace {

std::string text_of_arm(const char* name) {
  for (const EmbeddedRobot& robot : embedded_robots())
    if (robot.name == name) return std::string(robot.text);
  FAIL("no such robot");
  return "";
}

/// What is wrong with the file after the edit, without the place; empty: nothing.
std::string mechanics_error(const char* name, const std::string& was, const std::string& is) {
  std::string text = text_of_arm(name);
  REQUIRE(text.find(was) != std::string::npos);
  text.replace(text.find(was), was.size(), is);
  try {
    parse_robot_file(text, "arm.toml");
  } catch (const RobotFileError& error) {
    const std::string what = error.what();
    CHECK(what.starts_with("arm.toml:"));
    return what.substr(what.find(": ") + 2);
  }
  return "";
}

std::string mechanics_error(const std::string& was, const std::string& is) {
  return mechanics_error("ums7", was, is);
}

}  // namespace

TEST_CASE("S2's table and the motors are read from the file") {
  const RobotModel robot = embedded_robot("ums7");
  REQUIRE(robot.mechanics);
  const Ums7Parameters& p = robot.mechanics->dynamics.parameters();
  CHECK(p.c0 == 0.8);
  CHECK(p.c2 == 2.24);
  CHECK(p.c6 == 2.35);
  CHECK(p.c8 == 0.004);
  CHECK(p.upper_pull == 0);
  const GearedMotor& motor = robot.mechanics->motors[5];
  CHECK(motor.inertia == rob::test::relative(80 * 80 * 1.5e-5));
  CHECK(motor.load_factor == rob::test::relative(1 / 0.9));
  CHECK(motor.torque_max == 10);
  CHECK_FALSE(embedded_robot("lwa4p").mechanics);
  CHECK_FALSE(embedded_robot("gantry").mechanics);
}

TEST_CASE("the table of the UMS-7 is that of the masses which its file names") {
  const RobotModel robot = embedded_robot("ums7");
  const Ums7Parameters& p = robot.mechanics->dynamics.parameters();
  constexpr double kUpper = 12;
  constexpr double kFore = 8;
  constexpr double kHand = 3;
  constexpr double kLength = 0.4;
  const double square = kLength * kLength;
  CHECK(p.c1 == doctest::Approx(kUpper * square / 3 + (kFore + kHand) * square));
  CHECK(p.c3 == doctest::Approx(kFore * square / 3 + kHand * square).epsilon(0.01));
  CHECK(p.c5 == doctest::Approx(square * (kFore / 2 + kHand)));
  CHECK(p.c4 == doctest::Approx(p.c1 + p.c3));
  CHECK(p.c6 == doctest::Approx(kHand * 9.81 * 0.08).epsilon(0.01));
  CHECK(p.c7 == doctest::Approx(kHand * 0.08 * 0.08 + 0.005).epsilon(0.01));
}

TEST_CASE("a drive's inertia is no more than the least that the mechanics give") {
  const RobotModel robot = embedded_robot("ums7");
  for (double q2 = -2; q2 < 1; q2 += 0.1) {
    for (double q3 = -0.7; q3 < 3.8; q3 += 0.1) {
      JointVector q = JointVector::Zero(6);
      q[1] = q2;
      q[2] = q3;
      q[4] = q3;
      const JointVector h = robot.mechanics->dynamics.inertia(q).diagonal();
      for (int i = 0; i < 6; ++i) {
        const auto at = static_cast<std::size_t>(i);
        const GearedMotor& motor = robot.mechanics->motors[at];
        CHECK(robot.axes[at].drive.inertia <= motor.load_factor * h[i] + motor.inertia);
      }
    }
  }
}

TEST_CASE("a table of dynamics that is no arm's is refused") {
  CHECK(mechanics_error("c2 = \"2.24 kg*m^2\"", "c2 = \"2 kg*m^2\"") ==
        "dynamics: c2 must be 2*c5");
  CHECK(mechanics_error("c8 = \"0.004 kg*m^2\"", "c8 = \"0 kg*m^2\"") ==
        "dynamics: c0, c7 and c8 must be above 0");
  CHECK(mechanics_error("c8 = \"0.004 kg*m^2\"", "") == "c8 of dynamics: is missing");
  CHECK(
      mechanics_error("c6 = \"2.35 Nm\"", "c6 = \"2.35 kg*m^2\"").starts_with("c6 of dynamics: "));
  CHECK(mechanics_error("c6 = \"2.35 Nm\"", "c9 = \"2.35 Nm\"").starts_with("unknown key \"c9\""));
}

TEST_CASE("motors and dynamics belong together") {
  CHECK(mechanics_error(
            "[axis.motor]\ngear = 120\nrotor_inertia = \"1e-3 kg*m^2\"\nefficiency = 0.9\n"
            "torque_max = \"300 Nm\"\n",
            "") == "motor of axis q1: is missing");
  CHECK(mechanics_error("lwa4p", "[axis.drive]", "[axis.motor]\ngear = 1\n[axis.drive]")
            .ends_with("belongs to a table [dynamics], which is missing"));
  CHECK(mechanics_error("gantry", "[[axis]]", "[dynamics]\n[[axis]]") ==
        "dynamics: belongs to kinematics = \"arm\": its table is of such an arm");
}

TEST_CASE("the simulated arm may differ from what the servo counts with") {
  CHECK(embedded_robot("ums7").deviation.payload == 0);
  std::string text = text_of_arm("ums7");
  text.insert(text.find("[dynamics]"), "[simulation]\npayload = \"3 kg\"\nfriction = 1.5\n\n");
  const RobotModel robot = parse_robot_file(text, "arm.toml");
  CHECK(robot.deviation.payload == 3);
  CHECK(robot.deviation.masses == 1);
  CHECK(robot.deviation.friction == 1.5);
  CHECK(robot.mechanics->dynamics.parameters().c6 == 2.35);
  CHECK(mechanics_error("[dynamics]", "[simulation]\nmasses = 0\n\n[dynamics]") ==
        "masses of simulation: must be a number from 0.1 to 10, without quotation marks");
  CHECK(mechanics_error("[dynamics]", "[simulation]\nmass = 2\n\n[dynamics]")
            .starts_with("unknown key \"mass\" in simulation; did you mean \"masses\"?"));
  CHECK(mechanics_error("lwa4p", "[[axis]]", "[simulation]\n[[axis]]") ==
        "simulation: needs a table [dynamics], which is missing");
}

TEST_CASE("a motor is read strictly") {
  CHECK(mechanics_error("gear = 120", "gear = 0") ==
        "gear of motor of axis q1: must be a number from 0.1 to 10000, without quotation marks");
  CHECK(mechanics_error("gear = 120", "gear = \"120\"")
            .starts_with("gear of motor of axis q1: must be"));
  CHECK(mechanics_error("gear = 120", "gear = 120.5").empty());
  CHECK(mechanics_error("efficiency = 0.9", "efficiency = 1.1").starts_with("efficiency of motor"));
  CHECK(mechanics_error("efficiency = 0.9", "efficiency = nan").starts_with("efficiency of motor"));
  CHECK(mechanics_error("torque_max = \"300 Nm\"", "torque_max = \"0 Nm\"")
            .starts_with("torque_max of"));
}
