#include <doctest/doctest.h>

#include "tests/motion/generate/gantry_run.h"

using namespace rob::motion;
using namespace rob::test;
using Kind = MotionEvent::Kind;

// Every segment below takes 2.75 s unless said otherwise; t_acc is 1.375 s.

TEST_CASE("an effect behind a rounded corner is due in the middle of the corner") {
  GantryRun run;
  run.move(40, 0, 0);
  run.effect(7);
  run.move(40, 40, 0);
  run.stop();
  run.close();
  run.finish();
  const auto due = run.all(Kind::EffectDue);
  REQUIRE(due.size() == 1);
  CHECK(due[0].effect.id == 7);
  CHECK(due[0].time == doctest::Approx(2.75 + 1.375).epsilon(1e-12));
}

TEST_CASE("an effect acts in the first cycle at or after its instant") {
  GantryRun run;
  run.move(40, 0, 0);
  run.effect(7);
  run.move(40, 40, 0);
  while (run.period() < 412) run.step();
  CHECK_FALSE(run.saw(Kind::EffectDue));  // 4.12 s
  run.advance(413);                       // 4.13 s is the first after 4.125 s
  CHECK(run.saw(Kind::EffectDue));
}

TEST_CASE("an effect in front of a stop is due when the target is reached at standstill") {
  GantryRun run;
  run.move(40, 0, 0);
  run.effect(7);
  run.stop();
  run.close();
  run.finish();
  REQUIRE(run.all(Kind::EffectDue).size() == 1);
  CHECK(run.all(Kind::EffectDue)[0].time == doctest::Approx(5.5).epsilon(1e-12));
}

TEST_CASE("an effect behind an exact pass is due at its end, in the cycle of that instant") {
  GantryRun run;
  run.move(40, 0, 0);
  run.move(40, 0, 0);
  run.effect(7);
  run.move(80, 0, 0);
  run.stop();
  run.close();
  while (run.period() < 549) run.step();
  CHECK_FALSE(run.saw(Kind::EffectDue));
  run.advance(550);
  REQUIRE(run.saw(Kind::EffectDue));
  CHECK(run.all(Kind::EffectDue)[0].time == doctest::Approx(5.5).epsilon(1e-12));
}

TEST_CASE("an effect whose motion turns out to be the last known is due at its late stop") {
  GantryRun run;
  run.move(40, 0, 0);
  run.effect(7);
  while (run.period() < 600) run.step();
  CHECK(run.saw(Kind::LateDecision));
  REQUIRE(run.all(Kind::EffectDue).size() == 1);
  CHECK(run.all(Kind::EffectDue)[0].time == doctest::Approx(5.5).epsilon(1e-12));
}

TEST_CASE("an effect before any motion is due at once, and before the motion starts") {
  GantryRun run;
  run.effect(1);
  run.move(40, 0, 0);
  run.step();
  REQUIRE(run.events().size() == 2);
  CHECK(run.events()[0].kind == Kind::EffectDue);
  CHECK(run.events()[0].time == 0);
  CHECK(run.events()[1].kind == Kind::SegmentStarted);
}

TEST_CASE("an effect that comes too late is due at the stamp being computed") {
  GantryRun run;
  run.move(40, 0, 0);
  run.move(40, 40, 0);
  run.move(0, 40, 0);
  while (run.period() < 500) run.step();
  Effect effect;
  effect.after = 1;  // its instant was 4.125 s
  run.effect_after(effect);
  run.step();
  REQUIRE(run.all(Kind::EffectDue).size() == 1);
  CHECK(run.all(Kind::EffectDue)[0].time == 501 * 0.01);
}

TEST_CASE("effects keep their order and their exact values") {
  GantryRun run;
  std::uint32_t id = 0;
  RandomTargets targets(run.robot(), 5);
  for (int n = 0; n < 20; ++n) {
    run.move(move_to(targets.next()));
    for (int k = targets.pick(0, 3); k > 0; --k) run.effect(++id);
  }
  run.stop();
  run.effect(++id);
  run.close();
  run.finish();
  const auto due = run.all(Kind::EffectDue);
  REQUIRE(due.size() == id);
  for (std::size_t i = 0; i < due.size(); ++i) CHECK(due[i].effect.id == i + 1);
  for (std::size_t i = 1; i < run.events().size(); ++i)
    CHECK(run.events()[i].time >= run.events()[i - 1].time);
  CHECK(run.events().back().kind == Kind::Finished);
}

