#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "motion/path/tool_arc.h"
#include "motion/path/tool_line.h"
#include "motion/plan/ahead_leg.h"
#include "motion/plan/motion_planner.h"
#include "motion/robots/robot_library.h"
#include "motion/space/rotation.h"
#include "tests/support/degrees.h"
#include "tests/support/no_allocation.h"

using namespace rob::motion;
using Eigen::Vector3d;
using Bound = MotionRequest::Bound;
using Pace = MotionRequest::Pace;
using Zone = MotionRequest::Zone;
using rob::test::kDegree;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

RobotModel under_look_ahead(const std::string& name) {
  RobotModel robot = embedded_robot(name);
  robot.law = Law::LookAhead;
  return robot;
}

MotionRequest to(double x_mm, double y_mm, double theta_deg = 0) {
  MotionRequest request;
  request.given = 7;
  request.target = {x_mm / 1000, y_mm / 1000, theta_deg * kDegree};
  return request;
}

MotionRequest paced(MotionRequest request, Pace pace, double value) {
  request.pace = pace;
  request.pace_value = value;
  return request;
}

MotionRequest zoned(MotionRequest request, Zone zone, double value) {
  request.zone = zone;
  request.zone_value = value;
  return request;
}

MotionRequest accelerated(MotionRequest request, Bound bound, double value) {
  request.accel = bound;
  request.accel_value = value;
  return request;
}

MotionRequest jerked(MotionRequest request, Bound bound, double value) {
  request.jerk = bound;
  request.jerk_value = value;
  return request;
}

/// The gantry's planner: 20 mm/s, 100 mm/s², 1000 mm/s³ and the same in degrees; it stands at 0.
struct Planned {
  RobotModel robot = under_look_ahead("gantry");
  MotionPlanner planner{robot, robot.start};

  PlannedSegment take(const MotionRequest& request) {
    return std::get<PlannedSegment>(planner.plan(request));
  }
  LegBounds bounds(const MotionRequest& request) { return take(request).segment.ahead; }
};

}  // namespace

TEST_CASE(
    "under the look-ahead law a motion says how long it is and what bounds it, not its time") {
  Planned p;
  const PlannedSegment planned = p.take(to(30, 40));
  const SegmentDescriptor& segment = planned.segment;
  CHECK(planned.warnings == 0);
  CHECK(segment.ahead.length == doctest::Approx(0.05));
  CHECK(segment.ahead.speed == kInfinity);
  CHECK_FALSE(segment.ahead.paced);
  CHECK(segment.ahead.acceleration == 1);
  CHECK(segment.ahead.window == doctest::Approx(2 * 100 / 1000.0));  // 2·A/J
  CHECK(segment.ahead.miss == p.robot.zone.distance);
  CHECK(segment.ahead.turn == p.robot.zone.angle);
  CHECK(segment.ahead.lead == kInfinity);
  CHECK(segment.ahead.share == 1);
  CHECK(segment.duration == doctest::Approx(2));  // 40 mm at 20 mm/s
  CHECK(segment.path == nullptr);
  CHECK(segment.corner == nullptr);
  CHECK_FALSE(segment.from_rest);
  CHECK(segment.t_acc == 0);
  CHECK(segment.number == 1);
}

TEST_CASE("a motion whose tool stays where it is is as long as 1 mm for each degree") {
  Planned p;
  CHECK(p.bounds(to(0, 0, 90)).length == doctest::Approx(0.09));
  CHECK(p.bounds(paced(to(0, 0, 0), Pace::AngularSpeed, 10 * kDegree)).speed ==
        doctest::Approx(0.01));
  // AT a speed of the tool has nothing to bound there.
  CHECK(p.bounds(paced(to(0, 0, 90), Pace::ToolSpeed, 0.01)).speed == kInfinity);
}

TEST_CASE("AT and OVER bound the speed along the leg, and the slower counts") {
  Planned p;
  const LegBounds tool = p.bounds(paced(to(30, 40), Pace::ToolSpeed, 0.012));
  CHECK(tool.speed == doctest::Approx(0.012));
  CHECK(tool.paced);
  // 90 deg at 10 deg/s are 9 s for 50 mm.
  CHECK(p.bounds(paced(to(0, 0, 90), Pace::AngularSpeed, 10 * kDegree)).speed ==
        doctest::Approx(0.05 / 9));
  // The slower axis alone takes 2 s at full speed, 4 s at half.
  CHECK(p.bounds(paced(to(30, 40, 90), Pace::Share, 0.5)).speed == doctest::Approx(0.05 / 4));
  MotionRequest slow = paced(to(0, 0, 90), Pace::ToolSpeed, 0.01);  // 5 s
  slow.at_least = 10;
  CHECK(p.bounds(slow).speed == doctest::Approx(0.005));
  slow = paced(to(30, 40, 90), Pace::ToolSpeed, 0.002);  // 25 s
  slow.at_least = 10;
  CHECK(p.bounds(slow).speed == doctest::Approx(0.002));
}

