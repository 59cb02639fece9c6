#include <doctest/doctest.h>

#include <array>
#include <cmath>

#include "motion/robots/time_scaling.h"
#include "tests/motion/generate/distance.h"
#include "tests/motion/generate/gantry_run.h"
#include "tests/motion/generate/superposition.h"

using namespace rob::motion;
using namespace rob::test;
using Kind = MotionEvent::Kind;
using rob::test::distance;

namespace {

/// To and fro at full speed, turning as often as the law allows: the most that Paul's corners ask.
/// Returns the path by a second computation.
Superposition give_zigzag(GantryRun& run, int moves) {
  Superposition law(run.robot().start, run.robot().t_acc);
  const double t1 = 2 * run.robot().t_acc;
  const double way = 20 * t1;  // mm and deg
  JointVector target = run.robot().start;
  for (int n = 0; n < moves; ++n) {
    target = n % 2 == 0 ? gantry_q(way, way, way) : gantry_q(0, n % 4 == 1 ? 0 : way, 0);
    run.move(move_to(target));
    law.add(target, t1);
  }
  run.stop();
  law.add(target, t1);
  run.close();
  return law;
}

/// Every reference lies on the path, at the time that the sample tells.
void check_on_path(const GantryRun& run, const Superposition& law) {
  double worst = 0;
  double worst_rate = 0;
  for (const GeneratorSample& sample : run.samples()) {
    if (sample.state == MotionState::Idle || sample.piece == 0) continue;
    const double t = law.via(sample.piece) + sample.sigma;
    worst = std::max(worst, distance(sample.reference.q, law.q(t)));
    worst_rate = std::max(worst_rate, distance(sample.reference.qd, law.qd(t) * sample.rate));
    REQUIRE(sample.rate >= -1e-15);
    REQUIRE(sample.rate <= 1 + 1e-15);
  }
  CHECK(worst < 1e-11);
  CHECK(worst_rate < 1e-11);
}

/// Differences of the positions alone: each is a mean of the derivative over its span, so it
/// cannot be greater than the derivative's bound.
void check_differences(const GantryRun& run) {
  const double t = run.robot().reference_period;
  const auto q = [&](std::size_t k, int i) { return run.samples()[k].reference.q[i]; };
  for (int i = 0; i < 3; ++i) {
    const Axis& axis = run.robot().axes[static_cast<std::size_t>(i)];
    double speed = 0, acceleration = 0, jerk = 0;
    for (std::size_t k = 3; k < run.samples().size(); ++k) {
      const double d1 = q(k, i) - q(k - 1, i);
      const double d2 = q(k, i) - 2 * q(k - 1, i) + q(k - 2, i);
      const double d3 = q(k, i) - 3 * q(k - 1, i) + 3 * q(k - 2, i) - q(k - 3, i);
      speed = std::max(speed, std::abs(d1) / t);
      acceleration = std::max(acceleration, std::abs(d2) / (t * t));
      jerk = std::max(jerk, std::abs(d3) / (t * t * t));
    }
    CHECK(speed <= axis.v_max * (1 + 1e-9));
    CHECK(acceleration <= axis.a_max * (1 + 1e-6));
    CHECK(jerk <= axis.j_max * (1 + 1e-6));
  }
}

/// The rates handed out belong to the positions: the trapezium rule's error is T³/12 times the
/// jerk for positions, and at most T²/4 times it for speeds.
void check_rates(const GantryRun& run) {
  const double t = run.robot().reference_period;
  for (std::size_t k = 1; k < run.samples().size(); ++k) {
    const JointReference& a = run.samples()[k - 1].reference;
    const JointReference& b = run.samples()[k].reference;
    for (int i = 0; i < 3; ++i) {
      const double jerk = run.robot().axes[static_cast<std::size_t>(i)].j_max;
      REQUIRE(std::abs(b.q[i] - a.q[i] - (a.qd[i] + b.qd[i]) * t / 2) <= jerk * t * t * t / 12);
      REQUIRE(std::abs(b.qd[i] - a.qd[i] - (a.qdd[i] + b.qdd[i]) * t / 2) <= jerk * t * t / 4);
    }
  }
}

/// A robot whose corners leave little of its acceleration and jerk for a hold.
RobotModel tight_gantry() {
  RobotModel robot = embedded_robot("gantry");
  for (Axis& axis : robot.axes) {
    axis.a_max = 1.2 * 1.5 * axis.v_max / robot.t_acc;
    axis.j_max = 3 * 3 * axis.v_max / (robot.t_acc * robot.t_acc);
  }
  return robot;
}

}  // namespace

TEST_CASE("hold, resume and override at random instants keep to the path and to every limit") {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    for (const RobotModel& robot : {embedded_robot("gantry"), tight_gantry()}) {
      CAPTURE(seed);
      GantryRun run(robot);
      const Superposition law = give_zigzag(run, 12);
      RandomTargets random(run.robot(), seed);
      while (!run.saw(Kind::Finished) && run.period() < 100'000) {
        const int what = random.pick(0, 99);
        if (what < 2) run.generator().hold();
        if (what >= 2 && what < 6) run.generator().resume();
        if (what == 6) run.generator().set_override(0.05 + 0.95 * random.share());
        if (what == 7) run.generator().set_override(1);
        run.step();
      }
      REQUIRE(run.saw(Kind::Finished));
      CHECK(run.samples().back().reference.q == run.planner().commanded());
      CHECK_FALSE(run.saw(Kind::LateDecision));
      check_on_path(run, law);
      check_differences(run);
      check_rates(run);
    }
  }
}

