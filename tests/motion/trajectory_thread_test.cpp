#include <doctest/doctest.h>

#include <atomic>
#include <random>
#include <thread>
#include <vector>

#include "tests/motion/trajectory_run.h"

using namespace rob::motion;
using rob::test::asked_of;
using rob::test::move_axes;
using rob::test::somewhere;

TEST_CASE("one thread adds, one plans, one asks for references: none is left out, none leaps") {
  RobotModel robot = load_robot("irb120");
  robot.look_ahead = 4;
  for (const Law law : {Law::Paul, Law::LookAhead}) {
    CAPTURE(law_name(law));
    Trajectory trajectory(robot, law);
    std::mt19937 random(17);
    std::vector<JointVector> targets;
    for (int move = 0; move < 40; ++move) targets.push_back(somewhere(robot, random, 0.2));
    std::atomic<bool> done{false};
    std::atomic<int> refused{0};

    std::thread adding([&] {
      for (const JointVector& target : targets) {
        refused += trajectory.add(move_axes(target)) ? 1 : 0;
        trajectory.stop();
        std::this_thread::yield();
      }
      trajectory.close();
    });
    std::thread planning([&] {
      for (; !done; std::this_thread::yield()) trajectory.plan();
    });

    std::vector<JointReference> references;
    std::size_t reached = 0;
    JointReference reference;
    for (Result result = Result::Working; result == Result::Working;) {
      result = trajectory.update(reference);
      references.push_back(reference);
      if (reached < targets.size() && (reference.q - targets[reached]).cwiseAbs().maxCoeff() < 1e-9)
        ++reached;
      if (result == Result::Failed) break;
    }
    done = true;
    adding.join();
    planning.join();
    CHECK(refused == 0);
    CHECK(reached == targets.size());
    for (int i = 0; i < robot.axis_count(); ++i) {
      CHECK(asked_of(robot, i, references).speed <= 1 + 1e-6);
      CHECK(asked_of(robot, i, references).acceleration <= 1 + 1e-6);
    }
  }
}