TEST_CASE("what AT and OVER ask for in vain is told") {
  Planned p;
  const PlannedSegment fast = p.take(paced(to(30, 40), Pace::ToolSpeed, 0.026));
  CHECK(fast.warnings == PlannedSegment::kPaceCut);  // 25 mm/s is what the y axis leaves
  CHECK(fast.segment.duration == doctest::Approx(2));
  CHECK(p.take(paced(to(0, 0), Pace::ToolSpeed, 0.025)).warnings == 0);
  MotionRequest hurried = to(30, 40);
  hurried.at_least = 1.9;
  const PlannedSegment stretched = p.take(hurried);
  CHECK(stretched.warnings == PlannedSegment::kStretched);
  CHECK(stretched.segment.duration == doctest::Approx(2));
  hurried = to(0, 0);
  hurried.at_least = 2;
  CHECK(p.take(hurried).warnings == 0);
}

TEST_CASE("ACCEL leaves that share of every axis' acceleration which the tool has along the leg") {
  Planned p;
  // (30, 40): y limits it, 100 mm/s² there are 125 mm/s² of the tool.
  const LegBounds half = p.bounds(accelerated(to(30, 40), Bound::Tool, 0.0625));
  CHECK(half.acceleration == doctest::Approx(0.5));
  CHECK(half.window == doctest::Approx(0.1));  // 2·50/1000
  CHECK(p.bounds(accelerated(to(30, 40, 90), Bound::Rotary, 25 * kDegree)).acceleration ==
        doctest::Approx(0.25));
  const PlannedSegment vain = p.take(accelerated(to(60, 80, 90), Bound::Tool, 0.126));
  CHECK(vain.segment.ahead.acceleration == 1);
  CHECK(vain.warnings == PlannedSegment::kBoundCut);
  // The tool does not move, and is not accelerated.
  CHECK(p.bounds(accelerated(to(60, 80, 0), Bound::Tool, 0.001)).acceleration == 1);
}

TEST_CASE("JERK and the axes' own make the window 2·A/J, the longest of all axes") {
  Planned p;
  // With less jerk, too, 2·100/1000 s: the mean of all that asks for none.
  const LegBounds low = p.bounds(jerked(to(30, 40), Bound::Tool, 0.8));
  CHECK(low.window == doctest::Approx(0.2));
  CHECK(low.acceleration == doctest::Approx(0.2 * 0.8 / 2 / 0.1));  // T_w·J/2
  CHECK(p.bounds(jerked(to(0, 0, 90), Bound::Rotary, 800 * kDegree)).window ==
        doctest::Approx(0.2));
  const PlannedSegment vain = p.take(jerked(to(30, 40), Bound::Tool, 2));
  CHECK(vain.segment.ahead.window == doctest::Approx(0.2));
  CHECK(vain.warnings == PlannedSegment::kBoundCut);

  for (Axis& axis : p.robot.axes) axis.j_max = kInfinity;
  CHECK(p.bounds(to(0, 0)).window == 0);
  CHECK(p.bounds(jerked(to(30, 40), Bound::Tool, 100)).window == doctest::Approx(0.002));
  p.robot.axes[2].j_max = 500 * kDegree;
  CHECK(p.bounds(to(0, 0)).window == doctest::Approx(0.25));  // 2·100/500 s is too long
}

TEST_CASE("ACCEL and JERK in percent are shares of the robot's maxima of every axis") {
  Planned p;
  const LegBounds half = p.bounds(accelerated(to(30, 40), Bound::Share, 0.5));
  CHECK(half.acceleration == 0.5);
  CHECK(half.window == doctest::Approx(0.1));  // 2·50/1000
  // Turning alone, where ACCEL of the tool bounds nothing.
  CHECK(p.bounds(accelerated(to(30, 40, 90), Bound::Share, 0.3)).acceleration == 0.3);
  CHECK(p.take(accelerated(to(0, 0), Bound::Share, 1.1)).warnings == PlannedSegment::kBoundCut);
  // All axes have 1000: 80% of it is JERK 800mm/s^3, which the test before computes.
  const LegBounds low = p.bounds(jerked(to(30, 40), Bound::Share, 0.8));
  CHECK(low.window == doctest::Approx(0.2));
  CHECK(low.acceleration == doctest::Approx(0.2 * 0.8 / 2 / 0.1));
}

