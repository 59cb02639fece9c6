#include <doctest/doctest.h>

#include "motion/path/tool_line.h"
#include "motion/path/tool_spline.h"
#include "motion/plan/motion_planner.h"
#include "motion/robots/robot_library.h"

using namespace rob::motion;
using Eigen::Vector3d;

namespace {

RobotModel irb120() {
  RobotModel robot = embedded_robot("irb120");
  robot.law = Law::LookAhead;
  return robot;
}

}  // namespace

TEST_CASE("a line that its axes cannot follow is refused under the look-ahead law, too") {
  // Past axis 1 at 0.5 mm: it would have to turn half round within a millimetre.
  const RobotModel robot = irb120();
  const Pose from{Vector3d(0.2, 0.0005, 0.75), Eigen::Quaterniond::Identity()};
  const auto q = robot.kinematics->inverse(from, robot.start);
  REQUIRE(q.has_value());
  MotionPlanner planner(robot, *q);
  MotionRequest how;
  how.pace = MotionRequest::Pace::ToolSpeed;
  how.pace_value = 0.5;
  const auto line = ToolLine::between(from, {Vector3d(-0.2, 0.0005, 0.75), from.orientation});
  REQUIRE(line.has_value());
  const PlanOutcome outcome = planner.plan(how, *line);
  REQUIRE(std::holds_alternative<Refusal>(outcome));
  CHECK(std::get<Refusal>(outcome).kind == Refusal::Kind::PathSingular);
  CHECK(planner.last_number() == 0);
}

TEST_CASE("ACCEL of a motion with a profile is that of the tool on its swing, not on its chord") {
  const RobotModel robot = irb120();
  JointVector from = robot.start;
  from[0] = -1.5;
  MotionPlanner planner(robot, from);
  MotionRequest how;
  how.given = 1;  // axis 1: 3 rad
  how.target[0] = 1.5;
  how.profile = Profile::Rectangular;
  how.accel = MotionRequest::Bound::Tool;
  how.accel_value = 0.05;
  const PlanOutcome outcome = planner.plan(how);
  REQUIRE(std::holds_alternative<PlannedSegment>(outcome));
  // 3·r in the time of a triangle of speed: 2·√(way/a).
  const double r = robot.kinematics->forward(robot.start).position.head<2>().norm();
  CHECK(std::get<PlannedSegment>(outcome).segment.duration ==
        doctest::Approx(2 * std::sqrt(3 * r / how.accel_value)).epsilon(1e-6));
}

TEST_CASE("ACCEL and JERK on a spline are judged by how fast the tool is, not its parameter") {
  // Where it turns back the tool nearly stands, and each unit of the parameter is no way at all.
  const RobotModel robot = irb120();
  const Pose from = robot.kinematics->forward(robot.start);
  const auto beside = [&](double x_mm, double y_mm) {
    return Pose{from.position + Vector3d(x_mm, y_mm, 0) / 1000, from.orientation};
  };
  const auto smooth = ToolSpline::through({from, beside(13, 4), beside(26, 8)});
  const auto back = ToolSpline::through({from, beside(26, 8), beside(24.6, 7.6)});
  REQUIRE(smooth.has_value());
  REQUIRE(back.has_value());
  const auto bounds = [&](const ToolSpline& curve) {
    MotionRequest how;
    how.accel = MotionRequest::Bound::Tool;
    how.accel_value = 0.5;
    MotionPlanner planner(robot, robot.start);
    return std::get<PlannedSegment>(planner.plan(how, curve)).segment.ahead;
  };
  // The same axes move the same tool about the same place: what they give hardly differs.
  CHECK(bounds(*back).acceleration == doctest::Approx(bounds(*smooth).acceleration).epsilon(0.2));
}
