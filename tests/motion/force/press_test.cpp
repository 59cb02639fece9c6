#include "motion/force/press.h"

#include <doctest/doctest.h>

#include <cmath>

#include "motion/robots/robot_library.h"
#include "tests/support/no_allocation.h"
#include "tests/support/relative.h"

namespace rob::motion {
namespace {

JointReference at_rest(const JointVector& q) {
  const JointVector none = JointVector::Zero(q.size());
  return {0, q, none, none};
}

/// Below the tool: N/m from `top` down, along the world.
Wrench pressed(double stiffness, double top, double z) {
  Wrench wrench;
  wrench.force.z() = std::max(0.0, top - z) * stiffness;
  return wrench;
}

}  // namespace

TEST_CASE("a press shifts the flange along its axis alone, and the rates are those of the shift") {
  const RobotModel robot = embedded_robot("lwa4p");
  Press press(robot);
  const Pose from = robot.kinematics->forward(robot.start);
  const double top = from.position.z() - 1e-3;
  press.begin({Eigen::Vector3d::UnitZ(), 10, 5e-3});
  REQUIRE(press.active());
  JointReference before = at_rest(robot.start);
  const double period = robot.reference_period;
  double z = from.position.z();
  for (int k = 0; k < 500; ++k) {
    const test::NoAllocation guard;
    press.step(pressed(50e3, top, z), false);
    JointReference reference = at_rest(robot.start);
    press.shift(reference);
    CHECK(guard.count() == 0);
    const Pose here = robot.kinematics->forward(reference.q);
    CHECK((here.position - from.position).head<2>().norm() < 1e-9);
    CHECK(here.orientation.angularDistance(from.orientation) < 1e-9);
    // constant acceleration within a period, the arm hardly bends on so short a way
    const JointVector mean = (reference.q - before.q) / period;
    CHECK((mean - (reference.qd + before.qd) / 2).norm() < 1e-4);
    before = reference;
    z = here.position.z();
  }
  CHECK(press.settled());
  CHECK((top - z) * 50e3 == test::relative(10, 0.01));
}

TEST_CASE("a press that meets nothing goes 50 mm and stands, and so does one at an axis' end") {
  RobotModel robot = embedded_robot("lwa4p");
  const Pose from = robot.kinematics->forward(robot.start);
  const auto way_of = [&](const Eigen::Vector3d& axis, bool at_end) {
    Press press(robot);
    press.begin({axis, 10, 20e-3});
    JointReference reference = at_rest(robot.start);
    for (int k = 0; k < 20000 && !(press.lost() && press.stands()); ++k) {
      press.step({}, false);
      reference = at_rest(robot.start);
      press.shift(reference);
    }
    CHECK(press.lost());
    CHECK(press.at_end() == at_end);
    CHECK_FALSE(press.settled());
    const JointVector& q = reference.q;
    for (int i = 0; i < q.size(); ++i) {
      CHECK(q[i] <= robot.axes[static_cast<std::size_t>(i)].max);
      CHECK(q[i] >= robot.axes[static_cast<std::size_t>(i)].min);
    }
    return (robot.kinematics->forward(q).position - from.position).dot(axis);
  };
  CHECK(way_of(Eigen::Vector3d::UnitZ(), false) == test::relative(-Press::kReach, 0.01));
  robot.axes[1].max = robot.start[1] + 0.02;
  const double way = way_of(Eigen::Vector3d::UnitZ(), true);
  CHECK(way < 0);
  CHECK(way > -Press::kReach);
}

TEST_CASE("a press with nearly all the speed and half of the acceleration of an axis goes on") {
  const RobotModel robot = embedded_robot("gantry");
  Press press(robot);
  press.begin({Eigen::Vector3d::UnitX(), -10, 0.95 * robot.axes[0].v_max});
  JointReference reference = at_rest(robot.start);
  for (int k = 0; k < 20000 && !(press.lost() && press.stands()); ++k) {
    press.step({}, false);
    reference = at_rest(robot.start);
    press.shift(reference);
  }
  CHECK(press.lost());
  CHECK_FALSE(press.at_end());
  CHECK(reference.q[0] - robot.start[0] == test::relative(Press::kReach, 0.03));
}

TEST_CASE("what the path asks of the axes is not asked by the press") {
  const RobotModel robot = embedded_robot("gantry");
  const Axis& along = robot.axes[1];
  Press press(robot);
  press.begin({Eigen::Vector3d::UnitX(), -10, 0.5 * robot.axes[0].v_max});
  const double rises = along.v_max / along.a_max;  // s
  for (double t = robot.reference_period; t < rises; t += robot.reference_period) {
    JointReference path = at_rest(robot.start);
    path.q[1] += along.a_max * t * t / 2;
    path.qd[1] = along.a_max * t;
    path.qdd[1] = along.a_max;
    JointReference reference = path;
    press.step({}, false);
    press.shift(reference);
    REQUIRE_FALSE(press.lost());
    CHECK(reference.q[1] == test::relative(path.q[1], 1e-9));
    CHECK(reference.qd[1] == test::relative(path.qd[1], 1e-6));
  }
  CHECK(press.active());
}

}  // namespace rob::motion