TEST_CASE("where jerk is low the acceleration is no greater than a ramp to full speed can use") {
  Planned p;
  for (Axis& axis : p.robot.axes) axis.j_max = kInfinity;
  // x at 20 mm/s with 100 mm/s³: √(F·J)/2 = 22.4 mm/s², so T_w = 2·22.4/100.
  const double least = std::sqrt(20.0 * 100) / 2;
  const LegBounds low = p.bounds(jerked(to(100, 0), Bound::Tool, 0.1));
  CHECK(low.acceleration == doctest::Approx(least / 100));
  CHECK(low.window == doctest::Approx(2 * least / 100));
  // With AT 5 mm/s it is half of that.
  const LegBounds slow =
      p.bounds(paced(jerked(to(0, 0), Bound::Tool, 0.1), Pace::ToolSpeed, 0.005));
  CHECK(slow.acceleration == doctest::Approx(least / 200));
  // Next to no jerk: the window is as long as it may be, and A = T_w·J/2.
  const LegBounds least_of_all = p.bounds(jerked(to(100, 0), Bound::Tool, 0.001));
  CHECK(least_of_all.window == doctest::Approx(kLongestWindow));
  CHECK(least_of_all.acceleration == doctest::Approx(kLongestWindow * 0.001 / 2 / 0.1));
}

TEST_CASE("ZONE bounds the corner by a length, by when it begins, or by its share of the legs") {
  Planned p;
  const LegBounds length = p.bounds(zoned(to(30, 40), Zone::Length, 0.002));
  CHECK(length.miss == 0.002);
  CHECK(length.turn == p.robot.zone.angle);
  CHECK(length.lead == kInfinity);
  // 25 mm/s is the full speed of this leg, 10 mm/s what AT leaves of the next.
  const LegBounds time = p.bounds(zoned(to(0, 0), Zone::Time, 0.2));
  CHECK(time.lead == doctest::Approx(0.005));
  CHECK(time.miss == kInfinity);
  CHECK(p.bounds(paced(zoned(to(30, 40), Zone::Time, 0.2), Pace::ToolSpeed, 0.01)).lead ==
        doctest::Approx(0.002));
  const LegBounds share = p.bounds(zoned(to(0, 0), Zone::Share, 0.4));
  CHECK(share.share == 0.4);
  CHECK(share.miss == kInfinity);
  CHECK(p.bounds(zoned(to(30, 40), Zone::Share, 3)).share == 1);
}

TEST_CASE("a ZONE that the motions on its sides are too short for is told, with what is left") {
  Planned p;
  // At a right angle a parabola that begins l before the point misses it by l·√2/4.
  const double most = std::numbers::sqrt2 / 4;
  MotionRequest corner = zoned(to(40, 0), Zone::Length, 0.005);
  corner.tag = 7;
  CHECK(p.take(corner).warnings == 0);
  const PlannedSegment cut = p.take(to(40, 10));
  CHECK(cut.warnings == PlannedSegment::kZoneCut);
  CHECK(cut.zone_tag == 7);
  CHECK(cut.zone_left == doctest::Approx(0.010 * most));
  // Just enough; the robot's own zone is nobody's wish; straight on there is nothing to miss.
  p.take(zoned(to(0, 10), Zone::Length, 0.01 * most * (1 - 1e-9)));
  CHECK(p.take(to(0, 0)).warnings == 0);
  CHECK(p.take(zoned(to(1, 0), Zone::Length, 0.5)).warnings == 0);
  CHECK(p.take(to(2, 0)).warnings == 0);
  // Reached exactly, there is no corner.
  p.take(zoned(to(3, 0), Zone::Length, 0.5));
  p.planner.stop(1);
  CHECK(p.take(to(3, 1)).warnings == 0);
}

TEST_CASE("an override changes nothing of what a motion asks for") {
  Planned p;
  p.planner.set_override(2);
  const LegBounds bounds = p.bounds(paced(to(30, 40), Pace::ToolSpeed, 0.01));
  CHECK(bounds.speed == doctest::Approx(0.01));
}

TEST_CASE("a stop takes no time, and a target that is the last one is passed without one") {
  Planned p;
  p.take(to(30, 40));
  const auto stop = p.planner.stop(7);
  REQUIRE(stop.has_value());
  CHECK(stop->no_length);
  CHECK(stop->duration == 0);
  CHECK(stop->span() == 0);
  CHECK_FALSE(p.planner.stop(7).has_value());
  p.take(to(0, 0));
  const PlannedSegment same = p.take(to(0, 0));
  CHECK_FALSE(same.segment.no_length);
  CHECK(same.segment.ahead.length == 0);
  CHECK(p.planner.dwell(7, 2).duration == 2);
}

