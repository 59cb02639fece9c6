#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "tests/motion/trajectory_run.h"
#include "tests/support/no_allocation.h"

using namespace rob::motion;
using rob::test::asked_of;
using rob::test::AskedOfAxis;
using rob::test::move_axes;
using rob::test::NoAllocation;
using rob::test::same_bits;
using rob::test::somewhere;
using rob::test::TrajectoryRun;

namespace {

constexpr std::array kBothLaws = {Law::Paul, Law::LookAhead};
constexpr double kRounding = 1e-6;  // of shares of what an axis can do

void check_within_limits(const RobotModel& robot, const std::vector<JointReference>& references) {
  for (int i = 0; i < robot.axis_count(); ++i) {
    CAPTURE(robot.axes[static_cast<std::size_t>(i)].name);
    const AskedOfAxis asked = asked_of(robot, i, references);
    CHECK(asked.speed <= 1 + kRounding);
    CHECK(asked.acceleration <= 1 + kRounding);
  }
}

/// Axis 0 alone, to there.
MotionRequest move_first(double target) {
  MotionRequest request;
  request.given = 1;
  request.target[0] = target;
  return request;
}

/// s at which axis 0 passes there, between two references.
double passing(const std::vector<JointReference>& references, double place) {
  const auto behind = std::ranges::find_if(
      references, [&](const JointReference& reference) { return reference.q[0] > place; });
  REQUIRE(behind != references.begin());
  REQUIRE(behind != references.end());
  const auto before = behind - 1;
  const double share = (place - before->q[0]) / (behind->q[0] - before->q[0]);
  return before->time + share * (behind->time - before->time);
}

}  // namespace

TEST_CASE("a trajectory ends at its last target and keeps within the limits of every axis") {
  for (const char* const name : {"gantry", "irb120", "ums7"}) {
    const RobotModel robot = load_robot(name);
    for (const Law law : kBothLaws) {
      CAPTURE(name);
      CAPTURE(law_name(law));
      Trajectory trajectory(robot, law);
      std::mt19937 random(7);
      JointVector target;
      for (int move = 0; move < 12; ++move) {
        target = somewhere(robot, random, 0.3);
        REQUIRE_FALSE(trajectory.add(move_axes(target)));
      }
      trajectory.close();
      const TrajectoryRun run(trajectory);
      CHECK(run.result == Result::Finished);
      CHECK(same_bits(run.references.front().q, robot.start));
      CHECK((run.last().q - target).cwiseAbs().maxCoeff() < 1e-12);
      CHECK(run.last().qd.isZero());
      CHECK(run.last().qdd.isZero());
      check_within_limits(robot, run.references);
    }
  }
}

TEST_CASE("references come every period, from the time 0 on, and stand after the end") {
  const RobotModel robot = load_robot("gantry");
  Trajectory trajectory(robot, Law::Paul);
  REQUIRE_FALSE(trajectory.add(move_first(0.01)));
  trajectory.close();
  const TrajectoryRun run(trajectory);
  for (std::size_t k = 0; k < run.references.size(); ++k)
    CHECK(run.references[k].time == doctest::Approx(0.01 * static_cast<double>(k)));
  JointReference reference;
  CHECK(trajectory.update(reference) == Result::Finished);
  CHECK(same_bits(reference.q, run.last().q));
  CHECK(reference.time == doctest::Approx(run.last().time + 0.01));
}

TEST_CASE("under Paul's law a motion from rest to rest takes its own time and a transition") {
  // T1 = 100 mm / 20 mm/s, and 2·t_acc = 2.75 s.
  Trajectory trajectory(load_robot("gantry"), Law::Paul);
  REQUIRE_FALSE(trajectory.add(move_first(0.1)));
  trajectory.close();
  const TrajectoryRun run(trajectory);
  CHECK(run.last().time == doctest::Approx(0.1 / 0.02 + 2 * 1.375).epsilon(1e-9));
  CHECK(run.references[run.references.size() - 2].q[0] < 0.1);
}

