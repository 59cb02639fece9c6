#include <doctest/doctest.h>

#include <cmath>

#include "tests/support/felt_world.h"
#include "tests/support/relative.h"
#include "tests/support/stepped_run.h"

namespace rob::runtime {
namespace {

using motion::Pose;
using motion::Wrench;

const motion::RobotModel& arm() {
  static const motion::RobotModel robot = [] {
    motion::RobotModel made = motion::embedded_robot("lwa4p");
    made.force = {.delay = 0.01, .stiffness = made.force.stiffness};  // it is never stuck
    return made;
  }();
  return robot;
}

/// Where the flange stands at the start of a run, m.
Eigen::Vector3d start() { return arm().kinematics->forward(arm().start).position; }

/// A run of the arm that feels a world.
struct Felt {
  test::SteppedRun run;
  RunResult result;

  Felt(const std::string& program, test::FeltWorld::Acts acts, int late = 0)
      : run(program,
            std::make_unique<test::FeltWorld>(test::simulated(arm()), arm().kinematics,
                                              std::move(acts), late),
            1, arm()) {}
  const RunResult& go() { return result = run.run(); }
  /// The code of the error that has ended the program; empty: none.
  std::string failure() {
    go();
    if (result.error) return result.error->code;
    return run.task.failure() ? run.task.failure()->code : "";
  }
};

/// A table of 50 N/mm, `gap` m below the start.
test::FeltWorld::Acts table(double gap, double stiffness = 50e3) {
  return [top = start().z() - gap, stiffness](double, const Pose& flange) {
    Wrench wrench;
    wrench.force.z() = std::max(0.0, top - flange.position.z()) * stiffness;
    return wrench;
  };
}

test::FeltWorld::Acts always(const Eigen::Vector3d& force, const Eigen::Vector3d& torque) {
  return [wrench = Wrench{force, torque}](double, const Pose&) { return wrench; };
}

/// The greatest leap of an axis' acceleration from row to row, by differences of the places.
double roughest(const std::vector<Snapshot>& rows, double period) {
  double greatest = 0;
  for (std::size_t k = 2; k < rows.size(); ++k) {
    const auto q = [&](std::size_t i) { return rows[i].sample.reference.q; };
    greatest = std::max(
        greatest, ((q(k) - q(k - 1) * 2 + q(k - 2)) / (period * period)).cwiseAbs().maxCoeff());
  }
  return greatest;
}

}  // namespace

TEST_CASE("force and torque are the reaction on the tool, along the axes of the active frame") {
  // The flange points down: its z is the world's −z. F turns the world by 90° about z.
  Felt felt(
      "FRAME f = POSE(0mm, 0mm, 0mm, 0deg, 0deg, 90deg)\n"
      "PRINT force.x, \" \", force.y, \" \", force.z, \" \", torque.z\n"
      "WITH IN TOOL DO\nPRINT ROUND(WRENCH().force.z/1N), \" \", ROUND(torque.z/0.1Nm)\nENDWITH\n"
      "WITH IN f DO\nPRINT ROUND(force.x/1N), \" \", ROUND(force.y/1N)\nENDWITH\n",
      always({1, 2, 3}, {0, 0, 0.5}));
  const RunResult& result = felt.go();
  REQUIRE(result.output.size() == 3);
  CHECK(result.output[0] == "1N 2N 3N 0.5Nm");
  CHECK(result.output[1] == "-3 -5");
  CHECK(result.output[2] == "2 -1");
}

TEST_CASE("ZERO force takes what acts at rest for nothing, whatever way the tool turns later") {
  Felt felt(
      "ZERO force\nPRINT force.z\nMOVE JOINT 6 TO 90deg AT 100deg/s\nSTOP\nPRINT ROUND(force.x/1N),"
      " \" \", ROUND(force.z/1N)\n",
      [](double time, const Pose& flange) {
        // The sensor's own bias turns with the flange; 4 N more act from 1 s on.
        Wrench wrench;
        wrench.force = flange.orientation * Eigen::Vector3d(3, 0, -7);
        if (time > 1) wrench.force.z() += 4;
        return wrench;
      });
  const RunResult& result = felt.go();
  CHECK(result.output.at(0) == "0N");
  CHECK(result.output.at(1) == "0 4");
}

TEST_CASE("ZERO force averages the noise of the last twentieth of a second") {
  // ± 1 N from cycle to cycle: no single sample is 0.
  Felt felt("ZERO force\nPRINT ABS(force.z) > 0.9N AND ABS(force.z) < 1.1N\n",
            [up = false](double, const Pose&) mutable {
              up = !up;
              Wrench wrench;
              wrench.force.z() = 20 + (up ? 1 : -1);
              return wrench;
            });
  CHECK(felt.go().output.at(0) == "TRUE");
}

TEST_CASE("a motion ends by a force, and says where") {
  Felt felt(
      "MOVEL BY (0mm, 0mm, -25mm) AT 5mm/s UNTIL force.z > 3N ELSE RAISE \"no tube\"\n"
      "PRINT HIT\nPRINT TARGET.z < HITPOSE.z\n",
      table(10e-3));
  const RunResult& result = felt.go();
  CHECK(result.output.at(0) == "TRUE");
  CHECK(result.output.at(1) == "TRUE");
  // 3 N of 50 N/mm are 0.06 mm; a servo cycle, and a period until it is looked at: 6 ms at 5 mm/s.
  double tripped = 0;
  for (const Snapshot& row : felt.run.rows)
    if (row.wrench.force.z() > 3 && tripped == 0)
      tripped = arm().kinematics->forward(row.measured).position.z();
  CHECK(start().z() - tripped > 10.06e-3);
  CHECK(start().z() - tripped < 10.06e-3 + 0.006 * 5e-3 + 1e-5);
}

TEST_CASE("PRESS reaches its force before its body begins, keeps it, and the path goes on there") {
  Felt felt(
      "MOVEL BY (0mm, 0mm, -8mm) AT 20mm/s\n"
      "PRESS Z 10N LIMIT 5mm/s DO\nPRINT ABS(force.z - 10N) < 1.5N\n"
      "MOVE JOINT 6 TO 2rad AT 0.8rad/s\nENDPRESS\n"
      "PRINT force.z > 8.5N\nMOVEL BY (0mm, 0mm, 30mm) AT 50mm/s\n",
      [up = table(10e-3)](double time, const Pose& flange) {
        Wrench wrench = up(time, flange);  // it sinks as S4's cap, from 4 s on
        const double sunk = std::clamp(time - 4, 0.0, 1.0) * 0.4e-3 * 50e3;
        wrench.force.z() = std::max(0.0, wrench.force.z() - sunk);
        return wrench;
      },
      5);
  const RunResult& result = felt.go();
  CHECK(result.output.at(0) == "TRUE");
  CHECK(result.output.at(1) == "TRUE");
  bool turned = false;
  for (const Snapshot& row : felt.run.rows) {
    if (row.sample.state != motion::MotionState::Pressing) continue;
    CHECK(row.wrench.force.z() < 20);
    if (std::abs(row.sample.reference.q[5]) < 0.1 || row.sample.reference.q[5] > 1.9) continue;
    turned = true;
    CHECK(std::abs(row.wrench.force.z() - 10) < 1.5);
  }
  CHECK(turned);
  // No axis is told to leap: 450 and 750 deg/s² are the arm's.
  CHECK(roughest(felt.run.rows, arm().reference_period) < 750 * 3.15 / 180);
  // 30 mm above where the force had led it.
  const auto& rows = felt.run.rows;
  double lowest = 1;
  for (const Snapshot& row : rows)
    lowest = std::min(lowest, arm().kinematics->forward(row.sample.reference.q).position.z());
  const double last = arm().kinematics->forward(rows.back().sample.reference.q).position.z();
  CHECK(last - lowest == test::relative(30e-3, 0.01));
}

TEST_CASE("a PRESS that meets nothing is an error; so is a motion along its axis") {
  Felt nothing(
      "TRY\nPRESS Z 10N LIMIT 20mm/s DO\nMOVE JOINT 6 TO 1rad\nENDPRESS\nRESCUE why\n"
      "PRINT why\nENDTRY\nMOVEL BY (0mm, 0mm, 10mm) AT 50mm/s\n",
      always({0, 0, 0}, {0, 0, 0}));
  const RunResult& result = nothing.go();
  CHECK(result.output.at(0).starts_with("E570"));
  const auto& rows = nothing.run.rows;
  const double end = arm().kinematics->forward(rows.back().sample.reference.q).position.z();
  CHECK(start().z() - end == test::relative(0.04, 0.02));  // 50 mm down, 10 mm up

  Felt along(
      "MOVEL BY (0mm, 0mm, -9mm) AT 20mm/s\nPRESS Z 10N DO\n"
      "MOVEL BY (1mm, 0mm, -1mm) AT 5mm/s\nENDPRESS\n",
      table(10e-3));
  CHECK(along.failure() == "E571");
  Felt jogged(
      "MOVEL BY (0mm, 0mm, -9mm) AT 20mm/s\nPRESS Z 10N DO\n"
      "JOG WORLD (1mm/s, 0mm/s, -1mm/s) FOR 1s\nENDPRESS\n",
      table(10e-3));
  CHECK(jogged.failure() == "E571");
  Felt turned(
      "MOVEL BY (0mm, 0mm, -9mm) AT 20mm/s\nPRESS Z 10N DO\n"
      "JOG JOINT (0deg/s, 2deg/s, 0deg/s, 0deg/s, 0deg/s, 0deg/s) FOR 1s\nENDPRESS\n",
      table(10e-3));
  CHECK(turned.failure() == "E571");
  Felt beside(
      "MOVEL BY (0mm, 0mm, -9mm) AT 20mm/s\nPRESS Z 10N DO\n"
      "SPIRAL FROM 4mm TURNS 2 AT 10mm/s\nJOG WORLD (1mm/s, 0mm/s, 0mm/s) FOR 1s\nENDPRESS\n",
      table(10e-3));
  CHECK(beside.failure() == "");
}

TEST_CASE("a PRESS that the robot would stop for is refused, and ZERO force in one") {
  const auto failure = [](const std::string& force, const std::string& body) {
    motion::RobotModel robot = arm();
    robot.force.limit = 50;
    test::SteppedRun run(
        "MOVEL BY (0mm, 0mm, -9mm) AT 20mm/s\nPRESS Z " + force + " DO\n" + body + "\nENDPRESS\n",
        std::make_unique<test::FeltWorld>(test::simulated(robot), robot.kinematics, table(10e-3),
                                          0),
        1, robot);
    run.run();
    return run.task.failure() ? run.task.failure()->message : "";
  };
  CHECK(failure("50N", "WAIT 0.1s") == "PRESS with 50 N is not possible: the robot stops at 50 N");
  CHECK(failure("20N", "WAIT 0.1s") == "");
  CHECK(failure("20N", "ZERO force") == "ZERO force is not possible in a PRESS");
}

TEST_CASE("a PRESS towards the end of the arm ends before its axes have to be too fast") {
  // The wrist is out of reach 26 mm farther on.
  Felt stretched(
      "LAW LOOKAHEAD\nTOOL jaws = POSE(0mm, 0mm, 120mm)\nWITH jaws DO\n"
      "MOVE POSE(500mm, 0mm, 400mm, 180deg, 0deg, 180deg) FINE\n"
      "PRESS X -10N LIMIT 20mm/s DO\nWAIT 1s\nENDPRESS\nENDWITH\n",
      always({0, 0, 0}, {0, 0, 0}));
  CHECK(stretched.failure() == "E570");
  CHECK(stretched.run.task.failure()->message.ends_with("up to where an axis or the arm ends"));
  const double v_max = arm().axes[1].v_max;
  double fastest = 0;
  for (const Snapshot& row : stretched.run.rows)
    if (row.sample.state == rob::motion::MotionState::Pressing)
      fastest = std::max(fastest, row.sample.reference.qd.cwiseAbs().maxCoeff());
  CHECK(fastest > 0.05 * v_max);
  CHECK(fastest < 0.4 * v_max);
}

TEST_CASE("targets from HERE and from TARGET go across the axis of a PRESS") {
  // The table is 1 mm below where the PRESS begins, and 10 N press it in by 0.2 mm.
  const std::string before =
      "MOVEL BY (0mm, 0mm, -9mm) AT 20mm/s FINE\nVAR z0 = HERE.z\nPRESS Z 10N DO\n";
  const std::string after =
      "\nPRINT ROUND((TARGET.z - z0) / 1um), \" \", ROUND((z0 - HERE.z) / 10um)\nENDPRESS\n";
  for (const char* law : {"LAW PAUL\n", "LAW LOOKAHEAD\n"}) {
    for (const char* motion :
         {"MOVEL HERE + (5mm, 0mm, 0mm) AT 5mm/s FINE", "MOVE HERE + (5mm, 0mm, 0mm) AT 5mm/s FINE",
          "MOVEL TARGET + (5mm, 0mm, 0mm) AT 5mm/s FINE"}) {
      CAPTURE(law);
      CAPTURE(motion);
      Felt felt(law + before + motion + after, table(10e-3));
      CHECK(felt.failure() == "");
      CHECK(felt.result.output.at(0) == "0 120");
      const auto& end = felt.run.rows.back().sample.reference.q;
      const Eigen::Vector3d way = arm().kinematics->forward(end).position - start();
      CHECK(way.x() == test::relative(5e-3, 1e-3));
      CHECK(std::abs(way.z() + 10.2e-3) < 0.03e-3);
      // The corner was reached exactly, as far as the path goes that the force does not change.
      CHECK(test::line(felt.result, 5).miss_measured.value() < 0.05);
    }
  }
  Felt below(before + "MOVEL HERE + (5mm, 0mm, 1mm) AT 5mm/s FINE" + after, table(10e-3));
  CHECK(below.failure() == "E571");
}

TEST_CASE("an error in a PRESS ends it, and what rescues starts from where the axes stand") {
  Felt felt(
      "MOVEL BY (0mm, 0mm, -9mm) AT 20mm/s\nTRY\nPRESS Z 10N DO\n"
      "MOVE JOINT 6 TO 1rad AT 1rad/s UNTIL CLOCK > 3s\nRAISE \"jammed\"\nENDPRESS\n"
      "RESCUE why\nPRINT why\nMOVEL BY (0mm, 0mm, 20mm) AT 50mm/s\nENDTRY\n",
      table(10e-3));
  const RunResult& result = felt.go();
  CHECK(result.output.at(0) == "jammed");
  const auto& rows = felt.run.rows;
  const double end = arm().kinematics->forward(rows.back().sample.reference.q).position.z();
  CHECK(start().z() - end == test::relative(-10e-3 + 0.2e-3, 0.05));
  CHECK(roughest(rows, arm().reference_period) < 750 * 3.15 / 180);
}

TEST_CASE("what raises while a PRESS still looks for its force ends it, too") {
  Felt felt(
      "TRY\nWHEN CLOCK > 1s : RAISE \"late\"\nPRESS Z 10N DO\nENDPRESS\nRESCUE why\n"
      "PRINT why\nENDTRY\nMOVEL BY (0mm, 0mm, 20mm) AT 50mm/s\n",
      always({0, 0, 0}, {0, 0, 0}));
  CHECK(felt.failure() == "");
  CHECK(felt.result.output.at(0) == "late");
  const auto& rows = felt.run.rows;
  const double end = arm().kinematics->forward(rows.back().sample.reference.q).position.z();
  CHECK(end > start().z() + 14e-3);  // at most 5 mm/s for 1 s down
  CHECK(end < start().z() + 20e-3);
}

TEST_CASE("a handler that moves, or brakes, in a PRESS leaves the force where it was") {
  for (const char* law : {"paul", "lookahead"}) {
    for (const char* action : {"MOVEL BY (0mm, 0mm, 10mm) AT 20mm/s", "BRAKE"}) {
      CAPTURE(law);
      CAPTURE(action);
      const double x = start().x() + 10e-3;
      Felt felt(std::string("LAW ") + law +
                    "\nMOVEL BY (0mm, 0mm, -8mm) AT 20mm/s\nPRESS Z 10N DO\n"
                    "WHEN HERE.x > " +
                    std::to_string(x * 1000) + "mm DO\n" + action +
                    "\nENDWHEN\nMOVEL BY (30mm, 0mm, 0mm) AT 10mm/s\nENDPRESS\nPRINT \"end\"\n",
                table(10e-3));
      CHECK(felt.failure() == "");
      CHECK(felt.result.output.at(0) == "end");
      CHECK(roughest(felt.run.rows, arm().reference_period) < 750 * 3.15 / 180);
    }
  }
}

TEST_CASE("a PRESS inside another, and one that the sensor cannot resolve, are refused") {
  Felt nested(
      "PROC inner()\nPRESS Z 5N DO\nENDPRESS\nENDPROC\n"
      "MOVEL BY (0mm, 0mm, -9mm) AT 20mm/s\nPRESS Z 10N DO\ninner()\nENDPRESS\n",
      table(10e-3));
  CHECK(nested.failure() == "E166");
  motion::RobotModel noisy = arm();
  noisy.force.noise = 0.1;
  test::SteppedRun small(
      "PRESS Z 0.3N DO\nENDPRESS\n",
      std::make_unique<test::FeltWorld>(test::simulated(noisy), noisy.kinematics, table(10e-3)), 1,
      noisy);
  small.run();
  REQUIRE(small.task.failure().has_value());
  CHECK(small.task.failure()->code == "E550");
}

TEST_CASE("AT LIVE is the speed of the motion in every cycle, under both laws") {
  for (const char* law : {"paul", "lookahead"}) {
    CAPTURE(law);
    // 10 mm/s until 9 s; 20 mm/s, which is all that x has, from 10 s on. From rest S1 takes 2·t_acc
    // of the path's time, 5.5 s of the run's.
    test::SteppedRun run(std::string("LAW ") + law +
                         "\nMOVE(200,0,0) AT LIVE 10mm/s * (1 + MIN(1, MAX(0, CLOCK/1s - 9)))\n");
    const RunResult result = run.run();
    for (const Snapshot& row : run.rows) {
      const double t = row.sample.reference.time;
      const double v = row.sample.reference.qd[0];
      if (t > 6 && t < 9) CHECK(v == test::relative(10e-3, 1e-3));
      if (t > 10.5 && t < 12) CHECK(v == test::relative(20e-3, 1e-3));
      CHECK(v < 20e-3 + 1e-9);
      CHECK(std::abs(row.sample.reference.qdd[0]) < 0.1 + 1e-9);
    }
    CHECK(run.rows.back().sample.reference.q[0] == test::relative(0.2));
  }
}

TEST_CASE("AT LIVE of nothing stands until it is more; one without a value stops the robot") {
  for (const char* law : {"paul", "lookahead"}) {
    CAPTURE(law);
    test::SteppedRun run(std::string("LAW ") + law +
                         "\nMOVE(100,0,0) AT LIVE 20mm/s * MAX(0, ROUND(CLOCK/1s - 3))\n");
    const RunResult result = run.run();
    for (const Snapshot& row : run.rows)
      if (row.sample.reference.time < 3.4) CHECK(row.sample.reference.q[0] < 1e-9);
    CHECK(run.rows.back().sample.reference.q[0] == test::relative(0.1));

    test::SteppedRun none(
        std::string("LAW ") + law +
        "\nMOVE(10,0,0) FINE\nMOVE(100,0,0) AT LIVE 20mm/s / MAX(0, 2 - CLOCK/1s)\n");
    const RunResult failed = none.run();
    REQUIRE(failed.error.has_value());
    CHECK(failed.error->code == "E513");
    CHECK(failed.error->place.line == 3);
    CHECK(none.rows.back().sample.reference.qd.isZero(1e-9));
    CHECK(none.rows.back().sample.reference.q[0] < 0.1);
  }
}

}  // namespace rob::runtime
