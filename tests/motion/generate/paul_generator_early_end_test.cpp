#include <doctest/doctest.h>

#include <cmath>

#include "motion/robots/time_scaling.h"
#include "tests/motion/generate/gantry_run.h"
#include "tests/support/no_allocation.h"

using namespace rob::motion;
using namespace rob::test;
using Kind = MotionEvent::Kind;
using Outcome = Rest::Outcome;

// A motion of the gantry has 1.375 s of corner at each end and 20 mm/s in between.

namespace {

/// Input 0 is what the guards of these tests look at.
WatchAnswer input_0(const void*, const CycleView& view) noexcept {
  return (view.inputs & 1) != 0 ? WatchAnswer::Yes : WatchAnswer::No;
}
WatchAnswer never_computed(const void*, const CycleView&) noexcept { return WatchAnswer::Failed; }

/// UNTIL: the motion, and the stop that makes it exact.
void guarded(GantryRun& run, double x_in_mm, Watch::Test test, Tag tag = 7) {
  auto segment =
      std::get<PlannedSegment>(run.planner().plan(move_to(gantry_q(x_in_mm, 0, 0), tag)));
  segment.segment.guard = {test, nullptr};
  run.push(segment.segment);
  auto stop = run.planner().stop(tag);
  stop->guard = {test, nullptr};
  run.push(*stop);
}

void until(GantryRun& run, double time) {
  while (run.samples().empty() || run.samples().back().reference.time < time - 1e-9) run.step();
}
double x_in_mm(const JointVector& q) { return q[0] * 1000; }

/// No speed changes by more than the axis can accelerate: over the whole run.
void check_accelerations(const GantryRun& run) {
  const double t = run.robot().reference_period;
  for (std::size_t k = 2; k < run.samples().size(); ++k) {
    const auto x = [&](std::size_t i) { return run.samples()[i].reference.q[0]; };
    REQUIRE(std::abs(x(k) - 2 * x(k - 1) + x(k - 2)) / (t * t) <= 0.1 * (1 + 1e-6));
  }
}

}  // namespace

TEST_CASE("a guarded motion whose condition never holds arrives and says so") {
  GantryRun run;
  guarded(run, 100, input_0);
  until(run, 9);
  REQUIRE(run.rests().size() == 1);
  CHECK(run.rests()[0].outcome == Outcome::Reached);
  CHECK(run.rests()[0].tag == 7);
  // 100 mm at 20 mm/s and the exact stop
  CHECK(run.rests()[0].time == doctest::Approx(5 + 2.75).epsilon(1e-12));
  CHECK(x_in_mm(run.rests()[0].q) == doctest::Approx(100));
  CHECK(run.samples().back().state == MotionState::Idle);
  CHECK(run.generator().late_decisions() == 0);
}

TEST_CASE("a guarded motion brakes on its path where its condition holds") {
  GantryRun run;
  guarded(run, 100, input_0);
  until(run, 3);
  const double x_at_trip = x_in_mm(run.samples().back().reference.q);
  run.inputs = 1;
  until(run, 5);
  REQUIRE(run.rests().size() == 1);
  const Rest& rest = run.rests()[0];
  CHECK(rest.outcome == Outcome::Hit);
  CHECK(rest.trip_time == doctest::Approx(3).epsilon(1e-12));
  CHECK(x_in_mm(rest.trip_q) == doctest::Approx(x_at_trip));
  const double braking = stopping_time(time_scale_limits(run.robot()));
  CHECK(rest.time == doctest::Approx(3 + braking).epsilon(1e-9));
  // The ramp of the time scale is symmetric: half of the way at full speed.
  CHECK(x_in_mm(rest.q) - x_at_trip == doctest::Approx(20 * braking / 2).epsilon(1e-9));
  CHECK(rest.q == run.samples().back().reference.q);
  check_accelerations(run);
}

TEST_CASE("what is commanded behind an early end starts from the place of rest") {
  GantryRun run;
  guarded(run, 100, input_0);
  until(run, 3);
  run.inputs = 1;
  until(run, 4);
  run.planner().retarget(run.rests().at(0).q);
  run.inputs = 0;
  run.move(0, 0, 0, 8);
  run.stop(8);
  run.close();
  run.finish(2000);
  CHECK(x_in_mm(run.samples().back().reference.q) == doctest::Approx(0));
  CHECK(run.saw(Kind::Finished));
  check_accelerations(run);
}

TEST_CASE("from standstill a condition that holds keeps the motion from starting") {
  GantryRun run;
  run.inputs = 1;
  guarded(run, 100, input_0);
  until(run, 1);
  REQUIRE(run.rests().size() == 1);
  CHECK(run.rests()[0].outcome == Outcome::Hit);
  CHECK(run.rests()[0].time <= 0.02);
  CHECK(x_in_mm(run.samples().back().reference.q) == 0);
  CHECK(run.samples().back().piece == run.planner().last_number());
}

