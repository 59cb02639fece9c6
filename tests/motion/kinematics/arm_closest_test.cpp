#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "motion/path/way_cost.h"
#include "motion/robots/robot_library.h"
#include "tests/motion/kinematics/arms.h"

using namespace rob::motion;
using namespace rob::test;

namespace {

/// How far a pose is from another, 1 rad as 100 mm, rad.
double apart(const Pose& one, const Pose& other) {
  return std::hypot((one.position - other.position).norm() / 0.1,
                    one.orientation.angularDistance(other.orientation));
}

JointVector any_within(const RobotModel& robot, std::mt19937& random) {
  JointVector q(robot.axis_count());
  for (int i = 0; i < q.size(); ++i) {
    const Axis& axis = robot.axes[static_cast<std::size_t>(i)];
    q[i] = std::uniform_real_distribution<double>(axis.min, axis.max)(random);
  }
  return q;
}

}  // namespace

TEST_CASE("the closest axes of an arm reach what can be reached, by the published table") {
  std::mt19937 random(1);
  for (const PublishedArm& arm : published_arms()) {
    CAPTURE(arm.name);
    const RobotModel robot = embedded_robot(arm.name);
    for (int i = 0; i < 50; ++i) {
      JointVector q = any_within(robot, random) * 0.8;
      q[4] += 0.3;  // off the wrist's singular place
      if (!axes_within(robot, q) || robot.kinematics->stretch(q) < 0.1) continue;
      const Pose pose = robot.kinematics->forward(q);
      JointVector near = q;
      for (double& value : near) value += std::uniform_real_distribution<double>(-0.1, 0.1)(random);
      const auto found = robot.kinematics->closest(pose, near);
      REQUIRE(found.has_value());
      const Eigen::Matrix4d is = dh_forward(arm, *found);
      CHECK((is.topRightCorner<3, 1>() - pose.position).norm() < 1e-6);
    }
  }
}

TEST_CASE("no axes within the limits of an arm are nearer to a pose out of reach") {
  std::mt19937 random(2);
  for (const char* const name : {"irb120", "lwa4p", "puma560"}) {
    CAPTURE(name);
    const RobotModel robot = embedded_robot(name);
    Pose far = robot.kinematics->forward(robot.start);
    far.position += Eigen::Vector3d(0.9, 0.5, 0.1);
    CHECK(robot.kinematics->solutions(far, robot.start).count == 0);
    const auto found = robot.kinematics->closest(far, robot.start);
    REQUIRE(found.has_value());
    CHECK(axes_within(robot, *found));
    const double least = apart(robot.kinematics->forward(*found), far);
    CHECK(least < apart(robot.kinematics->forward(robot.start), far));
    for (const double size : {1e-3, 1e-2, 0.1}) {
      for (int i = 0; i < 300; ++i) {
        JointVector q = *found;
        for (int k = 0; k < q.size(); ++k) {
          const Axis& axis = robot.axes[static_cast<std::size_t>(k)];
          q[k] += std::uniform_real_distribution<double>(-size, size)(random);
          q[k] = std::clamp(q[k], axis.min, axis.max);
        }
        CHECK(apart(robot.kinematics->forward(q), far) > least - 1e-4);
      }
    }
  }
}
