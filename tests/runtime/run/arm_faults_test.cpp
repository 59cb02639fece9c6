// The rows of docs/faults.md that are about drives and encoders, on the simulated arms: the UMS-7
// with its mechanics and forces, S3's arm with its pulses. And the UMS-7 at S2's servo periods.
#include <doctest/doctest.h>

#include <cmath>
#include <memory>
#include <string>

#include "motion/robots/robot_file.h"
#include "motion/robots/robot_library.h"
#include "runtime/run/simulation.h"
#include "tests/support/degrees.h"
#include "tests/support/faulty_backend.h"
#include "tests/support/relative.h"
#include "tests/support/stepped_run.h"

using namespace rob;
using Fault = test::FaultyBackend::Fault;
using rob::test::kDegree;

namespace {

/// Axis 1 alone, 80 degrees; at 60 deg/s from 0.5 s on.
constexpr const char* kTurn = "MOVE JOINT 1 BY 80deg\nSTOP\nEND\n";

struct ArmRun {
  std::unique_ptr<motion::ServoBackend> machine;
  test::SteppedRun run;
  runtime::RunResult result;

  ArmRun(const motion::RobotModel& robot, const std::string& program, Fault fault = Fault::None,
         double jump = 0)
      : machine(runtime::simulation_of(robot)),
        run(program, spoilt(fault, jump), 1, robot),
        result(run.run()) {}

  std::unique_ptr<motion::ServoBackend> spoilt(Fault fault, double jump) {
    auto faulty = std::make_unique<test::FaultyBackend>(*machine);
    faulty->inject(fault, 0.8, 0, jump);
    return faulty;
  }

  /// |reference − measured| of any axis at any stamp, degrees.
  double worst_error() const {
    double worst = 0;
    for (const runtime::Snapshot& row : run.rows)
      worst =
          std::max(worst, (row.sample.reference.q - row.measured).cwiseAbs().maxCoeff() / kDegree);
    return worst;
  }

  void check_stop(const char* code) const {
    CHECK(result.status == "fault");
    CHECK(result.exit_code == runtime::ExitCode::Fault);
    REQUIRE(result.error.has_value());
    CHECK(result.error->code == code);
    CHECK(result.error->message.find("axis " + run.robot.axes[0].name) != std::string::npos);
    CHECK(result.measured > 0.8);
    for (const runtime::Snapshot& row : run.rows) {
      for (int i = 0; i < 6; ++i) {
        const motion::Axis& axis = run.robot.axes[static_cast<std::size_t>(i)];
        CHECK(std::abs(row.sample.reference.qd[i]) <= axis.v_max + 1e-12);
        CHECK(std::abs(row.sample.reference.qdd[i]) <= axis.a_max + 1e-12);
      }
    }
    CHECK(run.rows.back().sample.reference.qd.norm() == 0.0);
  }
};

/// A robot file with words put in the place of all others like them.
motion::RobotModel edited(const char* name,
                          const std::vector<std::pair<std::string, std::string>>& edits) {
  std::string text;
  for (const motion::EmbeddedRobot& robot : motion::embedded_robots())
    if (robot.name == name) text = robot.text;
  for (const auto& [was, is] : edits) {
    REQUIRE(text.find(was) != std::string::npos);
    for (std::size_t at = text.find(was); at != std::string::npos;
         at = text.find(was, at + is.size()))
      text.replace(at, was.size(), is);
  }
  return motion::parse_robot_file(text, "edited.toml");
}

/// The UMS-7 with a quick servo, axes 1 and 2 with motors just strong enough for a_max, and four
/// times the friction that the servo knows: 188 Nm at full speed where there are 155.
motion::RobotModel weak_arm() {
  return edited("ums7", {{"servo_period = \"20 ms\"", "servo_period = \"2 ms\""},
                         {"bandwidth = \"10 rad/s\"", "bandwidth = \"40 rad/s\""},
                         {"force_max = \"1000 Nm\"", "force_max = \"155 Nm\""},
                         {"\n[dynamics]", "\n[simulation]\nfriction = 4\n[dynamics]"}});
}

}  // namespace

