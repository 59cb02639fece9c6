#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "motion/path/tool_line.h"
#include "motion/space/rotation.h"
#include "tests/motion/generate/look_ahead_run.h"
#include "tests/support/degrees.h"
#include "tests/support/some_of.h"

using namespace rob::motion;
using rob::test::kDegree;
using rob::test::LookAheadRun;

namespace {

RobotModel arm_looking_ahead(const char* name) {
  RobotModel robot = embedded_robot(name);
  robot.law = Law::LookAhead;
  return robot;
}

/// An arm's axes, whose references are a mean of σ.
struct ArmAhead : LookAheadRun {
  explicit ArmAhead(const char* name = "irb120") : LookAheadRun(arm_looking_ahead(name)) {}

  /// To so many degrees from the start on its first three axes; `jerk` in deg/s³, 0: the robot's.
  void turn(double first, double second, double third, double jerk = 0) {
    JointVector q = robot().start;
    q.head<3>() += Eigen::Vector3d(first, second, third) * kDegree;
    MotionRequest request = rob::test::move_to(q);
    request.zone = MotionRequest::Zone::Length;
    request.zone_value = 0.005;
    if (jerk > 0) {
      request.jerk = MotionRequest::Bound::Rotary;
      request.jerk_value = jerk * kDegree;
    }
    push(std::get<PlannedSegment>(planner().plan(request)).segment);
  }
  /// So many motions of a zigzag.
  void comb(int teeth, double jerk = 0) {
    for (int i = 1; i <= teeth; ++i) turn(2.0 * i, i % 2 == 0 ? 0 : 4, i % 3, jerk);
  }
  /// One without end, until then.
  void comb_until(double time) {
    for (int i = 1; last_time() < time; step()) {
      for (; buffer().room() > 1; ++i) turn(10.0 * (i % 3), i % 2 == 0 ? 0 : 4, i % 5);
    }
  }
  /// A line of the tool, so many mm on.
  void line(double x_mm, double y_mm, const MotionRequest& how) {
    Pose to = planner().tool_pose();
    to.position += Eigen::Vector3d(x_mm, y_mm, 0) / 1000;
    const auto path = ToolLine::between(planner().tool_pose(), to).value();
    push(std::get<PlannedSegment>(planner().plan(how, path)).segment);
  }
  /// The greatest third difference of an axis, as a share of its j_max.
  double third_difference() const {
    double most = 0;
    for (std::size_t k = 3; k < samples().size(); ++k) {
      const auto q = [&](std::size_t back) { return samples()[k - back].reference.q; };
      const double T = robot().reference_period;
      const JointVector jerk = (q(0) - 3 * q(1) + 3 * q(2) - q(3)) / (T * T * T);
      for (int i = 0; i < jerk.size(); ++i)
        most = std::max(most, std::abs(jerk[i]) / robot().axes[static_cast<std::size_t>(i)].j_max);
    }
    return most;
  }
  double last_time() const { return samples().empty() ? 0 : last().time; }
};

}  // namespace

/// What waits for what follows is given up with the rest.
TEST_CASE("braked, an arm stands, and its next path begins there") {
  for (const double instant : rob::test::some_of(0.3, 0.1, 0.2, 0.4, 0.5, 0.6, 0.7, 0.8)) {
    ArmAhead run;
    run.comb_until(instant);
    run.generator().brake();
    for (int i = 0; i < 1000 && run.rests().empty(); ++i) run.step();
    REQUIRE(run.rests().size() == 1);
    run.step();  // what is behind is dropped
    CHECK(run.last().q == run.rests()[0].q);
    run.planner().retarget(run.rests()[0].q);
    run.comb(3);
    run.stop();
    run.close();
    run.finish();
    CAPTURE(instant);
    const auto peak = run.peak();
    CHECK(peak.speed <= 1.0001);
    CHECK(peak.acceleration <= 1.03);
  }
}

TEST_CASE("a run of an arm is the same, whatever mean the run behind its stop has") {
  ArmAhead alone;
  alone.comb(6, 2000);
  alone.stop();
  alone.close();
  alone.finish();
  ArmAhead followed;
  followed.comb(6, 2000);
  followed.stop();
  followed.comb(3);
  followed.stop();
  followed.close();
  followed.finish();
  REQUIRE(followed.samples().size() > alone.samples().size());
  std::size_t same = 0;
  while (same < alone.samples().size() &&
         alone.samples()[same].reference.q == followed.samples()[same].reference.q)
    ++same;
  // Where it stands is the target, or where the last of its pieces ends: but for rounding the same.
  const std::size_t last = alone.samples().size() - 1;
  REQUIRE(same >= last);
  const JointVector ends = alone.samples()[last].reference.q;
  CHECK((ends - followed.samples()[last].reference.q).cwiseAbs().maxCoeff() <= 1e-15);
}

