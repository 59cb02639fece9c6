// In position: FINE, STOP and WAIT wait until the measured robot is within its window.
#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include "motion/robots/robot_file.h"
#include "runtime/run/foretell.h"
#include "runtime/run/simulation.h"
#include "tests/support/degrees.h"
#include "tests/support/stepped_run.h"

using namespace rob;
using runtime::RunResult;
using runtime::Snapshot;
using test::kDegree;
using test::SteppedRun;

namespace {

/// m, between the tool's places as measured and as told.
double tool_error(const motion::RobotModel& robot, const Snapshot& row,
                  const Eigen::Vector3d& tip = Eigen::Vector3d::Zero()) {
  const motion::Kinematics& tool = *robot.kinematics;
  return (place_of(tip, tool.forward(row.measured)) -
          place_of(tip, tool.forward(row.sample.reference.q)))
      .norm();
}

/// The embedded robot with a window.
motion::RobotModel settling(const char* name, double distance, double time = 1) {
  motion::RobotModel robot = motion::embedded_robot(name);
  robot.settle.distance = distance;
  robot.settle.time = time;
  return robot;
}

/// A run, and what can be seen from outside of when things happened.
struct Seen {
  SteppedRun run;
  RunResult result;

  Seen(const motion::RobotModel& robot, const std::string& program)
      : run(program, runtime::simulation_of(robot), 1, robot), result(run.run()) {}

  /// s, at which the output was set the n-th time.
  double set(const std::string& output, std::size_t n = 0) const {
    for (const runtime::SignalChange& signal : result.signals) {
      if (signal.name == output && n-- == 0) return signal.time;
    }
    return -1;
  }
  const Snapshot& row_at(double time) const {
    const auto at = std::llround(time / run.robot.reference_period);
    return run.rows.at(static_cast<std::size_t>(at));
  }
  double error_at(double time) const { return tool_error(run.robot, row_at(time)); }
  /// s, of the last row whose reference is that of the one at `time`, going back from there: since
  /// when it has stood.
  double stood_since(double time) const {
    auto at = static_cast<std::size_t>(std::llround(time / run.robot.reference_period));
    const motion::JointVector q = run.rows.at(at).sample.reference.q;
    while (at > 0 && run.rows[at - 1].sample.reference.q == q) --at;
    return run.rows[at].sample.reference.time;
  }
};

/// Looking ahead the arm brakes so hard that it is 0.8 mm behind its reference at the end, then
/// swings 0.4 mm beyond it.
constexpr const char* kFarAndBack =
    "LAW LOOKAHEAD\nSIGNAL flag = DOUT[1]\n"
    "MOVE(350, 150, 250, 180, 0, 180) FINE 0.2mm\n"
    "flag = ON\n"
    "MOVE(350, -150, 250, 180, 0, 180)\n";
constexpr double kWindow = 0.2e-3;  // m

}  // namespace

TEST_CASE("FINE with a distance waits until the measured tool is as near, on any robot") {
  const motion::RobotModel robot = motion::embedded_robot("irb120");
  const Seen seen(robot, kFarAndBack);
  REQUIRE(seen.result.status == "done");
  const double acted = seen.set("flag");
  const double rest = seen.stood_since(acted);
  REQUIRE(acted > rest);  // the arm lags behind: it has to be waited for
  CHECK(seen.error_at(acted) <= kWindow);
  // Before it was outside, or crossed the window in less than 50 ms.
  const motion::Kinematics& tool = *robot.kinematics;
  for (double t = rest; t < acted - 1e-6; t += robot.reference_period) {
    const double moved = (tool.forward(seen.row_at(t).measured).position -
                          tool.forward(seen.row_at(t - robot.reference_period).measured).position)
                             .norm();
    CHECK((seen.error_at(t) > kWindow || moved > kWindow * robot.reference_period / 0.05));
  }
  CHECK(seen.error_at(rest) > 0.5e-3);  // where it acts without a distance
  const Snapshot& next = seen.row_at(acted + robot.reference_period);
  CHECK(next.sample.reference.q != seen.row_at(acted).sample.reference.q);  // and goes on at once
}