TEST_CASE("fault 18: a locked joint of an arm stops the run with axis and error") {
  for (const char* name : {"ums7", "pc104"}) {
    CAPTURE(name);
    const ArmRun arm(motion::embedded_robot(name), kTurn, Fault::LockedJoint);
    arm.check_stop("E502");
    // 4 and 2 degrees of way at 60 deg/s, and two servo cycles.
    CHECK(arm.result.measured < 0.8 + 4.0 / 60 + 0.04 + 1.0);
  }
}

TEST_CASE("fault 19: an arm's encoder that freezes stops the run and names the axis") {
  for (const char* name : {"ums7", "pc104"}) {
    CAPTURE(name);
    ArmRun(motion::embedded_robot(name), kTurn, Fault::FrozenEncoder).check_stop("E503");
  }
}

TEST_CASE("fault 19: an arm's encoder that jumps stops the run and names the axis") {
  // More than 2·60 deg/s in a servo period: 2.4° in 20 ms, 0.24° in 2 ms.
  ArmRun(motion::embedded_robot("ums7"), kTurn, Fault::JumpingEncoder, 4 * kDegree)
      .check_stop("E504");
  ArmRun(motion::embedded_robot("pc104"), kTurn, Fault::JumpingEncoder, 0.4 * kDegree)
      .check_stop("E504");
}

static void check_relief(const std::string& law) {
  // The rate recovers within 0.5 s, part of it at the end of the way.
  const ArmRun arm(weak_arm(), law +
                                   "MOVE JOINTS(80deg, -90deg, 135deg, 0deg, 90deg, 0deg)\nSTOP\n"
                                   "WAIT 0.5s\nEND\n");
  CHECK(arm.result.status == "done");
  CHECK(arm.result.worst_saturation > 1);
  // 160·v + 20 Nm of friction leave (155 − 20)/160 rad/s, 0.81 of the 60 deg/s that are programmed.
  CHECK(arm.result.measured > arm.result.planned + 0.1);
  double least = 1;
  double off_line = 0;
  for (const runtime::Snapshot& row : arm.run.rows) {
    least = std::min(least, row.override_share);
    // Axes 1 and 2 on their common line from (0, −45) to (80, −90): the distance from it.
    const double x = row.measured[0] / kDegree;
    const double y = row.measured[1] / kDegree + 45;
    off_line = std::max(off_line, std::abs(x * 45 + y * 80) / std::hypot(45, 80));
  }
  CHECK(least < 0.9);
  CHECK(least >= 0.1);
  CHECK(off_line < 0.25);
  CHECK(arm.worst_error() < 1);
  CHECK(arm.run.rows.back().override_share == 1);
  int told = 0;
  for (const auto& event : arm.result.events)
    if (event.kind == "warning" && event.text.find("slowed down") != std::string::npos) ++told;
  CHECK(told == 1);
}

TEST_CASE("fault 20: where drives are too weak the path is stretched in time, not left") {
  check_relief("LAW PAUL\n");
}

TEST_CASE("fault 20 under the look-ahead law") { check_relief("LAW LOOKAHEAD\n"); }

TEST_CASE("drives that suffice are asked for nothing more than once: the path keeps its time") {
  const ArmRun arm(motion::embedded_robot("ums7"), kTurn);
  CHECK(arm.result.worst_saturation < 1);
  CHECK(arm.result.measured == test::relative(arm.result.planned));
  for (const runtime::Snapshot& row : arm.run.rows) CHECK(row.override_share == 1);
}

TEST_CASE("S2's servo at 15 ms between references every 40 ms") {
  const auto at = [](const std::string& period, const std::string& bandwidth) {
    return ArmRun(
        edited("ums7", {{"servo_period = \"20 ms\"", "servo_period = \"" + period + "\""},
                        {"bandwidth = \"10 rad/s\"", "bandwidth = \"" + bandwidth + "\""}}),
        kTurn);
  };
  const ArmRun reached = at("20 ms", "10 rad/s");
  const ArmRun wanted = at("15 ms", "13.3 rad/s");
  CHECK(wanted.result.status == "done");
  CHECK(wanted.run.rows.size() == reached.run.rows.size());
  CHECK(wanted.result.measured == reached.result.measured);
  // kp grows with ω²: (10/13.3)² = 0.57 of the error that friction makes.
  CHECK(wanted.worst_error() < 0.8 * reached.worst_error());
}
