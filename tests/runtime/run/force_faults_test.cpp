#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "tests/support/felt_world.h"
#include "tests/support/stepped_run.h"

// Faults 21, 22 and 53 of docs/faults.md.
namespace rob::runtime {
namespace {

motion::RobotModel limited() {
  motion::RobotModel robot = motion::embedded_robot("lwa4p");
  robot.force.limit = 50;
  robot.force.noise = 0.2;
  return robot;
}

double height(const motion::RobotModel& robot, const motion::JointVector& q) {
  return robot.kinematics->forward(q).position.z();
}

/// A table of 100 N/mm, 10 mm below the start, and a force that is never the same twice.
test::FeltWorld::Acts table(const motion::RobotModel& robot) {
  return [top = height(robot, robot.start) - 0.01, k = 0](double, const motion::Pose& p) mutable {
    motion::Wrench wrench;
    wrench.force.z() = std::max(0.0, top - p.position.z()) * 100e3 + (++k % 2 == 0 ? 0.01 : 0);
    return wrench;
  };
}

struct Run {
  motion::RobotModel robot = limited();
  test::FeltWorld* world = nullptr;
  std::unique_ptr<test::SteppedRun> run;
  RunResult result;

  explicit Run(const std::string& program) {
    auto made =
        std::make_unique<test::FeltWorld>(test::simulated(robot), robot.kinematics, table(robot));
    world = made.get();
    run = std::make_unique<test::SteppedRun>(program, std::move(made), 1, robot);
  }
  void go() { result = run->run(60); }
};

}  // namespace

TEST_CASE("fault 22: over 50 N the robot stops within a period, backs off, and says the axis") {
  for (const char* law : {"paul", "lookahead"}) {
    CAPTURE(law);
    Run run(std::string("LAW ") + law + "\nMOVEL BY (0mm, 0mm, -25mm) AT 5mm/s\n");
    run.go();
    REQUIRE(run.result.error.has_value());
    CHECK(run.result.error->code == "E511");
    CHECK(run.result.error->message.find("along z") != std::string::npos);
    const auto& rows = run.run->rows;
    const auto first =
        std::ranges::find_if(rows, [](const Snapshot& row) { return row.wrench.force.z() > 50; });
    REQUIRE(first != rows.end());
    // Looked at in the second cycle beyond; the reference that is made then is slower.
    const auto told = std::ranges::find_if(rows, [](const Snapshot& row) {
      return row.sample.state == motion::MotionState::Stopping;
    });
    REQUIRE(told != rows.end());
    CHECK(told - first <= 3);
    const double peak = std::ranges::max(rows, {}, [](const Snapshot& row) {
                          return row.wrench.force.z();
                        }).wrench.force.z();
    CHECK(peak < 100);
    CHECK(rows.back().wrench.force.z() < 10);
    CHECK(rows.back().sample.reference.qd.isZero(1e-9));
  }
}

TEST_CASE("fault 22: a program that brakes by itself in time goes on by itself") {
  Run run(
      "TRY\nWHEN ABS(force.z) > 50N : RAISE \"over 50 N\"\n"
      "MOVEL BY (0mm, 0mm, -25mm) AT 5mm/s FINE\nRESCUE why\nPRINT why\nENDTRY\n"
      "MOVEL BY (0mm, 0mm, 10mm) AT 20mm/s\n");
  run.go();
  REQUIRE_FALSE(run.result.error.has_value());
  CHECK_FALSE(run.run->task.failure().has_value());
  CHECK(run.result.output.at(0) == "over 50 N");
  CHECK(run.run->rows.back().wrench.force.z() < 1);
}

TEST_CASE("fault 22: a PRESS that is run into is backed off from, too") {
  Run run("MOVEL BY (0mm, 0mm, -9.9mm) AT 20mm/s\nPRESS Z 10N DO\nWAIT 20s\nENDPRESS\n");
  // something lifts the table by 1 mm at once
  bool lifted = false;
  run.run->each_cycle = [&](double time) { lifted = time > 5; };
  auto made = std::make_unique<test::FeltWorld>(
      test::simulated(run.robot), run.robot.kinematics,
      [&, below = table(run.robot)](double time, const motion::Pose& p) mutable {
        motion::Pose seen = p;
        if (lifted) seen.position.z() -= 1e-3;
        return below(time, seen);
      });
  run.run = std::make_unique<test::SteppedRun>(
      "MOVEL BY (0mm, 0mm, -9.9mm) AT 20mm/s\nPRESS Z 10N DO\nWAIT 20s\nENDPRESS\n",
      std::move(made), 1, run.robot);
  run.run->each_cycle = [&](double time) { lifted = time > 5; };
  run.go();
  REQUIRE(run.result.error.has_value());
  CHECK(run.result.error->code == "E511");
  CHECK(run.run->rows.back().wrench.force.z() < 10);
}

TEST_CASE("fault 21: a force sensor that falls silent stops a program that counts on it") {
  Run counts("ZERO force\nMOVEL BY (0mm, 0mm, -8mm) AT 1mm/s UNTIL force.z > 5N\n");
  counts.run->each_cycle = [&](double time) { counts.world->silent = time > 2; };
  counts.go();
  REQUIRE(counts.result.error.has_value());
  CHECK(counts.result.error->code == "E512");
  CHECK(counts.run->rows.back().sample.reference.time < 2 + 0.1 + 1);

  Run careless("MOVEL BY (0mm, 0mm, -8mm) AT 1mm/s\n");
  careless.run->each_cycle = [&](double time) { careless.world->silent = time > 2; };
  careless.go();
  CHECK_FALSE(careless.result.error.has_value());
}

TEST_CASE(
    "fault 53: a hold while a cap is turned, or a hole searched for, leaves force and place") {
  struct Skill {
    const char* body;
    double force;  // N
  };
  const Skill capping{"MOVE JOINT 6 TO 2rad AT 0.2rad/s", 10};
  const Skill search{"SPIRAL FROM 4mm TURNS 5 AT 10mm/s", 5};
  constexpr double kHeld = 10;     // s: the table has been met after 3 s
  constexpr double kStands = 0.5;  // s: 0.2 rad/s at a_max and j_max take 0.1 s
  for (const char* law : {"paul", "lookahead"}) {
    for (const Skill& skill : {capping, search}) {
      CAPTURE(law);
      CAPTURE(skill.body);
      Run run(std::string("LAW ") + law + "\nPRESS Z " + std::to_string(skill.force) + "N DO\n" +
              skill.body + "\nENDPRESS\n");
      bool moved = false;
      double stood_at = 0;
      run.run->each_cycle = [&](double time) {
        const Snapshot& now = run.run->rows.back();
        const bool moves = now.sample.reference.qd.norm() > 0.01;
        moved = moved || (time < kHeld && time > kHeld - 0.1 && moves);
        if (time >= kHeld) run.run->controller.request_hold();
        if (now.sample.reference.qd.norm() > 0) stood_at = time;
      };
      run.go();
      CHECK(moved);
      CHECK(stood_at > kHeld);
      CHECK(stood_at < kHeld + kStands);
      const Snapshot& last = run.run->rows.back();
      CHECK(last.sample.reference.qd.isZero(0));
      CHECK(std::abs(last.wrench.force.z() - skill.force) < 1.5);
      CHECK(run.run->task.failure() == std::nullopt);
    }
  }
}

}  // namespace rob::runtime
