#include <doctest/doctest.h>

#include <numbers>
#include <random>
#include <string>

#include "motion/generate/corner_miss.h"
#include "motion/plan/motion_planner.h"
#include "motion/robots/robot_library.h"

using namespace rob::motion;

namespace {

MotionRequest random_request(const RobotModel& robot, std::mt19937& random) {
  MotionRequest request;
  request.given = 0x3f;
  for (std::size_t i = 0; i < robot.axes.size(); ++i) {
    std::uniform_real_distribution<double> within(robot.axes[i].min, robot.axes[i].max);
    request.target[i] = within(random);
  }
  return request;
}

SegmentDescriptor planned(MotionPlanner& planner, const MotionRequest& request) {
  return std::get<PlannedSegment>(planner.plan(request)).segment;
}

}  // namespace

TEST_CASE("an arm's motion takes as long as its slowest axis") {
  const RobotModel robot = embedded_robot("irb120");
  MotionPlanner planner(robot, robot.start);
  MotionRequest request;
  request.given = 0x3f;
  for (int i = 0; i < 6; ++i) request.target[static_cast<std::size_t>(i)] = robot.start[i];
  request.target[0] += 125 * std::numbers::pi / 180;  // at 250 deg/s
  request.target[5] += 400 * std::numbers::pi / 180;  // at 420 deg/s
  const SegmentDescriptor segment = planned(planner, request);
  CHECK(segment.duration == doctest::Approx(400.0 / 420));
  CHECK(segment.limit == 2 + 5);
}

TEST_CASE("AT slows an arm to that speed over the straight distance of its tool") {
  const RobotModel robot = embedded_robot("irb120");
  MotionPlanner planner(robot, robot.start);
  MotionRequest request;
  request.given = 1;
  request.target[0] = std::numbers::pi / 2;
  request.pace = MotionRequest::Pace::ToolSpeed;
  request.pace_value = 0.1;
  // At the start the tool is 302 mm from axis 1: a quarter turn is 302·√2 mm straight.
  const SegmentDescriptor segment = planned(planner, request);
  CHECK(segment.duration == doctest::Approx(0.302 * std::numbers::sqrt2 / 0.1));
}

TEST_CASE("ZONE bounds the corner miss of an arm's tool, tip and all") {
  for (const std::string name : {"lwa4p", "irb120"}) {
    CAPTURE(name);
    const RobotModel robot = embedded_robot(name);
    std::mt19937 random(21);
    MotionPlanner planner(robot, robot.start);
    SegmentDescriptor before = planned(planner, random_request(robot, random));
    int bounded = 0;
    double greatest = 0;
    for (int i = 0; i < 300; ++i) {
      MotionRequest request = random_request(robot, random);
      request.zone = MotionRequest::Zone::Length;
      request.zone_value = 0.4;
      const auto in = std::get<PlannedSegment>(planner.plan(request));
      const JointVector via_from = before.target;
      MotionRequest next = random_request(robot, random);
      const SegmentDescriptor out = planned(planner, next);
      if ((in.warnings & PlannedSegment::kZoneRaised) == 0) {
        ++bounded;
        const double miss = corner_miss(*robot.kinematics, via_from, in.segment, out);
        greatest = std::max(greatest, miss);
        CHECK(miss <= request.zone_value);
      }
      before = out;
    }
    CHECK(bounded > 20);
    CHECK(greatest > 0);
  }
}