TEST_CASE("without a distance and a window FINE ends with the reference") {
  std::string program = kFarAndBack;
  program.erase(program.find(" 0.2mm"), 6);
  const Seen seen(motion::embedded_robot("irb120"), program);
  CHECK(seen.set("flag") == doctest::Approx(seen.stood_since(seen.set("flag"))));
  CHECK(seen.error_at(seen.set("flag")) > 0.5e-3);
}

TEST_CASE("the time in which the robot comes into position belongs to its line, as measured") {
  const motion::RobotModel robot = motion::embedded_robot("irb120");
  const Seen seen(robot, kFarAndBack);
  const double measured = test::line(seen.result, 3).measured;
  CHECK(std::abs(measured - seen.set("flag")) <= robot.reference_period + 1e-9);
  CHECK(measured > seen.stood_since(seen.set("flag")) + 0.1);
}

TEST_CASE("with a window in the robot file FINE, STOP, WAIT and END wait for it") {
  const motion::RobotModel robot = settling("irb120", kWindow);
  for (const std::string exact : {" FINE\n", "\nSTOP\n", "\nWAIT 0s\n", "\nWAIT NOT flag\n"}) {
    CAPTURE(exact);
    const std::string program =
        "LAW LOOKAHEAD\nSIGNAL flag = DOUT[1]\n"
        "MOVE(350, 150, 250, 180, 0, 180)" +
        exact + "flag = ON\nWAIT 0s\n";
    const Seen seen(robot, program);
    REQUIRE(seen.result.status == "done");
    const double acted = seen.set("flag");
    CHECK(acted > seen.stood_since(acted));
    CHECK(seen.error_at(acted) <= kWindow);
    // A WAIT for a condition may take up to three cycles more.
    CHECK(seen.error_at(acted - 5 * robot.reference_period) > kWindow);
  }
  const Seen ended(robot, "LAW LOOKAHEAD\nMOVE(350, 150, 250, 180, 0, 180)\n");
  CHECK(tool_error(robot, ended.run.rows.back()) <= kWindow);
}

TEST_CASE("an output between a motion and the STOP that makes it exact waits, too") {
  for (const auto& [name, window] : {std::pair{"PAUL", 0.01e-3}, {"LOOKAHEAD", 0.05e-3}}) {
    const char* const law = name;
    CAPTURE(law);
    const Seen seen(settling("irb120", window, 10),
                    std::string("LAW ") + law +
                        "\nSIGNAL flag = DOUT[1]\nSIGNAL early = DOUT[2]\n"
                        "MOVE(350, 100, 250, 180, 0, 180) AT 50mm/s\nearly = ON\n"
                        "MOVE(350, 150, 250, 180, 0, 180) AT 50mm/s\nflag = ON\nSTOP\n"
                        "MOVE(350, 100, 250, 180, 0, 180)\n");
    REQUIRE(seen.result.status == "done");
    CHECK(seen.error_at(seen.set("flag")) <= window);
    CHECK(seen.set("flag") > seen.stood_since(seen.set("flag")));
    // What stands behind a blended motion acts in the middle of its corner, as ever.
    CHECK(seen.row_at(seen.set("early")).sample.reference.qd.norm() > 0.01);
  }
}

TEST_CASE("a distance behind FINE counts before that of the robot file, whose angle counts on") {
  motion::RobotModel robot = settling("irb120", 5e-3);
  const Seen nearer(robot, kFarAndBack);
  CHECK(nearer.error_at(nearer.set("flag")) <= kWindow);
  robot.settle.angle = 0.01 * kDegree;
  robot.settle.time = 5;
  const Seen turned(robot, kFarAndBack);
  REQUIRE(turned.result.status == "done");
  const Snapshot& row = turned.row_at(turned.set("flag"));
  CHECK((row.measured - row.sample.reference.q).cwiseAbs().maxCoeff() <= 0.01 * kDegree);
  CHECK(turned.set("flag") > nearer.set("flag"));
}

