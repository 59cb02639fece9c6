#include <doctest/doctest.h>

#include <cmath>

#include "tests/motion/generate/gantry_run.h"
#include "tests/support/no_allocation.h"

using namespace rob::motion;
using namespace rob::test;
using Kind = MotionEvent::Kind;

// Every motion and every stop below takes 2.75 s.

namespace {

double finished(const GantryRun& run) { return run.all(Kind::Finished).at(0).time; }

void step_to(GantryRun& run, std::int64_t period) {
  while (run.period() < period) run.step();
}

}  // namespace

TEST_CASE("a dwell takes exactly its time, and what follows starts at its exact end") {
  GantryRun run;
  run.move(40, 0, 0);
  run.stop();
  run.push(run.planner().dwell(3, 0.3333));
  run.move(0, 0, 0, 4);
  run.stop();
  run.close();
  run.finish();
  const auto started = run.all(Kind::SegmentStarted);
  REQUIRE(started.size() == 5);
  CHECK(started[2].tag == 3);
  CHECK(started[2].time == doctest::Approx(2 * 2.75).epsilon(1e-12));
  CHECK(started[3].time == doctest::Approx(2 * 2.75 + 0.3333).epsilon(1e-12));
  CHECK(finished(run) == doctest::Approx(4 * 2.75 + 0.3333).epsilon(1e-12));
}

TEST_CASE("the axes stand at the target while a dwell lasts") {
  GantryRun run;
  run.move(40, 0, 0);
  run.stop();
  run.push(run.planner().dwell(3, 1));
  run.move(0, 0, 0);
  run.stop();
  run.close();
  run.finish();
  int rows = 0;
  for (const GeneratorSample& sample : run.samples()) {
    if (sample.piece != 3) continue;
    ++rows;
    CHECK(sample.reference.q[0] == 0.04);
    CHECK(sample.reference.qd[0] == 0);
    CHECK(sample.state == MotionState::Running);
  }
  CHECK(rows == 100);
}

TEST_CASE("effects behind a dwell are due at its end") {
  GantryRun run;
  run.push(run.planner().dwell(1, 0.5));
  run.effect(7);
  run.close();
  run.finish();
  CHECK(run.all(Kind::EffectDue).at(0).time == doctest::Approx(0.5).epsilon(1e-12));
  CHECK(finished(run) == doctest::Approx(0.5).epsilon(1e-12));
}

TEST_CASE("dwells shorter than a period add up exactly") {
  GantryRun run;
  for (int i = 0; i < 30; ++i) run.push(run.planner().dwell(1, 0.0007));
  run.close();
  run.finish();
  CHECK(finished(run) == doctest::Approx(0.021).epsilon(1e-9));
}

TEST_CASE("an override does not stretch a dwell") {
  GantryRun run;
  run.generator().set_override(0.5);
  run.move(40, 0, 0);
  run.stop();
  run.push(run.planner().dwell(3, 1));
  run.close();
  run.finish();
  // Motions take twice their time.
  CHECK(finished(run) == doctest::Approx(2 * 2 * 2.75 + 1).epsilon(1e-9));
}

TEST_CASE("an override that changes in the middle of a dwell does not stretch it either") {
  GantryRun run;
  run.push(run.planner().dwell(1, 1));
  run.close();
  step_to(run, 40);
  run.generator().set_override(0.25);
  step_to(run, 70);
  run.generator().set_override(0.5);
  run.finish();
  CHECK(finished(run) == doctest::Approx(1).epsilon(1e-9));
}

TEST_CASE("a hold interrupts a dwell, and resume goes on with the rest of it") {
  GantryRun run;
  run.push(run.planner().dwell(1, 1));
  run.close();
  step_to(run, 40);
  run.generator().hold();
  step_to(run, 90);
  REQUIRE(run.saw(Kind::Held));
  CHECK(run.all(Kind::Held)[0].value == doctest::Approx(0.4).epsilon(0.05));
  run.generator().resume();
  run.finish();
  CHECK(finished(run) == doctest::Approx(1.5).epsilon(0.05));
}

TEST_CASE("a dwell of no length marks its instant and costs nothing") {
  GantryRun run;
  run.move(40, 0, 0);
  run.stop();
  run.push(run.planner().dwell(3, 0));
  run.move(0, 0, 0);
  run.stop();
  run.close();
  run.finish();
  CHECK(run.all(Kind::SegmentStarted).at(2).time == doctest::Approx(2 * 2.75).epsilon(1e-12));
  CHECK(finished(run) == doctest::Approx(4 * 2.75).epsilon(1e-12));
}

TEST_CASE("dwells take no memory in the tick") {
  GantryRun run;
  for (int i = 0; i < 10; ++i) run.push(run.planner().dwell(1, 0.013));
  PaulGenerator& generator = run.generator();
  const NoAllocation guard;
  for (std::int64_t period = 0; period < 20; ++period) generator.advance(period);
  CHECK(guard.count() == 0);
}
