#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "motion/generate/corner_miss.h"
#include "motion/robots/time_scaling.h"
#include "tests/motion/generate/arm_run.h"
#include "tests/motion/kinematics/arms.h"

using namespace rob::motion;
using namespace rob::test;
using Eigen::Vector3d;

namespace {

/// What a line to there is refused for, from those joints on.
Refusal refused(const std::string& name, const JointVector& q, const Pose& to,
                const MotionRequest& how = {}) {
  const RobotModel robot = embedded_robot(name);
  MotionPlanner planner(robot, q);
  const auto line = ToolLine::between(planner.tool_pose(), to);
  const PlanOutcome outcome = planner.plan(how, line.value());
  REQUIRE(std::holds_alternative<Refusal>(outcome));
  CHECK(planner.last_number() == 0);
  CHECK((planner.commanded() - q).norm() == 0);
  return std::get<Refusal>(outcome);
}

Pose pose_of(const std::string& name, const JointVector& q) { return arm(name)->forward(q); }

}  // namespace

TEST_CASE("a line that leaves the reach is refused with the place and what is lacking") {
  const auto q =
      arm("lwa4p")->inverse({Vector3d(0.6, 0, 0.205), rotation_by(Vector3d(0, 90 * kDegree, 0))},
                            joints({0, 30, -90, 0, -60, 0}));
  REQUIRE(q.has_value());
  const Pose from = pose_of("lwa4p", *q);
  const Refusal refusal =
      refused("lwa4p", *q, {from.position + Vector3d(0.2, 0, 0), from.orientation}, at(50));
  CHECK(refusal.kind == Refusal::Kind::PathOutOfReach);
  CHECK(refusal.way == doctest::Approx(0.2));
  CHECK(refusal.at == doctest::Approx(0.13).epsilon(1e-3));  // 655 mm + 75 mm − 600 mm
  CHECK(refusal.shortfall.kind == Shortfall::Kind::TooFar);
}

TEST_CASE("a line that leads an axis beyond its limit is refused with the axis and the place") {
  // irb120: the flange turns with axis 6 alone, whose limit is 400 deg, about its own axis.
  const JointVector q = joints({0, 0, 0, 0, 90, 350});
  const Pose from = pose_of("irb120", q);
  const Vector3d along = from.orientation * Vector3d::UnitZ();
  const Refusal refusal = refused(
      "irb120", q, {from.position, rotation_by(along * (100 * kDegree)) * from.orientation});
  CHECK(refusal.kind == Refusal::Kind::PathAboveMaximum);
  CHECK(refusal.axis == 5);
  CHECK(refusal.turning);
  CHECK(refusal.way == doctest::Approx(100 * kDegree));
  CHECK(refusal.at == doctest::Approx(50 * kDegree).epsilon(0.02));
  CHECK(refusal.other);  // 90 deg is the same orientation
}

TEST_CASE("a line close by axis 1 is refused as singular, and so is one by the wrist's place") {
  const auto q = arm("irb120")->inverse(
      {Vector3d(0.2, 0.0005, 0.75), Eigen::Quaterniond::Identity()}, joints({0, 0, 0, 0, 30, 0}));
  REQUIRE(q.has_value());
  const Refusal over =
      refused("irb120", *q, {Vector3d(-0.2, 0.0005, 0.75), Eigen::Quaterniond::Identity()});
  CHECK(over.kind == Refusal::Kind::PathSingular);
  CHECK(over.at == doctest::Approx(0.2).epsilon(1e-3));
  CHECK(arm("irb120")->nearest_singularity(over.q) == SingularPlace::Shoulder);

  // θ5 from 20° to −20°, with θ4 = 0.2° at one end and 0 at the other: it passes θ5 = 0 at some
  // hundredths of a degree, where θ4 has to turn by half a turn.
  const JointVector bent = joints({10, 10, 10, 0, 20, 0});
  const Pose to = pose_of("irb120", joints({10, 10, 10, 0.2, -20, 0}));
  const Refusal wrist = refused("irb120", bent, to, at(100));
  CHECK(wrist.kind == Refusal::Kind::PathSingular);
  CHECK((wrist.axis == 3 || wrist.axis == 5));
  CHECK(arm("irb120")->nearest_singularity(wrist.q) == SingularPlace::Wrist);
}