TEST_CASE("a hold stands within the robot's stopping time, and says when") {
  GantryRun run;
  give_published_program(run);
  while (run.period() < 500) run.step();
  run.generator().hold();
  run.step();
  CHECK(run.samples().back().state == MotionState::Stopping);
  while (!run.saw(Kind::Held) && run.period() < 1000) run.step();
  // r falls as fast as the axes allow: 5 − 1.5/1.375 = 3.909 a second at most (a_max/v_max = 5/s),
  // bent by 50 − 3/1.375² − 4.5·3.909/1.375 = 35.62 a second² at most: 1/3.909 + 3.909/35.62 s.
  const auto held = run.all(Kind::Held);
  REQUIRE(held.size() == 1);
  CHECK(held[0].time == doctest::Approx(5.0 + 0.3655).epsilon(1e-4));
  CHECK(held[0].value > 0);
  CHECK(held[0].value < 1);
  CHECK(run.samples().back().state == MotionState::Held);
}

TEST_CASE("held axes do not move by a single bit") {
  GantryRun run;
  give_published_program(run);
  while (run.period() < 500) run.step();
  run.generator().hold();
  while (run.period() < 560) run.step();
  const JointVector q = run.samples().back().reference.q;
  while (run.period() < 900) {
    const GeneratorSample& sample = run.step();
    REQUIRE(sample.reference.q == q);
    REQUIRE(sample.reference.qd == gantry_q(0, 0, 0));
    REQUIRE(sample.reference.qdd == gantry_q(0, 0, 0));
  }
}

TEST_CASE("a hold of the whole program only shifts its end") {
  GantryRun run;
  give_published_program(run);
  while (run.period() < 500) run.step();
  run.generator().hold();
  while (run.period() < 700) run.step();
  run.generator().resume();
  run.finish();
  // The ramps lose half of their time each; the resume begins one period after it is asked for.
  const double lost = 2.0 + 0.01;
  CHECK(run.all(Kind::Finished)[0].time == doctest::Approx(19.10 + lost).epsilon(1e-9));
  CHECK(run.samples().back().reference.q == gantry_q(40, 40, 0));
}

TEST_CASE("half the override takes twice the time") {
  GantryRun run;
  run.generator().set_override(0.5);
  give_published_program(run);
  run.finish();
  CHECK(run.all(Kind::Finished)[0].time == doctest::Approx(2 * 19.10).epsilon(1e-9));
  CHECK(run.samples()[1000].rate == 0.5);
  CHECK(run.samples()[1000].limit == 21);
}

TEST_CASE("an override that is no share of the speed changes nothing") {
  GantryRun run;
  for (const double share : {0.0, -1.0, std::nan("")}) run.generator().set_override(share);
  run.generator().set_override(3.0);
  give_published_program(run);
  run.finish();
  CHECK(run.all(Kind::Finished)[0].time == doctest::Approx(19.10).epsilon(1e-12));
}

TEST_CASE("at rest a hold is there at once, and nothing starts until it is lifted") {
  GantryRun run;
  run.step();
  run.generator().hold();
  run.move(40, 0, 0);
  for (int i = 0; i < 100; ++i) run.step();
  CHECK(run.all(Kind::Held).size() == 1);
  CHECK(run.samples().back().state == MotionState::Held);
  CHECK_FALSE(run.saw(Kind::SegmentStarted));
  run.generator().resume();
  run.step();
  REQUIRE(run.saw(Kind::SegmentStarted));
  CHECK(run.all(Kind::SegmentStarted)[0].time == doctest::Approx(1.01));
}

TEST_CASE("a decision point that a hold has postponed is announced before it is needed") {
  GantryRun run;
  run.move(40, 40, 0);  // decides at 2.75 s
  while (run.period() < 256) run.step();
  run.generator().hold();  // takes 0.1827 s of path: it stands at 2.7427 s, half a period before
  for (int i = 0; i < 200; ++i) run.step();
  CHECK(run.generator().decidable() == 0);
  run.generator().resume();
  while (run.generator().decidable() == 0 && run.period() < 1000) run.step();
  run.move(140, 40, 0);
  run.stop();
  run.close();
  run.finish();
  CHECK(run.generator().late_decisions() == 0);
  CHECK(run.all(Kind::SegmentStarted).size() == 3);
}

TEST_CASE("exact instants are found while time is scaled") {
  GantryRun run;
  give_published_program(run);
  while (run.period() < 268) run.step();
  run.generator().hold();  // at 2.68 s: 0.07 s of path before the corner of line 1 begins
  while (!run.saw(Kind::Held)) run.step();
  const auto started = run.all(Kind::SegmentStarted);
  REQUIRE(started.size() == 2);
  // r falls with r'' = −35.62: 0.07 = s − 35.62·s³/6, solved by hand (s = 0.0722 s).
  CHECK(started[1].time == doctest::Approx(2.68 + 0.0722).epsilon(1e-4));
}
