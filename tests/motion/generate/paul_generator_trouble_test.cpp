#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "tests/motion/generate/distance.h"
#include "tests/motion/generate/gantry_run.h"
#include "tests/motion/generate/superposition.h"

using namespace rob::motion;
using namespace rob::test;
using Kind = MotionEvent::Kind;
using rob::test::distance;

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

bool finite(const JointReference& reference) {
  return reference.q.allFinite() && reference.qd.allFinite() && reference.qdd.allFinite();
}

/// The first motion is under way when the second, which is wrong, is given.
void check_refused_on_the_way(const SegmentDescriptor& wrong, int axis) {
  GantryRun run;
  run.move(40, 20, 0, 1);
  run.push(wrong);
  while (run.period() < 600) {
    run.step();
    REQUIRE(finite(run.samples().back().reference));
  }
  const auto faults = run.all(Kind::Fault);
  REQUIRE(faults.size() == 1);
  CHECK(faults[0].axis == axis);
  CHECK(faults[0].tag == wrong.tag);
  CHECK(faults[0].time == doctest::Approx(2.75));
  CHECK(run.samples().back().reference.q == gantry_q(40, 20, 0));
  CHECK(run.samples().back().state == MotionState::Held);
  CHECK(run.all(Kind::Held).size() == 1);
  CHECK_FALSE(run.saw(Kind::LateDecision));
}

}  // namespace

TEST_CASE("with nothing known at the decision instant the axes arrive at the target and stand") {
  GantryRun run;
  run.move(100, 60, 20, 3);  // 5 s; decides at 5 s, stands at 7.75 s
  while (run.period() < 800) run.step();
  Superposition law(run.robot().start, 1.375);
  law.add(gantry_q(100, 60, 20), 5.0);
  law.add(gantry_q(100, 60, 20), 2.75);
  for (const GeneratorSample& sample : run.samples())
    CHECK(distance(sample.reference.q, law.q(sample.reference.time)) < 1e-12);
  const auto late = run.all(Kind::LateDecision);
  REQUIRE(late.size() == 1);
  CHECK(late[0].time == doctest::Approx(5.0).epsilon(1e-12));
  CHECK(late[0].tag == 3);
  CHECK(run.generator().late_decisions() == 1);
  CHECK(run.samples()[600].limit == 20);  // the end of the buffer holds the speed
  CHECK(run.samples()[600].tag == 3);
  CHECK(run.samples().back().reference.q == gantry_q(100, 60, 20));
  CHECK(run.samples().back().state == MotionState::Idle);
  CHECK_FALSE(run.saw(Kind::Finished));
}

TEST_CASE("what comes during a late stop follows at the stop's end, without a jerk") {
  GantryRun run;
  run.move(40, 0, 0, 1);
  while (run.period() < 400) run.step();
  run.move(40, 40, 0, 2);
  run.stop(3);
  run.close();
  run.finish();
  const auto started = run.all(Kind::SegmentStarted);
  REQUIRE(started.size() == 3);
  CHECK(started[1].time == doctest::Approx(5.5).epsilon(1e-12));
  CHECK(run.all(Kind::Finished)[0].time == doctest::Approx(11.0).epsilon(1e-12));
  // Greatest change of acceleration a period: jerk 1.5·Δv/t_acc², Δv = 40 mm / 2.75 s.
  const double jerk = 1.5 * (0.040 / 2.75) / (1.375 * 1.375);
  for (std::size_t k = 1; k < run.samples().size(); ++k)
    CHECK(distance(run.samples()[k].reference.qdd, run.samples()[k - 1].reference.qdd) <=
          jerk * 0.01 * (1 + 1e-9));
}

TEST_CASE("a closed buffer that runs dry stops without calling it late") {
  GantryRun run;
  run.move(40, 0, 0);
  run.close();
  run.finish();
  CHECK_FALSE(run.saw(Kind::LateDecision));
  CHECK(run.all(Kind::Finished)[0].time == doctest::Approx(5.5).epsilon(1e-12));
}