TEST_CASE(
    "a spline that turns back on itself is not refused: its parameter says nothing of speeds") {
  // 27 mm ahead, 1 mm back: where it turns the tool nearly stands, with the axes far from anything
  // singular. The axes allow any speed of the parameter there, and not 2 % of that elsewhere.
  ArmRun run("irb120");
  const Pose ahead = run.beside(26, 8, 0);
  for (int k = 0; k <= 20; ++k) {  // none stands still exactly, some nearly do
    CAPTURE(k);
    const Pose back = run.beside(25 - 0.05 * k, 7.7 - 0.015 * k, 0);
    const auto curve = ToolSpline::through({run.here(), ahead, back});
    REQUIRE(curve.has_value());
    MotionPlanner planner(run.robot(), run.robot().start);
    CHECK(std::holds_alternative<PlannedSegment>(planner.plan({}, *curve)));
  }
}

TEST_CASE("a line is slowed down to what the axes can do, and says so") {
  // In front of the arm from side to side: axis 1 is the slowest in the middle.
  ArmRun run("lwa4p");
  const RobotModel& robot = run.robot();
  run.line(run.beside(0, -300, 0), at(100));
  const PlannedSegment planned = run.line(run.beside(0, 600, 0), at(5000));
  CHECK((planned.warnings & PlannedSegment::kPaceCut) != 0);
  const SegmentDescriptor& segment = planned.segment;
  REQUIRE(segment.path != nullptr);
  // What S1's ramps and a hold may change of the path's rate, 1/s.
  const double change = 0.75 / robot.t_acc + time_scale_limits(robot).slope;
  double most = 0;  // shares of what the axes can do
  int reason = 0;
  for (int k = 0; k <= 10000; ++k) {
    const PathPoint point = segment.path->at(k / 10000.0);
    for (int i = 0; i < 6; ++i) {
      const Axis& axis = robot.axes[static_cast<std::size_t>(i)];
      const double speed = std::abs(point.qd[i]) / segment.duration;
      const double acceleration =
          std::abs(point.qdd[i]) / (segment.duration * segment.duration) + speed * change;
      if (speed / axis.v_max > most) reason = 2 + i;
      most = std::max(most, speed / axis.v_max);
      if (acceleration / axis.a_max > most) reason = 10 + i;
      most = std::max(most, acceleration / axis.a_max);
    }
  }
  CHECK(most <= 1 + 1e-6);
  CHECK(most > 0.999);
  CHECK(segment.limit == reason);
}

TEST_CASE("ZONE bounds the miss between lines exactly, without a wide bound") {
  for (const double zone : {1.0, 3.0, 20.0}) {
    CAPTURE(zone);
    ArmRun run("irb120");
    const JointVector start = run.robot().start;
    const auto in = run.line(run.beside(0, 150, 0), zoned(at(100), zone));
    const auto out = run.line(run.beside(-150, 0, 0), at(100));
    CHECK(in.warnings == 0);
    CHECK(out.warnings == 0);
    REQUIRE(out.segment.corner != nullptr);
    const double miss = 1000 * corner_miss(*run.robot().kinematics, start, in.segment, out.segment);
    // 3/16·t·|v₂ − v₁|, t at most the robot's 0.3 s
    const double whole = 3.0 / 16 * 300 * 0.1 * std::sqrt(2);
    CHECK(miss == doctest::Approx(std::min(zone, whole)).epsilon(1e-3));
  }
}

TEST_CASE("a corner that no time within its ZONE allows is exact, with a warning") {
  ArmRun run("irb120");
  run.line(run.beside(0, 150, 0), zoned(at(400), 0.01));
  const auto out = run.line(run.beside(-150, 0, 0), at(400));
  CHECK((out.warnings & PlannedSegment::kCornerExact) != 0);
  CHECK(out.segment.from_rest);
  CHECK(out.segment.corner == nullptr);
}