TEST_CASE("a joint motion alone has no bends: it takes d/v + v/a + a/j") {
  ArmAhead run;
  run.turn(60, 0, 0);
  run.close();
  run.finish();
  const RobotModel& robot = run.robot();
  double mean = 0;
  for (const Axis& axis : robot.axes) mean = std::max(mean, axis.a_max / axis.j_max);
  const double period = robot.reference_period;
  mean = std::ceil(mean / period) * period;
  const Axis& first = robot.axes[0];
  const double time = 60 * kDegree / first.v_max + first.v_max / first.a_max + mean;
  const double finished = run.all(MotionEvent::Kind::Finished).at(0).time;
  CHECK(finished == doctest::Approx(time - period).epsilon(1e-6));  // a mean of samples
  const auto peak = run.peak();
  CHECK(peak.speed <= 1 + 1e-6);
  CHECK(peak.acceleration <= 1 + 1e-6);
  CHECK(peak.jerk <= 1 + 1e-6);
}

TEST_CASE("a tool that turns on a short way does not slow the line behind it: it stands between") {
  const auto takes = [](double way_mm, bool stops) {
    ArmAhead run;
    MotionRequest how;
    how.zone = MotionRequest::Zone::Length;
    how.zone_value = 0.001;
    const Pose from = run.planner().tool_pose();
    const Pose turned{from.position + Eigen::Vector3d(way_mm / 1000, 0, 0),
                      from.orientation * rotation_by(Eigen::Vector3d(0, 0, 80 * kDegree))};
    const ToolLine line = ToolLine::between(from, turned).value();
    run.push(std::get<PlannedSegment>(run.planner().plan(how, line)).segment);
    if (stops) run.stop();
    run.line(0, 50, how);
    run.close();
    run.finish();
    CHECK(run.third_difference() <= 1 + 1e-6);
    return run.last_time();
  };
  for (const double way_mm : {0.001, 0.1, 1.0, 10.0}) {
    CAPTURE(way_mm);
    CHECK(takes(way_mm, false) <= 1.1 * takes(way_mm, true));
  }
}

// At 4 mm/s the axes could take a corner of 45 degrees within a micrometre, as a leap of their
// speeds from one reference to the next.
TEST_CASE("corners of slow short lines keep the jerk of an arm's axes") {
  ArmAhead run("lwa4p");
  MotionRequest how;
  how.pace = MotionRequest::Pace::ToolSpeed;
  how.pace_value = 0.004;
  for (const double zone : {0.01, 1e-6}) {
    how.zone = MotionRequest::Zone::Length;
    how.zone_value = zone;
    for (int i = 0; i < 16; ++i) {
      const double angle = i * std::numbers::pi / 4;
      run.line(0.8 * std::cos(angle), 0.8 * std::sin(angle), how);
      run.step();
    }
  }
  run.stop();
  run.close();
  run.finish();
  CHECK(run.third_difference() <= 1.01);
}

// What was published has the bounds of all that was within reach at the speeds of that time: those
// of twice the speed are not looked for again.
TEST_CASE("an override raised over a path that is known keeps what an arm's axes can do") {
  for (const double pace : rob::test::some_of(0.04, 0.01, 0.08)) {
    for (const double jerk : {0.0, 1000.0}) {
      ArmAhead run("lwa4p");
      MotionRequest how;
      how.pace = MotionRequest::Pace::ToolSpeed;
      how.pace_value = pace;
      how.zone = MotionRequest::Zone::Length;
      how.zone_value = 0.005;
      if (jerk > 0) {
        how.jerk = MotionRequest::Bound::Rotary;
        how.jerk_value = jerk * kDegree;
      }
      for (int i = 0; i < 12; ++i) run.line(i % 2 == 0 ? 25 : -20, i % 2 == 0 ? 20 : -27, how);
      run.stop();
      run.close();
      for (int i = 0; run.last_time() < 0.2; ++i) run.step();
      run.generator().set_override(2);
      run.finish();
      const auto peak = run.peak();
      CAPTURE(pace);
      CAPTURE(jerk);
      CHECK(peak.speed <= 1.0001);
      CHECK(peak.acceleration <= 1.02);
      CHECK(peak.jerk <= 1.02);
      CHECK(run.third_difference() <= 1.02);
    }
  }
}
