#include "runtime/words/units.h"

#include <doctest/doctest.h>

#include <cmath>

#include "motion/robots/robot_library.h"

namespace rob::runtime {

TEST_CASE("where the robot stands is measured, with the reference of an axis that is off it") {
  const motion::RobotModel gantry = motion::embedded_robot("gantry");
  motion::JointVector reference(3);
  reference << 0.1, -0.02, 0.5;
  CHECK(stand_text(gantry, reference, reference) == "x 100 mm, y -20 mm, theta 28.64789 deg");
  motion::JointVector measured = reference;
  measured[0] -= 49e-6;  // 0.049 mm: nobody sees that
  measured[1] += 0.001234;
  CHECK(stand_text(gantry, measured, reference) ==
        "x 100 mm, y -18.77 mm (its reference is -20 mm), theta 28.64789 deg");
  measured[2] = -0.05323;
  CHECK(stand_text(gantry, measured, reference) ==
        "x 100 mm, y -18.77 mm (its reference is -20 mm), theta -3.05 deg (its reference is 28.65"
        " deg)");
}

TEST_CASE("a number with all its decimals is never minus zero") {
  CHECK(fixed(-0.004, 2) == "0.00");
  CHECK(fixed(-0.006, 2) == "-0.01");
  CHECK(fixed(-0.0, 0) == "0");
  CHECK(fixed(-100, 1) == "-100.0");
  motion::Pose pose;
  pose.position << -0.0, 1e-3, -0.0;
  for (const double value : shown_pose(pose)) CHECK_FALSE(std::signbit(value));
}

TEST_CASE("an axis is not beside its reference by less than its encoder can tell") {
  motion::Axis axis = motion::embedded_robot("gantry").axes[0];
  CHECK(stands_beside(axis, 0.1001, 0.1));
  axis.drive.encoder_resolution = 2e-4;
  CHECK_FALSE(stands_beside(axis, 0.1001, 0.1));
  CHECK(stands_beside(axis, 0.1003, 0.1));
}

}  // namespace rob::runtime