TEST_CASE("twenty missed periods are made up, one more is an overrun") {
  for (const std::int64_t missed : {20, 21}) {
    CAPTURE(missed);
    GantryRun run;
    give_published_program(run);
    while (run.period() < 400) run.step();
    run.advance(401 + missed);
    CHECK(run.saw(Kind::Overrun) == (missed == 21));
  }
}

TEST_CASE("with short periods 200 ms are made up") {
  RobotModel robot = embedded_robot("gantry");
  robot.reference_period = 0.001;
  for (const std::int64_t missed : {200, 201}) {
    CAPTURE(missed);
    GantryRun run(robot);
    give_published_program(run);
    run.step();
    run.advance(1 + missed);
    CHECK(run.saw(Kind::Overrun) == (missed == 201));
  }
}

TEST_CASE("after an overrun the axes go on from the last reference, come to rest and can resume") {
  GantryRun run;
  give_published_program(run);
  while (run.period() < 400) run.step();
  const JointReference last = run.samples().back().reference;
  const auto& next = run.advance(500);  // 99 periods missing
  // One period on, not a hundred: the way of one period at full speed, at most.
  CHECK(distance(next.reference.q, last.q) <= 0.020 * 0.01);
  CHECK(distance(next.reference.q, last.q) > 0);
  CHECK(next.reference.time == 500 * 0.01);
  const auto overruns = run.all(Kind::Overrun);
  REQUIRE(overruns.size() == 1);
  CHECK(overruns[0].value == doctest::Approx(0.99));

  while (run.period() < 600) run.step();
  CHECK(run.samples().back().state == MotionState::Held);
  CHECK(run.samples().back().reference.qd == gantry_q(0, 0, 0));
  CHECK(run.all(Kind::Held).size() == 1);

  run.generator().resume();
  run.finish();
  CHECK(run.saw(Kind::Finished));
  CHECK(run.samples().back().reference.q == gantry_q(40, 40, 0));
}

TEST_CASE("a period that has been computed already changes nothing") {
  GantryRun run;
  give_published_program(run);
  run.advance(10);
  const GeneratorSample sample = run.generator().advance(10);
  CHECK(sample.reference.time == 10 * 0.01);
  CHECK(run.generator().advance(4).reference.time == 10 * 0.01);
  CHECK(run.generator().advance(11).reference.time == 11 * 0.01);
}

TEST_CASE("a target that is no number is never begun: the axes arrive at the one before") {
  check_refused_on_the_way({2, 2, gantry_q(0, kNaN, 0), 2.75, 1.375, false, 0}, 1);
  check_refused_on_the_way({2, 2, gantry_q(0, 0, INFINITY), 2.75, 1.375, false, 0}, 2);
  check_refused_on_the_way({2, 2, gantry_q(80, 0, 0), 0, 1.375, false, 0}, 0);
  check_refused_on_the_way({2, 2, gantry_q(80, 0, 0), kNaN, 1.375, false, 0}, 0);
  check_refused_on_the_way({2, 2, gantry_q(80, 0, 0), 2.75, kNaN, false, 0}, 0);
  check_refused_on_the_way({2, 2, gantry_q(80, 0, 0), INFINITY, 1.375, false, 0}, 0);
}

TEST_CASE("a reference that is no number is not handed out: the last one is held") {
  GantryRun run;
  run.push({1, 1, gantry_q(40, 20, 0), 2.75, 1.375, false, 0});
  // Its speed is 1.5e308 m/s, still a number; 1.375 s of it are none.
  JointVector far = gantry_q(0, 0, 0);
  far[1] = 1.5e305;
  run.push({2, 2, far, 1e-3, 1.375, false, 0});
  JointVector before = run.robot().start;
  while (!run.saw(Kind::Fault) && run.period() < 1000) {
    before = run.step().reference.q;
    REQUIRE(finite(run.samples().back().reference));
  }
  REQUIRE(run.saw(Kind::Fault));
  CHECK(run.all(Kind::Fault)[0].axis == 1);
  for (int i = 0; i < 100; ++i) run.step();
  CHECK(run.samples().back().reference.q == before);
  CHECK(run.samples().back().state == MotionState::Held);
}
