#include <doctest/doctest.h>

#include "tests/motion/generate/gantry_run.h"
#include "tests/motion/generate/jog_bench.h"
#include "tests/support/no_allocation.h"

using namespace rob::motion;
using namespace rob::test;
using Kind = MotionEvent::Kind;
using Space = JogRates::Space;

namespace {

constexpr double kPeriod = 0.01;  // s, of the gantry

SegmentDescriptor jog(GantryRun& run, double x_mm, double seconds, Tag tag = 0, Watch guard = {}) {
  JogRates rates = jog_rates(Space::Joint, {x_mm / 1000, 0, 0});
  rates.lasts = seconds;
  SegmentDescriptor segment = std::get<PlannedSegment>(run.planner().jog(tag, rates)).segment;
  segment.guard = guard;
  run.push(segment);
  return segment;
}

double x_mm(const GeneratorSample& sample) { return 1000 * sample.reference.q[0]; }

}  // namespace

TEST_CASE("a jog goes its rate times its time, comes to rest, and tells where") {
  GantryRun run;
  jog(run, 10, 1, 7);
  for (int i = 0; i < 200; ++i) run.step();
  REQUIRE(run.rests().size() == 1);
  const Rest& rest = run.rests()[0];
  CHECK(rest.outcome == Rest::Outcome::Reached);
  CHECK(rest.tag == 7);
  CHECK(rest.q[0] == doctest::Approx(0.01).epsilon(1e-9));
  // 10 mm/s take 2·sqrt(v/j) = 0.2 s to be slowed down.
  CHECK(rest.time >= 1.2 - 1e-9);
  CHECK(rest.time <= 1.23);
  CHECK(run.samples().back().state == MotionState::Idle);
}

TEST_CASE("the time of a jog is rounded up to whole periods, at least one") {
  GantryRun run;
  CHECK(jog(run, 10, 0.001).duration == doctest::Approx(kPeriod));
  CHECK(jog(run, 10, 0.0301).duration == doctest::Approx(4 * kPeriod));
  CHECK(jog(run, 10, 0.03).duration == doctest::Approx(3 * kPeriod));
}

TEST_CASE("a jog that is renewed goes on as though it were one") {
  GantryRun one;
  jog(one, 10, 1);
  GantryRun many;
  std::uint32_t given = 0;
  for (int i = 0; i < 200; ++i) {
    one.step();
    // As the program does: at the decision point, one period before the end.
    if (many.generator().decidable() >= given && given < 50) {
      given = jog(many, 10, 0.02).number;
    }
    many.step();
  }
  // The first one is seen a period later, as a program that reads at once would be.
  CHECK(one.rests().size() == 1);
  CHECK(many.rests().size() == 1);
  for (std::size_t k = 0; k < one.samples().size(); ++k) {
    REQUIRE(one.samples()[k].reference.q == many.samples()[k].reference.q);
    REQUIRE(one.samples()[k].reference.qdd == many.samples()[k].reference.qdd);
  }
}

TEST_CASE("what follows a jog is decided one period before its end") {
  GantryRun run;
  const SegmentDescriptor segment = jog(run, 10, 0.5);
  while (run.generator().decidable() < segment.number) run.step();
  // The reference at the end has been computed, in the cycle one period before.
  CHECK(run.samples().back().reference.time == doctest::Approx(0.5).epsilon(1e-12));
}

TEST_CASE("a jog that is not renewed in time is taken up while it comes to rest") {
  GantryRun run;
  jog(run, 10, 0.5);
  while (run.samples().empty() || run.samples().back().reference.time < 0.55) run.step();
  const double slowed = run.samples().back().reference.qd[0];
  CHECK(slowed < 0.01);
  jog(run, 10, 0.5);
  double least = slowed;
  for (int i = 0; i < 30; ++i) least = std::min(least, run.step().reference.qd[0]);
  CHECK(least > 0);
  for (int i = 0; i < 100; ++i) run.step();
  CHECK(run.rests().size() == 1);
}