TEST_CASE("an output just before the middle of a corner comes before what stands behind it") {
  GantryRun run;
  auto outcome = run.planner().plan(move_to(gantry_q(40, 0, 0)));
  SegmentDescriptor segment = std::get<PlannedSegment>(outcome).segment;
  PathEvent event{.share = 1 - 1e-4};
  event.effect.after = segment.number;
  segment.on_the_way.push_back(event);
  run.push(segment);
  run.effect(7);
  run.move(move_to(gantry_q(40, 40, 0)));
  run.stop();
  run.close();
  run.finish();
  REQUIRE(run.all(Kind::ActionDue).size() == 1);
  REQUIRE(run.all(Kind::EffectDue).size() == 1);
  // A ten-thousandth of the leg's time, by which its places go in a corner.
  CHECK(run.all(Kind::EffectDue)[0].time - run.all(Kind::ActionDue)[0].time ==
        doctest::Approx(1e-4 * segment.duration).epsilon(1e-6));
}

TEST_CASE("at one instant: the end of a motion, what stands behind it, the beginning of the next") {
  GantryRun run;
  const auto push = [&](const JointVector& q, double share, std::uint32_t id) {
    auto outcome = run.planner().plan(move_to(q));
    SegmentDescriptor segment = std::get<PlannedSegment>(outcome).segment;
    PathEvent event{.share = share};
    event.effect.id = id;
    event.effect.after = segment.number;
    segment.on_the_way.push_back(event);
    run.push(segment);
  };
  push(gantry_q(40, 0, 0), 1, 1);
  run.effect(2);
  push(gantry_q(40, 40, 0), 0, 3);
  run.stop();
  run.close();
  run.finish();
  std::vector<std::uint32_t> order;
  for (const MotionEvent& event : run.events())
    if (event.kind == Kind::ActionDue || event.kind == Kind::EffectDue)
      order.push_back(event.effect.id);
  CHECK(order == std::vector<std::uint32_t>{1, 2, 3});
}

TEST_CASE("a LAG that outlasts the last motion comes before the program is over") {
  GantryRun run;
  auto outcome = run.planner().plan(move_to(gantry_q(40, 0, 0)));
  SegmentDescriptor segment = std::get<PlannedSegment>(outcome).segment;
  PathEvent event{.share = 1, .lead = -0.5};
  event.effect.after = segment.number;
  segment.on_the_way.push_back(event);
  run.push(segment);
  run.stop();
  run.close();
  run.finish();
  REQUIRE(run.all(Kind::ActionDue).size() == 1);
  CHECK(run.all(Kind::ActionDue)[0].time == doctest::Approx(6).epsilon(1e-12));
  CHECK(run.all(Kind::Finished)[0].time == doctest::Approx(6).epsilon(1e-12));
}

TEST_CASE("a program that only speaks finishes when it has spoken") {
  GantryRun run;
  run.step();
  run.effect(1);
  run.step();
  run.close();
  run.step();
  REQUIRE(run.events().size() == 2);
  CHECK(run.events()[0].time == 0.01);
  CHECK(run.events()[1].kind == Kind::Finished);
  CHECK(run.events()[1].time == 0.01);
}

TEST_CASE("a thousand effects at one place are all told in the cycle that passes it") {
  GantryRun run;
  run.move(40, 0, 0);
  for (std::uint32_t id = 0; id < LookAheadBuffer::kEffects; ++id) run.effect(id);
  run.stop();
  run.close();
  while (run.period() < 549) run.step();
  CHECK_FALSE(run.saw(Kind::EffectDue));
  run.step();
  CHECK(run.all(Kind::EffectDue).size() == LookAheadBuffer::kEffects);
}
