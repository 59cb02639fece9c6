#include "motion/generate/paul_generator.h"

#include <doctest/doctest.h>

#include <cmath>
#include <stdexcept>

#include "tests/motion/generate/distance.h"
#include "tests/motion/generate/gantry_run.h"
#include "tests/motion/generate/superposition.h"
#include "tests/support/no_allocation.h"

using namespace rob::motion;
using namespace rob::test;
using Kind = MotionEvent::Kind;
using rob::test::distance;

namespace {

bool same_bits(const GeneratorSample& a, const GeneratorSample& b) {
  return a.reference.time == b.reference.time && a.reference.q == b.reference.q &&
         a.reference.qd == b.reference.qd && a.reference.qdd == b.reference.qdd && a.tag == b.tag &&
         a.piece == b.piece && a.sigma == b.sigma && a.rate == b.rate && a.state == b.state &&
         a.limit == b.limit;
}

/// A random program, given to the planner and to the second computation of S1's law.
Superposition give_random_program(GantryRun& run, unsigned seed, int moves) {
  const RobotModel& robot = run.robot();
  RandomTargets targets(robot, seed);
  Superposition law(robot.start, robot.t_acc);
  JointVector last = robot.start;
  for (int n = 0; n < moves; ++n) {
    const JointVector target = targets.next();
    MotionRequest request = move_to(target, static_cast<Tag>(n + 1));
    double t1 = 2 * robot.t_acc;
    for (int i = 0; i < 3; ++i)
      t1 = std::max(t1,
                    std::abs(target[i] - last[i]) / robot.axes[static_cast<std::size_t>(i)].v_max);
    if (targets.pick(0, 3) == 0) {
      request.at_least = 10 * targets.share();
      t1 = std::max(t1, request.at_least);
    }
    run.move(request);
    law.add(target, t1);
    last = target;
  }
  run.stop();
  law.add(last, 2 * robot.t_acc);
  run.close();
  return law;
}

}  // namespace

TEST_CASE("the published gantry program lasts 19.10 s, in 1910 cycles") {
  GantryRun run;
  give_published_program(run);
  run.finish();
  const auto finished = run.all(Kind::Finished);
  REQUIRE(finished.size() == 1);
  CHECK(finished[0].time == doctest::Approx(19.10).epsilon(1e-12));
  CHECK(run.samples().size() == 1911);  // t = 0 and 1910 cycles
  CHECK(run.samples().back().state == MotionState::Idle);
  CHECK(run.samples().back().reference.q == gantry_q(40, 40, 0));
  CHECK(run.samples().back().reference.qd == gantry_q(0, 0, 0));
  CHECK(run.generator().late_decisions() == 0);
}

TEST_CASE("the lines of the published program start at 0, 2.75, 7.75, 12.05 and 16.35 s") {
  GantryRun run;
  give_published_program(run);
  run.finish();
  const double starts[] = {0, 2.75, 7.75, 12.05, 16.35};
  const auto started = run.all(Kind::SegmentStarted);
  REQUIRE(started.size() == 5);
  for (std::size_t i = 0; i < 5; ++i) {
    CHECK(started[i].time == doctest::Approx(starts[i]).epsilon(1e-12));
    CHECK(started[i].tag == i + 1);
    CHECK(started[i].number == i + 1);
  }
}

TEST_CASE("every reference of the published program is S1's, by a second computation") {
  GantryRun run;
  give_published_program(run);
  run.finish();
  Superposition law(gantry_q(0, 0, 0), 1.375);
  law.add(gantry_q(40, 40, 0), 2.75);
  law.add(gantry_q(140, 40, 0), 5.0);
  law.add(gantry_q(90, 126, 0), 4.3);
  law.add(gantry_q(40, 40, 0), 4.3);
  law.add(gantry_q(40, 40, 0), 2.75);
  for (const GeneratorSample& sample : run.samples()) {
    const double t = sample.reference.time;
    CHECK(distance(sample.reference.q, law.q(t)) < 1e-12);
    CHECK(distance(sample.reference.qd, law.qd(t)) < 1e-12);
    CHECK(distance(sample.reference.qdd, law.qdd(t)) < 1e-12);
  }
}