TEST_CASE("the distance is that of the tip of the tool") {
  const motion::RobotModel robot = motion::embedded_robot("irb120");
  const Seen seen(robot,
                  "LAW LOOKAHEAD\nSIGNAL flag = DOUT[1]\nTOOL rod = POSE(300mm, 0mm, 300mm)\n"
                  "WITH rod DO\nMOVE JOINT 6 BY 90deg FINE 0.5mm\nENDWITH\nflag = ON\nWAIT 0s\n");
  REQUIRE(seen.result.status == "done");
  const Eigen::Vector3d tip(0.3, 0, 0.3);
  const double acted = seen.set("flag");
  CHECK(acted > seen.stood_since(acted));
  CHECK(tool_error(robot, seen.row_at(acted), tip) <= 0.5e-3);
  CHECK(seen.error_at(seen.stood_since(acted)) < 0.5e-3);  // of the flange: it does not count
}

TEST_CASE("STOP waits also behind what has come to rest without it, and only once") {
  const motion::RobotModel robot = settling("irb120", 0.03e-3, 5);
  const Seen profiled(robot,
                      "SIGNAL flag = DOUT[1]\nMOVE(350, 150, 250, 180, 0, 180) PROFILE COSINE\n"
                      "STOP\nflag = ON\nSTOP\nWAIT 0s\n");
  REQUIRE(profiled.result.status == "done");
  CHECK(profiled.error_at(profiled.set("flag")) <= 0.03e-3);
  CHECK(test::line(profiled.result, 3).measured > 0);
  for (const runtime::LineResult& line : profiled.result.lines) CHECK(line.line <= 3);
}

TEST_CASE("a robot that does not come into position in time is a fault, and is held") {
  motion::RobotModel robot = motion::embedded_robot("irb120");
  robot.settle.time = 0.5;
  const Seen seen(robot,
                  "LAW LOOKAHEAD\nSIGNAL flag = DOUT[1] SAFE ON\nSIGNAL other = DOUT[2]\n"
                  "MOVE(350, 150, 250, 180, 0, 180) FINE 50um\nother = ON\n"
                  "MOVE(350, -150, 250, 180, 0, 180)\n");
  const std::string shown = seen.result.error ? seen.result.error->message : "";
  CAPTURE(shown);
  REQUIRE(seen.result.error.has_value());
  CHECK(seen.result.error->code == "E514");
  CHECK(seen.result.error->place.line == 4);
  CHECK(seen.result.exit_code == runtime::ExitCode::Fault);
  CHECK(shown.find("0.5 s after its reference has come to rest; 0.05 mm are permitted") !=
        std::string::npos);
  CHECK(seen.set("other") == -1);
  CHECK(seen.result.dropped_effects == 1);
  CHECK(seen.set("flag") > 0);  // its SAFE value
  const double given_up = seen.set("flag");
  CHECK(given_up - seen.stood_since(given_up) == doctest::Approx(0.5).epsilon(0.02));
  CHECK(seen.run.rows.back().sample.reference.q == seen.row_at(given_up).sample.reference.q);
}

TEST_CASE("an override and a hold do not end the waiting too soon") {
  const motion::RobotModel robot = settling("irb120", kWindow, 1);
  const auto moved = [&](double hold_for) {
    SteppedRun run(kFarAndBack, runtime::simulation_of(robot), 1, robot);
    double since = -1;
    run.each_cycle = [&](double time) {
      const Snapshot& row = run.rows.back();
      const bool rests = row.sample.tag == 3 && row.sample.reference.qd.norm() == 0 && time > 0.1;
      if (rests && since < 0) since = time;
      run.controller.channels().pause.ask(rests && time < since + hold_for);
    };
    const RunResult result = run.run();
    CHECK(result.status == "done");
    return result.measured;
  };
  CHECK(moved(3) > moved(0) + 2);  // longer than settle_time
}

