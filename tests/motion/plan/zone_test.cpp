#include <doctest/doctest.h>

#include <cmath>

#include "motion/plan/motion_planner.h"
#include "motion/robots/robot_library.h"
#include "motion/robots/time_scaling.h"

using namespace rob::motion;

namespace {

MotionRequest to(double x_mm, double y_mm, MotionRequest::Zone zone, double value) {
  MotionRequest request;
  request.given = 7;
  request.target = {x_mm / 1000, y_mm / 1000, 0};
  request.zone = zone;
  request.zone_value = value;
  return request;
}

PlannedSegment planned_leg(MotionPlanner& planner, const MotionRequest& request) {
  return std::get<PlannedSegment>(planner.plan(request));
}

using Zone = MotionRequest::Zone;

}  // namespace

TEST_CASE("a ZONE time is half the time of the corner, a share scales the robot's") {
  const RobotModel robot = embedded_robot("gantry");
  MotionPlanner planner(robot, robot.start);
  const PlannedSegment first = planned_leg(planner, to(100, 0, Zone::Time, 0.5));
  CHECK(first.segment.t_acc == 0.5);
  CHECK(first.segment.t_acc_before == 1.375);
  CHECK(first.segment.span() == doctest::Approx(5 + 1.375 - 0.5));  // 100 mm at 20 mm/s
  CHECK(first.warnings == 0);
  const PlannedSegment second = planned_leg(planner, to(200, 0, Zone::Share, 2));
  CHECK(second.segment.t_acc == 2.75);
  CHECK(second.segment.t_acc_before == 0.5);
}

TEST_CASE("two corners need the time of both halves") {
  const RobotModel robot = embedded_robot("gantry");
  MotionPlanner planner(robot, robot.start);
  CHECK(planned_leg(planner, to(1, 0, Zone::Time, 0.5)).segment.duration == 1.375 + 0.5);
  CHECK(planned_leg(planner, to(2, 0, Zone::Unspecified, 0)).segment.duration == 0.5 + 1.375);
}

TEST_CASE("a ZONE length is missed by no more at the worst that may follow") {
  const RobotModel robot = embedded_robot("gantry");
  MotionPlanner planner(robot, robot.start);
  // v_in = 20 mm/s; both axes at 20 mm/s make 28.284 mm/s: 16·5/(3·48.284) = 0.5523 s.
  const PlannedSegment first = planned_leg(planner, to(100, 0, Zone::Length, 0.005));
  CHECK(first.segment.t_acc == doctest::Approx(0.5523).epsilon(1e-4));
  // No more than the robot's, however much may be missed.
  CHECK(planned_leg(planner, to(200, 0, Zone::Length, 1)).segment.t_acc == 1.375);
}

TEST_CASE("where corners decide the duration, the ZONE length is that of the true speed") {
  const RobotModel robot = embedded_robot("gantry");
  MotionPlanner planner(robot, robot.start);
  // 4 mm take 0.2 s at full speed, t_B + t_C = 1.375 s + t in truth.
  const SegmentDescriptor segment = planned_leg(planner, to(4, 0, Zone::Length, 0.005)).segment;
  CHECK(segment.duration == doctest::Approx(1.375 + segment.t_acc));
  const double worst = 0.004 / segment.duration + 0.020 * std::sqrt(2.0);
  CHECK(3.0 / 16 * segment.t_acc * worst == doctest::Approx(0.005));
}

TEST_CASE("a ZONE that leaves too little for a hold is widened, and says so") {
  const RobotModel robot = embedded_robot("gantry");
  MotionPlanner planner(robot, robot.start);
  const PlannedSegment tight = planned_leg(planner, to(100, 0, Zone::Time, 0.01));
  CHECK(tight.warnings == PlannedSegment::kZoneRaised);
  CHECK(tight.segment.t_acc == least_t_acc(robot));
  CHECK(leaves_room_to_stop(axis_reserve(robot), tight.segment.t_acc));
  CHECK_FALSE(leaves_room_to_stop(axis_reserve(robot), 0.99 * tight.segment.t_acc));
  CHECK(1.5 * 0.020 / tight.segment.t_acc < robot.axes[0].a_max);
}

TEST_CASE("a stop takes twice the half transition of the target that it makes exact") {
  const RobotModel robot = embedded_robot("gantry");
  MotionPlanner planner(robot, robot.start);
  planned_leg(planner, to(100, 0, Zone::Time, 0.5));
  const auto stop = planner.stop(1);
  REQUIRE(stop);
  CHECK(stop->duration == 1.0);
  CHECK(stop->t_acc == 0.5);
}

TEST_CASE("a relative target counts from the last one, and its limits are those of the sum") {
  const RobotModel robot = embedded_robot("gantry");
  MotionPlanner planner(robot, robot.start);
  planned_leg(planner, to(300, 20, Zone::Unspecified, 0));
  MotionRequest by;
  by.relative = true;
  by.given = 1;
  by.target[0] = 0.050;
  CHECK(planned_leg(planner, by).segment.target[0] == doctest::Approx(0.350));
  CHECK(planner.commanded()[1] == 0.020);
  by.target[0] = 0.051;
  const auto refusal = std::get<Refusal>(planner.plan(by));
  CHECK(refusal.kind == Refusal::Kind::AboveMaximum);
  CHECK(refusal.value == doctest::Approx(0.401));
  CHECK(planner.commanded()[0] == doctest::Approx(0.350));
}
