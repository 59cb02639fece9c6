#include <doctest/doctest.h>

#include <vector>

#include "tests/motion/generate/gantry_run.h"
#include "tests/support/no_allocation.h"

using namespace rob::motion;
using namespace rob::test;
using Kind = MotionEvent::Kind;

namespace {

template <unsigned kInput>
WatchAnswer input(const void*, const CycleView& view) noexcept {
  return (view.inputs >> kInput & 1) != 0 ? WatchAnswer::Yes : WatchAnswer::No;
}

void set_up(WatchedAction& action, Watch::Test test, std::uint32_t id) {
  action.condition = {test, nullptr};
  action.effect.id = id;
  action.armed = true;
}

Effect arming(WatchedAction& action, Effect::Kind kind, std::uint32_t after = 0) {
  Effect effect;
  effect.kind = kind;
  effect.watched = &action;
  effect.after = after;
  return effect;
}

std::vector<std::uint32_t> done(const GantryRun& run) {
  std::vector<std::uint32_t> ids;
  for (const MotionEvent& event : run.all(Kind::ActionDue)) ids.push_back(event.effect.id);
  return ids;
}

}  // namespace

TEST_CASE("a WHEN fires each time its condition comes true, and also if it is true when armed") {
  GantryRun run;
  WatchedAction action;
  set_up(action, input<0>, 1);
  run.inputs = 1;
  run.effect_after(arming(action, Effect::Kind::Arm));
  for (int k = 0; k < 5; ++k) run.step();
  CHECK(done(run) == std::vector<std::uint32_t>{1});
  run.inputs = 0;
  run.step();
  run.inputs = 1;
  for (int k = 0; k < 5; ++k) run.step();
  CHECK(done(run) == std::vector<std::uint32_t>{1, 1});
}

TEST_CASE("WHENs are asked in the order in which they were armed") {
  GantryRun run;
  WatchedAction first;
  WatchedAction second;
  set_up(first, input<1>, 1);
  set_up(second, input<0>, 2);
  run.effect_after(arming(first, Effect::Kind::Arm));
  run.effect_after(arming(second, Effect::Kind::Arm));
  run.step();
  run.inputs = 3;
  run.step();
  CHECK(done(run) == std::vector<std::uint32_t>{1, 2});
}

TEST_CASE("a WHEN is armed and disarmed in motion order") {
  GantryRun run;
  WatchedAction action;
  set_up(action, input<0>, 1);
  run.move(100, 0, 0, 1);
  run.effect_after(arming(action, Effect::Kind::Arm, 1));  // in the corner, at 6.375 s
  run.move(200, 0, 0, 2);
  run.effect_after(arming(action, Effect::Kind::Disarm, 2));
  run.move(100, 0, 0, 3);
  run.inputs = 1;
  while (run.period() < 800) run.step();
  REQUIRE(done(run).size() == 1);
  CHECK(run.all(Kind::ActionDue)[0].time == doctest::Approx(6.38));
  CHECK(action.armed);
  run.inputs = 0;
  while (run.period() < 1500) run.step();
  run.inputs = 1;
  run.step();
  CHECK(done(run).size() == 1);
  CHECK(!action.armed);
}

TEST_CASE("a WHEN that raises brakes, and everything behind is dropped") {
  GantryRun run;
  WatchedAction action;
  set_up(action, input<0>, 1);
  action.kind = WatchedAction::Kind::Raise;
  run.effect_after(arming(action, Effect::Kind::Arm));
  run.move(100, 0, 0, 1);
  run.effect(7);
  run.move(200, 0, 0, 2);
  run.effect(8);
  while (run.period() < 600) run.step();  // in the corner, before its middle
  run.inputs = 1;
  while (run.period() < 1000) run.step();
  REQUIRE(run.rests().size() == 1);
  CHECK(run.rests()[0].outcome == Rest::Outcome::Raised);
  CHECK(run.rests()[0].by == &action);
  CHECK(run.rests()[0].trip_time == doctest::Approx(6));
  CHECK(run.all(Kind::EffectDropped).size() == 2);
  CHECK(run.samples().back().state == MotionState::Idle);
  CHECK(run.samples().back().reference.q[0] < 0.1);
  CHECK(action.fired);
}

TEST_CASE("an error of a WHEN goes before a hit in the same cycle") {
  GantryRun run;
  WatchedAction action;
  set_up(action, input<0>, 1);
  action.kind = WatchedAction::Kind::Raise;
  run.effect_after(arming(action, Effect::Kind::Arm));
  auto segment = std::get<PlannedSegment>(run.planner().plan(move_to(gantry_q(100, 0, 0), 7)));
  segment.segment.guard = {input<0>, nullptr};
  run.push(segment.segment);
  while (run.period() < 300) run.step();
  run.inputs = 1;
  while (run.period() < 400) run.step();
  REQUIRE(run.rests().size() == 1);
  CHECK(run.rests()[0].outcome == Rest::Outcome::Raised);
}

TEST_CASE(
    "what an ended generation would have disarmed is disarmed, what it would have armed not") {
  GantryRun run;
  WatchedAction first;
  WatchedAction second;
  set_up(first, input<0>, 1);
  set_up(second, input<1>, 2);
  run.effect_after(arming(first, Effect::Kind::Arm));
  run.move(100, 0, 0, 1);
  run.effect_after(arming(first, Effect::Kind::Disarm, 1));
  run.effect_after(arming(second, Effect::Kind::Arm, 1));
  run.step();
  run.buffer().brake(1);
  while (run.period() < 200) run.step();
  run.inputs = 3;
  for (int k = 0; k < 5; ++k) run.step();
  CHECK(done(run).empty());
  CHECK(!first.armed);
}

TEST_CASE("sixteen WHENs are asked in every cycle without taking memory") {
  GantryRun run;
  std::array<WatchedAction, WatchList::kMost> actions;
  for (WatchedAction& action : actions) {
    set_up(action, input<0>, 1);
    run.effect_after(arming(action, Effect::Kind::Arm));
  }
  run.step();
  CycleView view;
  view.reference = view.measured = run.robot().start;
  NoAllocation guard;
  for (int k = 1; k < 100; ++k) {
    view.inputs = k % 2 == 0 ? 1 : 0;
    run.generator().look(view);
    run.generator().advance(k);
  }
  CHECK(guard.count() == 0);
}