TEST_CASE("a motion with a profile keeps its law, and begins at rest") {
  Planned p;
  p.take(to(30, 40));
  MotionRequest request = to(30, 240);
  request.profile = Profile::Rectangular;
  const SegmentDescriptor segment = p.take(request).segment;
  CHECK(segment.from_rest);
  // Half of a_max is left for holding it: 200 mm at 20 mm/s and 50 mm/s².
  CHECK(segment.duration == doctest::Approx(200 / 20.0 + 20 / 50.0));
  CHECK(segment.duration == segment.profile.duration());
}

TEST_CASE("ACCEL and JERK bound a motion with a profile") {
  Planned p;
  MotionRequest request = to(100, 0);
  request.profile = Profile::Cosine;
  // t_a = 2·v/A: 20 mm/s and 10 mm/s².
  CHECK(p.take(accelerated(request, Bound::Tool, 0.01)).segment.duration ==
        doctest::Approx(100 / 20.0 + 2 * 20 / 10.0));
  // π·A/t_a = π·A²/(2·v) = 100 mm/s³.
  const double a = std::sqrt(2 * 20 * 100 / std::numbers::pi);
  request.target[0] = 0;
  CHECK(p.take(jerked(request, Bound::Tool, 0.1)).segment.duration ==
        doctest::Approx(100 / 20.0 + 2 * 20 / a));
  // A bound of turning does not concern it.
  request.target[0] = 0.1;
  CHECK(p.take(jerked(request, Bound::Rotary, 1e-3)).segment.duration ==
        doctest::Approx(100 / 20.0 + 2 * 20 / 50.0));
}

TEST_CASE("what cannot be is refused as under Paul's law, and leaves all as it was") {
  Planned p;
  const auto refused = [&](const MotionRequest& request) {
    const PlanOutcome outcome = p.planner.plan(request);
    REQUIRE(std::holds_alternative<Refusal>(outcome));
    CHECK(p.planner.last_number() == 0);
    return std::get<Refusal>(outcome).kind;
  };
  CHECK(refused(to(401, 0)) == Refusal::Kind::AboveMaximum);
  CHECK(refused(paced(to(40, 0), Pace::ToolSpeed, 0)) == Refusal::Kind::BadPace);
  CHECK(refused(zoned(to(40, 0), Zone::Length, -1)) == Refusal::Kind::BadZone);
  CHECK(refused(accelerated(to(40, 0), Bound::Tool, 0)) == Refusal::Kind::BadBound);
  CHECK(refused(jerked(to(40, 0), Bound::Tool, std::nan(""))) == Refusal::Kind::BadBound);
  CHECK(refused(paced(to(40, 0), Pace::ToolSpeed, 1e-9)) == Refusal::Kind::TooLong);
  CHECK(refused(accelerated(to(40, 0), Bound::Tool, 1e-14)) == Refusal::Kind::TooLong);
}

TEST_CASE("a gantry whose tool is beside its axis is measured along the arc that it swings") {
  Planned p;
  p.planner.set_tool({Vector3d(0.1, 0, 0), Eigen::Quaterniond::Identity()});
  // 90 deg at 100 mm: an arc of 157.08 mm, evenly.
  const LegBounds swung = p.bounds(paced(to(0, 0, 90), Pace::ToolSpeed, 0.01));
  CHECK(swung.length == doctest::Approx(0.1 * 90 * kDegree).epsilon(1e-6));
  CHECK(swung.speed == doctest::Approx(0.01).epsilon(1e-6));
  // And along y besides: |dp/ds|² = (Rω·sin φ)² + (Rω·cos φ + 100 mm)², greatest at the beginning.
  p.planner.stand_at(p.robot.start, 0);
  const LegBounds both = p.bounds(paced(to(0, 100, 90), Pace::ToolSpeed, 0.01));
  const double greatest = 0.1 * 90 * kDegree + 0.1;
  CHECK(both.speed == doctest::Approx(0.01 * both.length / greatest).epsilon(1e-6));
}