TEST_CASE("random programs run as a second computation of S1's law says") {
  for (unsigned seed = 1; seed <= 40; ++seed) {
    CAPTURE(seed);
    GantryRun run;
    const Superposition law = give_random_program(run, seed, 12);
    run.finish();
    const auto finished = run.all(Kind::Finished);
    REQUIRE(finished.size() == 1);
    const bool stopped = run.planner().last_number() == 13;  // else the last move was exact
    const double total = law.total() - (stopped ? 0 : 2 * run.robot().t_acc);
    CHECK(finished[0].time == doctest::Approx(total).epsilon(1e-12));
    double worst = 0;
    double worst_rate = 0;
    double worst_change = 0;
    for (const GeneratorSample& sample : run.samples()) {
      const double t = sample.reference.time;
      worst = std::max(worst, distance(sample.reference.q, law.q(t)));
      worst_rate = std::max(worst_rate, distance(sample.reference.qd, law.qd(t)));
      worst_change = std::max(worst_change, distance(sample.reference.qdd, law.qdd(t)));
    }
    CHECK(worst < 1e-9);
    CHECK(worst_rate < 1e-9);
    CHECK(worst_change < 1e-8);
    const auto started = run.all(Kind::SegmentStarted);
    for (const MotionEvent& event : started)
      CHECK(event.time == doctest::Approx(law.begin(event.number)).epsilon(1e-12));
  }
}

TEST_CASE("no reference leaves the limits of position, speed and acceleration") {
  for (unsigned seed = 100; seed < 130; ++seed) {
    CAPTURE(seed);
    GantryRun run;
    give_random_program(run, seed, 12);
    run.finish();
    for (int i = 0; i < 3; ++i) {
      const Axis& axis = run.robot().axes[static_cast<std::size_t>(i)];
      double low = 0, high = 0, speed = 0, change = 0;
      for (const GeneratorSample& sample : run.samples()) {
        low = std::min(low, sample.reference.q[i]);
        high = std::max(high, sample.reference.q[i]);
        speed = std::max(speed, std::abs(sample.reference.qd[i]));
        change = std::max(change, std::abs(sample.reference.qdd[i]));
      }
      CHECK(low >= axis.min - 1e-15);
      CHECK(high <= axis.max + 1e-15);
      CHECK(speed <= axis.v_max * (1 + 1e-12));
      CHECK(change <= 1.5 * axis.v_max / run.robot().t_acc * (1 + 1e-12));
    }
  }
}

TEST_CASE("a late tick hands out the same bits as one in time") {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    CAPTURE(seed);
    GantryRun in_time;
    give_random_program(in_time, seed, 10);
    in_time.finish();

    GantryRun late;
    give_random_program(late, seed, 10);
    std::mt19937 random(seed);
    std::uniform_int_distribution<> skip(0, 20);
    const std::int64_t last = in_time.period();
    int differ = 0;
    while (late.period() < last) {
      const auto& sample = late.advance(std::min(last, late.period() + 1 + skip(random)));
      if (!same_bits(sample, in_time.samples()[static_cast<std::size_t>(late.period())])) ++differ;
    }
    CHECK(differ == 0);
    REQUIRE(late.events().size() == in_time.events().size());
    for (std::size_t i = 0; i < late.events().size(); ++i)
      CHECK(late.events()[i].time == in_time.events()[i].time);
  }
}

TEST_CASE("the axes stand before the first motion, and finish at once when there is none") {
  GantryRun run;
  const auto& sample = run.step();
  CHECK(sample.reference.q == run.robot().start);
  CHECK(sample.reference.qd == gantry_q(0, 0, 0));
  CHECK(sample.state == MotionState::Idle);
  CHECK(sample.tag == 0);
  CHECK(run.events().empty());
  run.close();
  run.step();
  REQUIRE(run.events().size() == 1);
  CHECK(run.events()[0].kind == Kind::Finished);
  CHECK(run.events()[0].time == 0);
}

TEST_CASE("from rest a motion starts at the stamp at which it is first seen") {
  GantryRun run;
  run.advance(0);
  run.advance(1);
  run.move(100, 0, 0);
  run.advance(2);
  REQUIRE(run.saw(Kind::SegmentStarted));
  CHECK(run.events()[0].time == 2 * 0.01);
  CHECK(run.samples().back().reference.q == run.robot().start);
  CHECK(run.samples().back().sigma == doctest::Approx(-1.375));
  CHECK(run.advance(3).reference.q[0] > 0);
}