TEST_CASE("under the look-ahead law a motion from rest to rest takes the time of its profile") {
  const auto time = [](const RobotModel& robot, double way) {
    Trajectory trajectory(robot, Law::LookAhead);
    REQUIRE_FALSE(trajectory.add(move_first(way)));
    trajectory.close();
    return TrajectoryRun(trajectory).last().time;
  };
  SUBCASE("a trapezoid, or a triangle, where no jerk is bounded") {
    const RobotModel robot = load_robot(std::string(ROB_SOURCE_DIR) + "/tests/bench/xy.toml");
    // 1 m/s, 1 m/s², references every ms
    CHECK(std::abs(time(robot, 1) - (1 / 1. + 1 / 1.)) <= 0.001 + 1e-9);
    CHECK(std::abs(time(robot, 0.3) - 2 * std::sqrt(0.3 / 1)) <= 0.001 + 1e-9);
  }
  SUBCASE("a third-order profile, where it is") {
    // d/v + v/a + a/j of 100 mm, 20 mm/s, 100 mm/s², 1000 mm/s³; the mean takes whole periods.
    const double expected = 0.1 / 0.02 + 0.02 / 0.1 + 0.1 / 1;
    CHECK(std::abs(time(load_robot("gantry"), 0.1) - expected) <= 0.03);
  }
}

TEST_CASE("half the speed takes twice the time of cruising") {
  const RobotModel robot = load_robot("gantry");
  for (const Law law : kBothLaws) {
    CAPTURE(law_name(law));
    for (const double share : {1.0, 0.5, 0.25}) {
      Trajectory trajectory(robot, law);
      trajectory.override_speed(share);
      trajectory.override_speed(0);  // is no share
      trajectory.override_speed(std::numeric_limits<double>::quiet_NaN());
      REQUIRE_FALSE(trajectory.add(move_first(0.1)));
      trajectory.close();
      const TrajectoryRun run(trajectory);
      const double cruising = passing(run.references, 0.07) - passing(run.references, 0.03);
      CHECK(cruising == doctest::Approx(0.04 / 0.02 / share));
      check_within_limits(robot, run.references);
      CHECK(run.last().q[0] == doctest::Approx(0.1).epsilon(1e-12));
    }
  }
}

TEST_CASE("more than the programmed speed is for the look-ahead law, up to twice of it") {
  const RobotModel robot = load_robot("gantry");
  for (const Law law : {Law::Paul, Law::LookAhead}) {
    const double speed = law == Law::Paul ? 0.005 : 0.01;  // m/s
    CAPTURE(law_name(law));
    Trajectory trajectory(robot, law);
    trajectory.override_speed(3);
    MotionRequest slow = move_first(0.1);
    slow.pace = MotionRequest::Pace::ToolSpeed;
    slow.pace_value = 0.005;
    REQUIRE_FALSE(trajectory.add(slow));
    trajectory.close();
    const TrajectoryRun run(trajectory);
    const double cruising = passing(run.references, 0.07) - passing(run.references, 0.03);
    CHECK(cruising == doctest::Approx(0.04 / speed));
  }
}

TEST_CASE("axes that are held stand on their path until they may go on") {
  const RobotModel robot = load_robot("gantry");
  for (const Law law : kBothLaws) {
    CAPTURE(law_name(law));
    Trajectory trajectory(robot, law);
    REQUIRE_FALSE(trajectory.add(move_first(0.1)));
    trajectory.close();
    const TrajectoryRun run(trajectory, [&](std::size_t k) {
      if (k == 300) trajectory.hold(true);
      if (k == 500) trajectory.hold(false);
    });
    CHECK(run.result == Result::Finished);
    CHECK(run.last().q[0] == doctest::Approx(0.1).epsilon(1e-12));
    // A hold takes 0.4 s at most on this robot; it slowed down and sped up in the other 1.6 s.
    const double held = run.references[340].q[0];
    CHECK(held > run.references[300].q[0]);
    CHECK(held < 0.1);
    for (std::size_t k = 341; k < 500; ++k) CHECK(run.references[k].q[0] == held);
    check_within_limits(robot, run.references);
  }
}