TEST_CASE("rates of a hand take effect at once, and the robot stops when it falls silent") {
  GantryRun run;
  JogRates rates = jog_rates(Space::Joint, {0.01, 0, 0});
  rates.lasts = 0.1;
  rates.at_once = true;
  const auto give = [&] {
    run.push(std::get<PlannedSegment>(run.planner().jog(0, rates)).segment);
  };
  for (int i = 0; i < 100; ++i) {
    if (i % 5 == 0) give();
    run.step();
  }
  CHECK(run.samples().back().reference.qd[0] == doctest::Approx(0.01).epsilon(1e-9));
  rates.rate[0] = 0.005;
  give();
  const double begun = run.samples().back().reference.time;
  for (int i = 0; i < 9; ++i) run.step();
  CHECK(run.samples().back().reference.qd[0] < 0.0075);
  while (run.rests().empty()) run.step();
  // 0.1 s of silence, and 2·sqrt(v/j) = 0.142 s to slow down from 5 mm/s, in whole periods.
  CHECK(run.rests()[0].time - begun <= 0.1 + 0.142 + 0.03);
}

TEST_CASE("between a motion and a jog the axes rest, and behind it the motion starts from there") {
  GantryRun run;
  run.move(20, 0, 0);
  run.stop();
  jog(run, 10, 0.5);
  while (run.rests().empty()) run.step();
  const JointVector q = run.rests()[0].q;
  CHECK(q[0] == doctest::Approx(0.025).epsilon(1e-9));
  run.planner().stand_at(q, run.planner().last_number());
  run.move(20, 10, 0);
  run.stop();
  run.close();
  run.finish();
  CHECK(x_mm(run.samples().back()) == doctest::Approx(20));
  for (const GeneratorSample& sample : run.samples()) {
    REQUIRE(std::abs(sample.reference.qdd[0]) <= 0.1 * (1 + 1e-9));
  }
}

TEST_CASE("a hold stops a jog within its limits, and what is left of its time follows") {
  GantryRun run;
  jog(run, 10, 1);
  for (int i = 0; i < 50; ++i) run.step();
  run.generator().hold();
  for (int i = 0; i < 60; ++i) run.step();
  CHECK(run.samples().back().state == MotionState::Held);
  CHECK(run.all(Kind::Held).size() == 1);
  run.generator().resume();
  for (int i = 0; i < 200; ++i) run.step();
  REQUIRE(run.rests().size() == 1);
  CHECK(run.rests()[0].q[0] == doctest::Approx(0.01).epsilon(1e-9));
}

TEST_CASE("an override slows a jog and stretches its time") {
  GantryRun run;
  run.generator().set_override(0.5);
  jog(run, 10, 1);
  while (run.rests().empty()) run.step();
  CHECK(run.rests()[0].q[0] == doctest::Approx(0.01).epsilon(1e-9));
  CHECK(run.rests()[0].time > 2);
  for (const GeneratorSample& sample : run.samples()) {
    REQUIRE(sample.reference.qd[0] <= 0.005 * (1 + 1e-9));
  }
}

TEST_CASE("a jog is hit, and braked, as a motion is") {
  GantryRun run;
  const Watch guard{[](const void*, const CycleView& view) noexcept {
                      return view.inputs != 0 ? WatchAnswer::Yes : WatchAnswer::No;
                    },
                    nullptr};
  jog(run, 20, JogRates::kAny, 3, guard);
  for (int i = 0; i < 100; ++i) run.step();
  run.inputs = 1;
  while (run.rests().empty()) run.step();
  CHECK(run.rests()[0].outcome == Rest::Outcome::Hit);
  // From 20 mm/s: v/a + a/j = 0.3 s, and 3 mm; decided in whole periods.
  CHECK(run.rests()[0].time - run.rests()[0].trip_time <= 0.33);
  CHECK(run.rests()[0].q[0] - run.rests()[0].trip_q[0] == doctest::Approx(0.003).epsilon(0.1));
}

TEST_CASE("an axis at the end of its way is told once") {
  GantryRun run;
  jog(run, -10, 2);
  for (int i = 0; i < 300; ++i) run.step();
  const auto told = run.all(Kind::JogStopped);
  REQUIRE(told.size() == 1);
  CHECK(told[0].axis == 0);
  CHECK(run.rests().size() == 1);
}

TEST_CASE("a jog in the generator takes no memory") {
  GantryRun run;
  jog(run, 10, 0.1);
  jog(run, -10, 0.1);
  PaulGenerator& generator = run.generator();
  const NoAllocation guard;
  for (int i = 0; i < 100; ++i) generator.advance(i);
  CHECK(guard.count() == 0);
}
