#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <string>

#include "tests/motion/trajectory_run.h"
#include "tests/support/stepped_run.h"

using namespace rob;
using motion::Law;
using motion::MotionRequest;
using motion::Trajectory;

namespace {

/// As many references as the trajectory has; the run may take longer to say that it is over.
void check_same_references(test::SteppedRun& run, Trajectory& trajectory) {
  run.run();
  trajectory.close();
  const test::TrajectoryRun own(trajectory);
  CHECK(own.result == motion::Result::Finished);
  REQUIRE(own.references.size() > 500);
  REQUIRE(run.rows.size() >= own.references.size());
  std::size_t different = 0;
  for (std::size_t k = 0; k < own.references.size(); ++k)
    different += test::same_bits(run.rows[k].sample.reference, own.references[k]) ? 0 : 1;
  CHECK(different == 0);
  CHECK(test::same_bits(run.rows.back().sample.reference.q, own.last().q));
}

MotionRequest to(std::initializer_list<double> target) {
  motion::JointVector q(static_cast<Eigen::Index>(target.size()));
  std::ranges::copy(target, q.begin());
  return test::move_axes(q);
}

}  // namespace

TEST_CASE("a program of the same motions on the gantry has the same references, bit for bit") {
  for (const Law law : {Law::Paul, Law::LookAhead}) {
    CAPTURE(motion::law_name(law));
    test::SteppedRun run(std::string("LAW ") + (law == Law::Paul ? "PAUL" : "LOOKAHEAD") +
                         "\nMOVE(0.04m, 0.04m, 0rad)\nMOVE(0.14m, 0.04m, 1rad)\n"
                         "MOVE(0.09m, 0.126m, 0rad) ZONE 0.002m\nSTOP\nMOVE(0.04m, 0.04m, 0rad) AT "
                         "0.01m/s\nMOVE(0.05m, 0.06m, 0rad)\n");
    Trajectory trajectory(run.robot, law);
    CHECK_FALSE(trajectory.add(to({0.04, 0.04, 0})));
    CHECK_FALSE(trajectory.add(to({0.14, 0.04, 1})));
    MotionRequest zoned = to({0.09, 0.126, 0});
    zoned.zone = MotionRequest::Zone::Length;
    zoned.zone_value = 0.002;
    CHECK_FALSE(trajectory.add(zoned));
    trajectory.stop();
    MotionRequest slow = to({0.04, 0.04, 0});
    slow.pace = MotionRequest::Pace::ToolSpeed;
    slow.pace_value = 0.01;
    CHECK_FALSE(trajectory.add(slow));
    CHECK_FALSE(trajectory.add(to({0.05, 0.06, 0})));
    check_same_references(run, trajectory);
  }
}

TEST_CASE("so it has on an arm, where more motions are ahead than the buffer holds") {
  motion::RobotModel arm = motion::load_robot("irb120");
  arm.look_ahead = 8;
  for (const Law law : {Law::Paul, Law::LookAhead}) {
    CAPTURE(motion::law_name(law));
    Trajectory trajectory(arm, law);
    std::string program = std::string("LAW ") + (law == Law::Paul ? "PAUL" : "LOOKAHEAD") + "\n";
    for (int move = 0; move < 40; ++move) {
      const double turn = move % 2 == 0 ? 0.25 : -0.125;
      const double lift = move % 3 == 0 ? 0.5 : 0.25;
      program += "MOVE JOINTS(" + std::to_string(turn) + "rad, " + std::to_string(lift) +
                 "rad, 0rad, 0rad, 1.5rad, " + std::to_string(turn) + "rad)\n";
      CHECK_FALSE(trajectory.add(to({turn, lift, 0, 0, 1.5, turn})));
    }
    test::SteppedRun run(program, nullptr, 1, arm);
    check_same_references(run, trajectory);
  }
}