TEST_CASE("a motion that is refused leaves nothing") {
  const RobotModel robot = load_robot("irb120");
  for (const Law law : kBothLaws) {
    CAPTURE(law_name(law));
    Trajectory disturbed(robot, law);
    Trajectory plain(robot, law);
    std::mt19937 random(3);
    for (int move = 0; move < 6; ++move) {
      const MotionRequest request = move_axes(somewhere(robot, random, 0.3));
      MotionRequest far = request;
      far.target[2] = robot.axes[2].max + 0.1;
      MotionRequest slow = request;
      slow.pace = MotionRequest::Pace::Share;
      slow.pace_value = -1;
      MotionRequest nowhere = request;
      nowhere.target[1] = std::numeric_limits<double>::quiet_NaN();
      const auto refusal = disturbed.add(far);
      REQUIRE(refusal);
      CHECK(refusal->kind == Refusal::Kind::AboveMaximum);
      CHECK(refusal->axis == 2);
      CHECK(refusal->limit == robot.axes[2].max);
      CHECK_FALSE(disturbed.add(request));
      CHECK(disturbed.add(slow));
      CHECK(disturbed.add(nowhere));
      CHECK_FALSE(plain.add(request));
    }
    disturbed.close();
    plain.close();
    const TrajectoryRun one(disturbed);
    const TrajectoryRun other(plain);
    CHECK(one.result == Result::Finished);
    REQUIRE(one.references.size() == other.references.size());
    CHECK(std::ranges::equal(one.references, other.references,
                             [](const auto& a, const auto& b) { return same_bits(a, b); }));
  }
}

TEST_CASE("update takes no memory") {
  const RobotModel robot = load_robot("irb120");
  for (const Law law : kBothLaws) {
    CAPTURE(law_name(law));
    Trajectory trajectory(robot, law);
    std::mt19937 random(5);
    for (int move = 0; move < 20; ++move) {
      MotionRequest request = move_axes(somewhere(robot, random, 0.3));
      request.zone = MotionRequest::Zone::Length;
      request.zone_value = 0.01;
      REQUIRE_FALSE(trajectory.add(request));
    }
    trajectory.close();
    JointReference reference;
    int taken = 0;
    Result result = Result::Working;
    for (int k = 0; result == Result::Working; ++k) {
      trajectory.plan();
      const NoAllocation guard;
      trajectory.hold(k > 100 && k < 200);
      trajectory.override_speed(k < 400 ? 1 : 0.5);
      result = trajectory.update(reference);
      taken += guard.count();
    }
    CHECK(result == Result::Finished);
    CHECK(taken == 0);
  }
}

TEST_CASE("any number of motions may be ahead, and a stop makes each target exact") {
  RobotModel robot = load_robot("gantry");
  robot.look_ahead = 4;
  for (const Law law : kBothLaws) {
    CAPTURE(law_name(law));
    Trajectory trajectory(robot, law);
    std::mt19937 random(11);
    std::vector<JointVector> targets;
    for (int move = 0; move < 60; ++move) {
      targets.push_back(somewhere(robot, random, 0.02));
      REQUIRE_FALSE(trajectory.add(move_axes(targets.back())));
      trajectory.stop();
      trajectory.stop();  // it stands there already
    }
    trajectory.close();
    const TrajectoryRun run(trajectory);
    std::size_t reached = 0;
    for (const JointReference& reference : run.references) {
      if (reached == targets.size()) break;
      if ((reference.q - targets[reached]).cwiseAbs().maxCoeff() < 1e-9) ++reached;
    }
    CHECK(reached == targets.size());
    check_within_limits(robot, run.references);
  }
}

TEST_CASE("until it is closed a trajectory stands where the last motion leads, and goes on") {
  const RobotModel robot = load_robot("gantry");
  for (const Law law : kBothLaws) {
    CAPTURE(law_name(law));
    Trajectory trajectory(robot, law);
    TrajectoryRun waiting(trajectory, {}, 100);
    CHECK(waiting.result == Result::Working);
    CHECK(same_bits(waiting.last().q, robot.start));
    REQUIRE_FALSE(trajectory.add(move_first(0.05)));
    const TrajectoryRun first(trajectory, {}, 2000);
    CHECK(first.result == Result::Working);
    CHECK(first.last().q[0] == doctest::Approx(0.05).epsilon(1e-12));
    CHECK(first.last().qd.isZero());
    MotionRequest further = move_first(0.02);
    further.relative = true;
    REQUIRE_FALSE(trajectory.add(further));
    trajectory.close();
    trajectory.close();  // is closed already
    const TrajectoryRun second(trajectory);
    CHECK(second.result == Result::Finished);
    CHECK(second.last().q[0] == doctest::Approx(0.07).epsilon(1e-12));
    std::vector<JointReference> all = waiting.references;
    all.insert(all.end(), first.references.begin(), first.references.end());
    all.insert(all.end(), second.references.begin(), second.references.end());
    check_within_limits(robot, all);
  }
}