TEST_CASE("a guarded motion is still guarded while it comes into position") {
  const motion::RobotModel robot = motion::embedded_robot("irb120");
  const std::string move = "LAW LOOKAHEAD\nMOVE(350, 150, 250, 180, 0, 180) FINE";
  const double rest = Seen(robot, move).result.measured;
  const Seen seen(robot, move + " 1um UNTIL CLOCK > " + std::to_string(rest + 0.1) +
                             "s\nPRINT HIT, \" \", CLOCK < " + std::to_string(rest + 0.15) + "s\n");
  REQUIRE(seen.result.status == "done");
  CHECK(seen.result.output == std::vector<std::string>{"TRUE TRUE"});
}

TEST_CASE("a handler may interrupt a motion that has a window, and its own FINE waits, too") {
  motion::RobotModel robot = settling("gantry", 0.02e-3, 5);
  const Seen seen(robot,
                  "SIGNAL flag = DOUT[1]\n"
                  "WHEN lift_up DO\nMOVE(0, 60, 0) FINE\nflag = ON\nlift = OFF\nENDWHEN\n"
                  "lift = ON\nMOVE(40, 0, 0) FINE\nPRINT HERE.x\nMOVE(0, 0, 0)\n");
  REQUIRE(seen.result.status == "done");
  CHECK(seen.result.output == std::vector<std::string>{"40mm"});
  CHECK(seen.error_at(seen.set("flag")) <= 0.02e-3);
}

TEST_CASE("in a PRESS the robot is in position where the force has led it") {
  const Seen seen(settling("lwa4p", 1e-3),
                  "LAW LOOKAHEAD\nMOVE(400, 60, 135) AT 50mm/s FINE\nWAIT 0.3s\nZERO force\n"
                  "PRESS Z 5N DO\nMOVEL BY (0mm, 20mm, 0mm) AT 10mm/s FINE\nENDPRESS\n"
                  "PRINT \"pressed\"\n");
  CAPTURE(seen.result.error.has_value());
  CHECK(seen.result.output == std::vector<std::string>{"pressed"});
}

TEST_CASE("a run that waits for the measured robot has the same bits every time") {
  const Seen one(motion::embedded_robot("irb120"), kFarAndBack);
  const Seen two(motion::embedded_robot("irb120"), kFarAndBack);
  REQUIRE(one.run.rows.size() == two.run.rows.size());
  for (std::size_t i = 0; i < one.run.rows.size(); ++i) {
    REQUIRE(one.run.rows[i].sample.reference.q == two.run.rows[i].sample.reference.q);
    REQUIRE(one.run.rows[i].measured == two.run.rows[i].measured);
  }
}

TEST_CASE("rob check foretells the reference's time, and says so once") {
  const motion::RobotModel with = settling("gantry", 0.1e-3);
  const motion::RobotModel without = motion::embedded_robot("gantry");
  const std::string text = "MOVE(40, 0, 0) FINE\nMOVE(80, 0, 0)\nSTOP\nSTOP\nWAIT 1s\n";
  const auto foretold = [&](const motion::RobotModel& robot) {
    const runtime::LoadedProgram program = runtime::compile_program("test.rob", text, robot);
    return runtime::foretell(program, program.robot, {});
  };
  const RunResult waiting = foretold(with);
  const RunResult plain = foretold(without);
  CHECK(waiting.planned == plain.planned);
  REQUIRE(waiting.lines.size() == plain.lines.size());
  for (std::size_t i = 0; i < plain.lines.size(); ++i)
    CHECK(waiting.lines[i].planned == plain.lines[i].planned);
  CHECK(plain.findings.empty());
  REQUIRE(waiting.findings.size() == 1);
  CHECK(waiting.findings.front().code == "N634");
  CHECK(waiting.findings.front().severity == lang::Severity::Note);
}
