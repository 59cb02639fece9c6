#include "motion/plan/feasibility.h"

#include <doctest/doctest.h>

#include <cmath>

#include "motion/robots/robot_library.h"

using namespace rob::motion;
using Cause = Refusal::Kind;

TEST_CASE("a target on the limits can be reached, one micrometre beyond cannot") {
  const RobotModel robot = embedded_robot("gantry");
  CHECK_FALSE(check_target(robot, 0b111, {0.4, 0.3, 0}));
  CHECK_FALSE(check_target(robot, 0b111, {0, 0, 0}));
  const auto above = check_target(robot, 0b111, {0.400001, 0, 0});
  REQUIRE(above);
  CHECK(above->kind == Cause::AboveMaximum);
  CHECK(above->axis == 0);
  CHECK(above->value == 0.400001);
  CHECK(above->limit == 0.4);
  const auto below = check_target(robot, 0b111, {0, -0.000001, 0});
  REQUIRE(below);
  CHECK(below->kind == Cause::BelowMinimum);
  CHECK(below->axis == 1);
  CHECK(below->limit == 0);
}

TEST_CASE("a nanometre beyond a limit is rounding, ten are not") {
  const RobotModel robot = embedded_robot("gantry");
  CHECK_FALSE(check_target(robot, 0b001, {0.4 + 0.9e-9}));
  CHECK(check_target(robot, 0b001, {0.4 + 10e-9}));
}

TEST_CASE("only the components that are given are judged") {
  const RobotModel robot = embedded_robot("gantry");
  CHECK_FALSE(check_target(robot, 0b101, {0.1, 99, 0}));
  CHECK(check_target(robot, 0b010, {0.1, 99, 0}));
}

TEST_CASE("what is no number is refused as such") {
  const RobotModel robot = embedded_robot("gantry");
  for (const double value : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    const auto refusal = check_target(robot, 0b100, {0, 0, value});
    REQUIRE(refusal);
    CHECK(refusal->kind == Cause::NotFinite);
    CHECK(refusal->axis == 2);
  }
}