TEST_CASE("a trajectory without a motion is finished at once") {
  const RobotModel robot = load_robot("gantry");
  for (const Law law : kBothLaws) {
    Trajectory trajectory(robot, law);
    trajectory.close();
    const TrajectoryRun run(trajectory);
    CHECK(run.result == Result::Finished);
    CHECK(run.references.size() == 1);
    CHECK(same_bits(run.last().q, robot.start));
  }
}

TEST_CASE("a trajectory begins where the axes stand, and may be moved") {
  const RobotModel robot = load_robot("gantry");
  JointVector start = robot.start;
  start[0] = 0.3;
  start[1] = 0.1;
  for (const Law law : kBothLaws) {
    Trajectory made(robot, law, start);
    MotionRequest back = move_first(-0.05);
    back.relative = true;
    REQUIRE_FALSE(made.add(back));
    Trajectory trajectory = std::move(made);
    trajectory.close();
    const TrajectoryRun run(trajectory);
    CHECK(same_bits(run.references.front().q, start));
    CHECK(run.last().q[0] == doctest::Approx(0.25).epsilon(1e-12));
    CHECK(run.last().q[1] == 0.1);
  }
}

TEST_CASE("a reference that would be no number is not handed out: the trajectory has failed") {
  // No robot file is like that: within t_acc the axis would speed up by 1.5·1.7e308/0.1.
  RobotModel robot = load_robot("gantry");
  constexpr double kGreat = 1.7e308;
  Axis& axis = robot.axes[0];
  axis.max = axis.v_max = axis.a_max = axis.j_max = kGreat;
  robot.t_acc = 0.1;
  Trajectory trajectory(robot, Law::Paul);
  REQUIRE_FALSE(trajectory.add(move_first(kGreat)));
  REQUIRE_FALSE(trajectory.add(move_first(0)));
  trajectory.close();
  const TrajectoryRun run(trajectory);
  CHECK(run.result == Result::Failed);
  for (const JointReference& reference : run.references) CHECK(reference.q.allFinite());
  JointReference next;
  trajectory.hold(true);
  trajectory.hold(false);
  CHECK(trajectory.update(next) == Result::Failed);
  CHECK(same_bits(next.q, run.last().q));
  CHECK(next.qd.isZero());
}

TEST_CASE("what a trajectory cannot be made of is refused, with the way out") {
  CHECK_THROWS_WITH_AS(Trajectory(load_robot("so101"), Law::Paul),
                       "the robot 'so101' has no t_acc, which Paul's law needs; use"
                       " Law::LookAhead, or write t_acc into its robot file",
                       std::invalid_argument);
  const RobotModel robot = load_robot("gantry");
  CHECK_THROWS_WITH_AS(Trajectory(robot, Law::Paul, JointVector::Zero(2)),
                       "the robot 'gantry' has 3 axes, but start has 2 values; give one for each"
                       " axis",
                       std::invalid_argument);
  JointVector outside = robot.start;
  outside[1] = 0.5;
  CHECK_THROWS_WITH_AS(Trajectory(robot, Law::LookAhead, outside),
                       "the axis 'y' cannot start at 0.500000, in m or rad; give a place between"
                       " its min and its max",
                       std::invalid_argument);
  RobotModel unknown = robot;
  unknown.kinematics = nullptr;
  CHECK_THROWS_AS(Trajectory(unknown, Law::Paul), std::invalid_argument);
  Trajectory trajectory(robot, Law::Paul);
  trajectory.close();
  CHECK_THROWS_AS(trajectory.add(move_first(0.1)), std::logic_error);
}