TEST_CASE("along a path of the tool its length and its fastest place count") {
  Planned p;
  // Half a circle of 50 mm radius.
  const auto arc = ToolArc::through({{0, 0, 0}, Eigen::Quaterniond::Identity()}, {0.05, 0.05, 0},
                                    {{0.1, 0, 0}, Eigen::Quaterniond::Identity()});
  REQUIRE(arc.has_value());
  MotionRequest request = paced({}, Pace::ToolSpeed, 0.01);
  const auto planned = std::get<PlannedSegment>(p.planner.plan(request, *arc));
  const LegBounds& bounds = planned.segment.ahead;
  CHECK(bounds.length == doctest::Approx(0.05 * std::numbers::pi));
  CHECK(bounds.speed == doctest::Approx(0.01));
  CHECK(planned.segment.path == &*planned.leg->axes);
  CHECK(planned.segment.duration == doctest::Approx(5 * std::numbers::pi));
  // Both axes go along the arc; where both share it alike the tool has √2 times what one can do.
  const auto back = ToolArc::through({{0.1, 0, 0}, Eigen::Quaterniond::Identity()}, {0.05, 0.05, 0},
                                     {{0, 0, 0}, Eigen::Quaterniond::Identity()});
  request = accelerated({}, Bound::Tool, 0.05);
  const auto gentle = std::get<PlannedSegment>(p.planner.plan(request, *back));
  CHECK(gentle.segment.ahead.acceleration ==
        doctest::Approx(0.05 / (0.1 * std::numbers::sqrt2)).epsilon(1e-3));
  // At full speed the slower axis has 20 mm/s: ∫ max(|sin|, |cos|) over half a circle is 2·√2.
  CHECK(gentle.segment.duration ==
        doctest::Approx(50 / 20.0 * 2 * std::numbers::sqrt2).epsilon(1e-3));
}

TEST_CASE("an arm's line is bounded by what its axes make of it") {
  const RobotModel robot = under_look_ahead("irb120");
  MotionPlanner planner(robot, robot.start);
  const Pose from = planner.tool_pose();
  const Pose there{from.position + Vector3d(0, 0.1, 0), from.orientation};
  const auto line = ToolLine::between(from, there);
  REQUIRE(line.has_value());
  MotionRequest request = zoned(paced({}, Pace::ToolSpeed, 0.25), Zone::Length, 0.003);
  const auto planned = std::get<PlannedSegment>(planner.plan(request, *line));
  const LegBounds& bounds = planned.segment.ahead;
  CHECK(bounds.length == doctest::Approx(0.1));
  CHECK(bounds.speed == doctest::Approx(0.25));
  CHECK(bounds.miss == 0.003);
  CHECK(planned.segment.duration == doctest::Approx(0.4));
  // 2·A/J is the same for all its axes.
  CHECK(bounds.window ==
        doctest::Approx(2 * robot.axes[0].a_max / robot.axes[0].j_max * bounds.acceleration));

  // JERK of the tool: T_w = 2·σ''/JERK, with σ'' what the axes allow at the strongest place.
  planner.stand_at(robot.start, 0);
  double strongest = 0;
  planned.segment.path->survey(64, [&](double /*s*/, const PathPoint& point) {
    double here = kInfinity;
    for (int i = 0; i < 6; ++i)
      here = std::min(here,
                      robot.axes[static_cast<std::size_t>(i)].a_max * 0.1 / std::abs(point.qd[i]));
    strongest = std::max(strongest, here);
  });
  request.jerk = Bound::Tool;
  request.jerk_value = 20;
  const auto smooth = std::get<PlannedSegment>(planner.plan(request, *line));
  CHECK(smooth.segment.ahead.window ==
        doctest::Approx(2 * strongest * smooth.segment.ahead.acceleration / 20).epsilon(1e-3));
}

TEST_CASE("an arm's MOVE is measured along the curve of its tool") {
  const RobotModel robot = under_look_ahead("irb120");
  MotionPlanner planner(robot, robot.start);
  const Vector3d from = planner.tool_pose().position;
  MotionRequest request = paced({}, Pace::ToolSpeed, 0.1);
  request.given = 1;  // axis 1 alone, by 60 deg: an arc about the upright axis
  request.target[0] = robot.start[0] + 60 * kDegree;
  const auto planned = std::get<PlannedSegment>(planner.plan(request));
  const double radius = std::hypot(from.x(), from.y());
  CHECK(planned.segment.ahead.length == doctest::Approx(radius * 60 * kDegree).epsilon(1e-6));
  CHECK(planned.segment.ahead.speed == doctest::Approx(0.1).epsilon(1e-6));
}

TEST_CASE("planning a straight motion under the look-ahead law takes no memory") {
  Planned p;
  p.take(to(30, 40));
  const MotionRequest request = jerked(paced(to(60, 80), Pace::ToolSpeed, 0.01), Bound::Tool, 0.5);
  const rob::test::NoAllocation watch;
  const PlanOutcome outcome = p.planner.plan(request);
  CHECK(watch.count() == 0);
  CHECK(std::holds_alternative<PlannedSegment>(outcome));
}
