#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/motion/generate/look_ahead_run.h"

using namespace rob::motion;
using rob::test::LookAheadRun;

namespace {

RobotModel arm_looking_ahead() {
  RobotModel robot = embedded_robot("irb120");
  robot.law = Law::LookAhead;
  return robot;
}

/// An arm's axes, whose references are a mean of σ.
struct ArmAhead : LookAheadRun {
  ArmAhead() : LookAheadRun(arm_looking_ahead()) {}

  /// To so many degrees from the start on its first three axes; `jerk` in deg/s³, 0: the robot's.
  void turn(double first, double second, double third, double jerk = 0) {
    JointVector q = robot().start;
    q.head<3>() += Eigen::Vector3d(first, second, third) * (std::numbers::pi / 180);
    MotionRequest request = rob::test::move_to(q);
    request.zone = MotionRequest::Zone::Length;
    request.zone_value = 0.005;
    if (jerk > 0) {
      request.jerk = MotionRequest::Bound::Rotary;
      request.jerk_value = jerk * (std::numbers::pi / 180);
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
  double last_time() const { return samples().empty() ? 0 : last().time; }
};

}  // namespace

/// What waits for what follows is given up with the rest.
TEST_CASE("braked, an arm stands, and its next path begins there") {
  for (const double instant : {0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8}) {
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
  CHECK(same == alone.samples().size());
}

TEST_CASE("a joint motion alone has no bends: it takes d/v + v/a + a/j") {
  constexpr double kDegree = std::numbers::pi / 180;
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