TEST_CASE("after a stop the next motion starts at the exact instant of the stop's end") {
  // 10 mm take 2.75 s, the stop another 2.75 s; with t_acc = 1.3773 s those are no whole periods.
  RobotModel robot = embedded_robot("gantry");
  robot.t_acc = 1.3773;
  GantryRun run(robot);
  run.move(10, 0, 0);
  run.stop();
  run.move(20, 0, 0);
  run.stop();
  run.close();
  run.finish();
  const auto started = run.all(Kind::SegmentStarted);
  REQUIRE(started.size() == 4);
  CHECK(started[2].time == doctest::Approx(4 * 1.3773).epsilon(1e-12));
  CHECK(run.all(Kind::Finished)[0].time == doctest::Approx(8 * 1.3773).epsilon(1e-12));
  CHECK(run.samples().size() == 1103);  // 11.0184 s: the last row is the first at or after it
}

TEST_CASE("segments of different transition times join smoothly") {
  GantryRun run;
  SegmentDescriptor first{1, 1, gantry_q(60, 0, 0), 4, 0.5, false, 0};
  SegmentDescriptor second{2, 2, gantry_q(60, 40, 0), 4, 1.5, false, 0};
  SegmentDescriptor third{3, 3, gantry_q(60, 40, 0), 3, 1.5, true, 0};
  for (const auto& segment : {first, second, third}) run.push(segment);
  run.close();
  run.finish();
  // Begins at −1.375, ends at 4 − 0.5; the second at −0.5 … 4 − 1.5; the third at −1.5 … 3 − 1.5.
  const auto started = run.all(Kind::SegmentStarted);
  REQUIRE(started.size() == 3);
  CHECK(started[1].time == doctest::Approx(4.875));
  CHECK(started[2].time == doctest::Approx(7.875));
  CHECK(run.all(Kind::Finished)[0].time == doctest::Approx(10.875));
  const double t = 0.01;
  // Greatest jerk: 1.5·Δv/t_acc² with Δv <= 15√2 mm/s, t_acc = 0.5 s.
  const double jerk = 1.5 * 0.015 / 0.25;
  for (std::size_t k = 1; k < run.samples().size(); ++k) {
    const auto& a = run.samples()[k - 1].reference;
    const auto& b = run.samples()[k].reference;
    CHECK(distance(b.q, a.q + (a.qd + b.qd) * (t / 2)) <= jerk * t * t * t / 12 + 1e-15);
    CHECK(distance(b.qd, a.qd + (a.qdd + b.qdd) * (t / 2)) <= jerk * t * t / 4);
    CHECK(distance(b.qdd, a.qdd) <= jerk * t * (1 + 1e-9));
  }
  CHECK(run.samples().back().reference.q == gantry_q(60, 40, 0));
}

TEST_CASE("the trace's line changes at the decision instant, S1's t runs through the segment") {
  GantryRun run;
  give_published_program(run);
  run.finish();
  const auto& samples = run.samples();
  CHECK(samples[0].tag == 1);
  CHECK(samples[275].tag == 1);  // 2.75 s belongs to the end of line 1
  CHECK(samples[276].tag == 2);
  CHECK(samples[276].sigma == doctest::Approx(-1.365));
  CHECK(samples[1910].tag == 5);
  CHECK(samples[1910].sigma == doctest::Approx(1.375));
  for (std::size_t k = 0; k < 1910; ++k) CHECK(samples[k].rate == 1);
}

TEST_CASE("a motion is decidable in the call before the one that has to know what follows") {
  GantryRun run;
  run.move(40, 40, 0);  // decides at 2.75 s: the reference for 2.76 s needs the next
  while (run.period() < 274) run.step();
  CHECK(run.generator().decidable() == 0);
  run.advance(275);
  CHECK(run.generator().decidable() == 1);
  run.move(140, 40, 0);  // just in time
  run.advance(276);
  CHECK(run.generator().late_decisions() == 0);
  CHECK(run.samples().back().tag == 0);
  CHECK(run.samples().back().piece == 2);
  CHECK(run.generator().decidable() == 1);
}

TEST_CASE("at rest the last motion done is decidable") {
  GantryRun run;
  run.step();
  CHECK(run.generator().decidable() == 0);
  run.move(10, 0, 0);
  run.stop();
  while (run.period() < 600) run.step();
  CHECK(run.generator().decidable() == 2);
  CHECK(run.samples().back().state == MotionState::Idle);
}

TEST_CASE("the generator takes no memory") {
  GantryRun run;
  give_published_program(run);
  MotionEvent event;
  NoAllocation guard;
  for (std::int64_t period = 0; period < 2500; period += period % 7 == 0 ? 5 : 1) {
    if (period % 400 == 100) run.generator().hold();
    if (period % 400 == 200) run.generator().resume();
    run.generator().advance(period);
    while (run.generator().take_event(event)) {
    }
  }
  CHECK(guard.count() == 0);
}