TEST_CASE("behind an exact stop, too, a condition that holds keeps the motion from starting") {
  GantryRun run;
  run.move(20, 0, 0, 1);
  run.stop(1);
  run.inputs = 1;
  guarded(run, 100, input_0);
  until(run, 8);
  REQUIRE(run.rests().size() == 1);
  CHECK(run.rests()[0].time == doctest::Approx(2 * 2.75).epsilon(0.01));
  CHECK(x_in_mm(run.samples().back().reference.q) == doctest::Approx(20));
}

TEST_CASE("a guarded motion that is blended into is asked from the beginning of the corner") {
  GantryRun run;
  run.move(100, 0, 0, 1);
  guarded(run, 200, input_0);
  run.inputs = 1;  // the first motion has no guard
  until(run, 7);
  REQUIRE(run.rests().size() == 1);
  // The corner begins 1.375 s before 100 mm would be reached, at 5 s; the next cycle asks.
  CHECK(run.rests()[0].trip_time == doctest::Approx(5).epsilon(0.0021));
  check_accelerations(run);
}

TEST_CASE("what was commanded before the motion that ends early acts, what hangs on it does not") {
  GantryRun run;
  run.move(100, 0, 0, 1);
  run.effect(1);  // due in the middle of the corner, at 6.375 s
  guarded(run, 200, input_0);
  Effect behind;
  behind.id = 2;
  behind.after = run.planner().last_number();
  run.effect_after(behind);
  until(run, 5.1);
  run.inputs = 1;
  until(run, 8);
  REQUIRE(run.rests().size() == 1);
  REQUIRE(run.all(Kind::EffectDue).size() == 1);
  CHECK(run.all(Kind::EffectDue)[0].effect.id == 1);
  CHECK(run.all(Kind::EffectDue)[0].time == doctest::Approx(run.rests()[0].time));
  REQUIRE(run.all(Kind::EffectDropped).size() == 1);
  CHECK(run.all(Kind::EffectDropped)[0].effect.id == 2);
}

TEST_CASE("a condition that cannot be computed brakes, too") {
  GantryRun run;
  run.move(20, 0, 0, 1);
  guarded(run, 200, never_computed);
  until(run, 7);
  REQUIRE(run.rests().size() == 1);
  CHECK(run.rests()[0].outcome == Outcome::Failed);
}

TEST_CASE("a condition that holds in the last moment ends at the target") {
  GantryRun run;
  guarded(run, 40, input_0);
  until(run, 5.45);
  run.inputs = 1;
  until(run, 7);
  REQUIRE(run.rests().size() == 1);
  CHECK(run.rests()[0].outcome == Outcome::Hit);
  CHECK(x_in_mm(run.rests()[0].q) == doctest::Approx(40).epsilon(1e-4));
}

TEST_CASE("a motion that is to be braked brakes as soon as it is the running one") {
  GantryRun run;
  run.move(100, 0, 0, 1);
  run.move(200, 0, 0, 2);
  run.buffer().brake(2);
  until(run, 8);
  REQUIRE(run.rests().size() == 1);
  CHECK(run.rests()[0].outcome == Outcome::Braked);
  CHECK(run.rests()[0].tag == 2);
  CHECK(run.rests()[0].trip_time == doctest::Approx(5).epsilon(0.0021));
  check_accelerations(run);
  CHECK(run.buffer().to_be_braked() == 0);
}

TEST_CASE("braking where nothing moves is over at once") {
  GantryRun run;
  run.step();
  run.move(20, 0, 0, 1);
  run.stop(1);
  until(run, 6);
  run.buffer().brake(run.planner().last_number());
  until(run, 6.05);
  REQUIRE(run.rests().size() == 1);
  CHECK(run.rests()[0].outcome == Outcome::Braked);
  CHECK(x_in_mm(run.rests()[0].q) == doctest::Approx(20));
}

TEST_CASE("motions of a generation that has ended are passed over") {
  GantryRun run;
  run.move(100, 0, 0, 1);
  run.buffer().brake(1);
  until(run, 1);
  REQUIRE(run.rests().size() == 1);
  run.move(200, 0, 0, 2);  // the program has not learnt of it yet
  run.effect(1);
  until(run, 2);
  CHECK(run.samples().back().state == MotionState::Idle);
  CHECK(run.samples().back().piece == 2);
  CHECK(run.all(Kind::EffectDropped).size() == 1);
}

TEST_CASE("under an override, braking starts from the present rate and the next motion keeps it") {
  GantryRun run;
  run.generator().set_override(0.5);
  guarded(run, 100, input_0);
  until(run, 4);
  run.inputs = 1;
  until(run, 5);
  REQUIRE(run.rests().size() == 1);
  run.inputs = 0;
  run.planner().retarget(run.rests()[0].q);
  run.move(200, 0, 0, 8);
  until(run, 9);
  CHECK(run.samples().back().rate == doctest::Approx(0.5));
  check_accelerations(run);
}

TEST_CASE("guards, braking and dropping take no memory") {
  GantryRun run;
  guarded(run, 100, input_0);
  CycleView view;
  view.reference = view.measured = run.robot().start;
  NoAllocation guard;
  for (int k = 0; k < 400; ++k) {
    view.inputs = k > 200 ? 1 : 0;
    view.time = 0.01 * k;
    run.generator().look(view);
    run.generator().advance(k);
  }
  CHECK(guard.count() == 0);
}
