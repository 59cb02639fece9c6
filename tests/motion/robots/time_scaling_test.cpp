#include "motion/robots/time_scaling.h"

#include <doctest/doctest.h>

#include <limits>

#include "motion/robots/robot_library.h"

using namespace rob::motion;

TEST_CASE("the gantry stops within 0.37 s anywhere on a path") {
  // a_max/v_max = 5/s, j_max/v_max = 50/s², t_acc = 1.375 s on every axis:
  // R = 5 − 1.5/1.375 = 3.9091/s, S = 50 − 3/1.375² − 4.5·3.9091/1.375 = 35.62/s².
  const TimeScaleLimits limits = time_scale_limits(embedded_robot("gantry"));
  CHECK(limits.slope == doctest::Approx(3.9091).epsilon(1e-4));
  CHECK(limits.bend == doctest::Approx(35.62).epsilon(1e-4));
  CHECK(stopping_time(limits) == doctest::Approx(1 / 3.9091 + 3.9091 / 35.62).epsilon(1e-4));
}

TEST_CASE("the weakest axis decides") {
  RobotModel robot = embedded_robot("gantry");
  robot.axes[1].a_max = 0.050;  // 2.5/s
  CHECK(time_scale_limits(robot).slope == doctest::Approx(2.5 - 1.5 / 1.375));
}

TEST_CASE("with little jerk the slope leaves half of it for the bend") {
  RobotModel robot = embedded_robot("gantry");
  for (Axis& axis : robot.axes) axis.j_max = 10 * axis.v_max;
  const double left = 10 - 3 / (1.375 * 1.375);
  const TimeScaleLimits limits = time_scale_limits(robot);
  CHECK(limits.bend == doctest::Approx(left / 2));
  CHECK(4.5 / 1.375 * limits.slope == doctest::Approx(left / 2));
}

TEST_CASE("corners that take all of an axis leave nothing for a stop") {
  RobotModel robot = embedded_robot("gantry");
  robot.axes[0].a_max = 1.4 * robot.axes[0].v_max / robot.t_acc;
  CHECK(time_scale_limits(robot).slope < 0);
}

TEST_CASE("a stop that never reaches the greatest slope takes 2/√S") {
  CHECK(stopping_time({100, 16}) == doctest::Approx(0.5));
}

TEST_CASE("without a limit of jerk a hold takes what the acceleration leaves, and a millisecond") {
  RobotModel robot = embedded_robot("gantry");
  for (Axis& axis : robot.axes) axis.j_max = std::numeric_limits<double>::infinity();
  const TimeScaleLimits limits = time_scale_limits(robot);
  CHECK(limits.slope == doctest::Approx(5 - 1.5 / 1.375));
  CHECK(stopping_time(limits) == doctest::Approx(1 / limits.slope + 0.001));
  CHECK(least_t_acc(robot) < robot.t_acc);
}

TEST_CASE("under the look-ahead law half of the acceleration and of the jerk hold a profile") {
  RobotModel robot = embedded_robot("gantry");
  robot.law = Law::LookAhead;
  robot.t_acc = 0;
  CHECK(time_scale_limits(robot).slope == doctest::Approx(2.5));
  CHECK(time_scale_limits(robot).bend == doctest::Approx(25));
  CHECK(least_t_acc(robot) == 0);
}