TEST_CASE("AT an angular speed bounds how fast the tool turns on a line") {
  ArmRun run("irb120");
  MotionRequest how;
  how.pace = MotionRequest::Pace::AngularSpeed;
  how.pace_value = 10 * kDegree;
  const auto planned = run.line(run.beside(0, 50, 0, Vector3d(0, 0, 40 * kDegree)), how);
  CHECK(planned.segment.duration == doctest::Approx(4));
}

TEST_CASE("a line to where the tool is has no length") {
  ArmRun run("irb120");
  run.line(run.beside(0, 50, 0), at(100));
  CHECK(run.line(run.here(), at(100)).segment.no_length);
}

TEST_CASE("what a planner has made is kept while a buffer's worth of motions follows") {
  ArmRun run("irb120");
  const auto line = ToolLine::between(run.here(), run.beside(0, 20, 0));
  auto first = std::get<PlannedSegment>(run.planner().plan(at(100), line.value()));
  const std::weak_ptr<const PlannedLeg> leg = first.leg;
  first.leg.reset();
  for (int i = 0; i < run.robot().look_ahead + 2; ++i) {
    const auto next = ToolLine::between(run.here(), run.beside(0, i % 2 == 0 ? 20 : -20, 0));
    CHECK(std::holds_alternative<PlannedSegment>(run.planner().plan(at(100), next.value())));
    CHECK_FALSE(leg.expired());
  }
}

TEST_CASE("a profile takes what the axes' speed and acceleration allow, a hold's share apart") {
  const RobotModel robot = embedded_robot("gantry");
  const double v = 0.02;  // m/s of x, 0.1 m/s² at most
  const double a = 0.1 - time_scale_limits(robot).slope * v;
  for (const auto& [profile, factor] :
       {std::pair{Profile::Rectangular, 1.0}, std::pair{Profile::Trapezoidal, 4.0 / 3},
        std::pair{Profile::Parabolic, 1.5}, std::pair{Profile::Cosine, 2.0}}) {
    const Profile shape = profile;
    const double k = factor;
    CAPTURE(k);
    const auto duration = [&](double x_mm, MotionRequest how) {
      MotionPlanner planner(robot, robot.start);
      how.given = 1;
      how.target[0] = x_mm / 1000;
      return std::get<PlannedSegment>(planner.plan(profiled(how, shape))).segment.duration;
    };
    CHECK(duration(100, {}) == doctest::Approx(0.1 / v + k * v / a));
    CHECK(duration(1, {}) == doctest::Approx(2 * std::sqrt(0.001 * k / a)));
    CHECK(duration(100, at(10)) == doctest::Approx(0.1 / 0.01 + k * 0.01 / a));
    MotionRequest slow;
    slow.at_least = 12;
    CHECK(duration(100, slow) == doctest::Approx(12));
    MotionPlanner planner(robot, robot.start);
    MotionRequest hasty = profiled({}, shape);
    hasty.given = 1;
    hasty.target[0] = 0.1;
    hasty.at_least = 1;
    const auto planned = std::get<PlannedSegment>(planner.plan(hasty));
    CHECK(planned.segment.duration == doctest::Approx(0.1 / v + k * v / a));
    CHECK((planned.warnings & PlannedSegment::kStretched) != 0);
    CHECK_FALSE(planner.stop(0).has_value());  // it ends at rest by itself
    hasty.relative = true;
    hasty.pace = MotionRequest::Pace::ToolSpeed;
    hasty.pace_value = 0.01;
    hasty.at_least = 8;  // the axes could; AT asks for 10 s and more, and the slower wins
    const auto paced = std::get<PlannedSegment>(planner.plan(hasty));
    CHECK(paced.segment.duration == doctest::Approx(0.1 / 0.01 + k * 0.01 / a));
    CHECK(paced.warnings == 0);
  }
}
