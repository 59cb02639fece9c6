// A stop that waits until the measured robot is in position, on axes that are measured where the
// test says.
#include <doctest/doctest.h>

#include <cmath>

#include "motion/generate/position_error.h"
#include "tests/motion/generate/gantry_run.h"
#include "tests/motion/generate/look_ahead_run.h"
#include "tests/support/degrees.h"
#include "tests/support/no_allocation.h"

using namespace rob;
using Kind = motion::MotionEvent::Kind;
using motion::PositionError;

namespace {

constexpr double kCycle = 0.01;  // s, of the gantry

motion::SettleWindow within_mm(double distance, double time = 1) {
  motion::SettleWindow window;
  window.distance = distance / 1000;
  window.time = time;
  return window;
}

/// s, when the effect acted; below 0: it has not.
template <typename Run>
double acted(const Run& run, std::uint32_t id) {
  for (const motion::MotionEvent& event : run.all(Kind::EffectDue))
    if (event.effect.id == id) return event.time;
  return -1;
}

/// Two motions, an effect before the stop and one behind it, and a motion that follows.
template <typename Run, typename Stop>
void give(Run& run, Stop stop) {
  run.move(40, 0, 0);
  run.effect(1);
  run.move(80, 0, 0);
  run.effect(2);
  stop();
  run.effect(3);
  run.move(40, 0, 0);
  run.stop();
  run.close();
}

/// Steps until the axes stand at x, mm, and for some periods more.
template <typename Run>
double rest_at(Run& run, double x, int more) {
  while (std::abs(run.samples().empty() ? 1 : run.samples().back().reference.q[0] - x / 1000) > 0)
    run.step();
  const double rest = run.samples().back().reference.time;
  for (int i = 0; i < more; ++i) run.step();
  return rest;
}

template <typename Run>
void check_waits(Run& run) {
  run.behind_mm = 0.2;
  const double rest = rest_at(run, 80, 20);
  CHECK(acted(run, 1) > 0);
  CHECK(acted(run, 1) < rest);
  CHECK(acted(run, 2) < 0);
  CHECK(acted(run, 3) < 0);
  CHECK(run.samples().back().reference.q[0] == doctest::Approx(0.08));
  run.behind_mm = 0.05;
  run.step();  // 0.15 mm in 10 ms: on its way through
  CHECK(acted(run, 2) < 0);
  const double seen = run.samples().back().reference.time;  // of the cycle that looks next
  run.step();
  CHECK(acted(run, 2) == doctest::Approx(seen).epsilon(1e-12));
  CHECK(acted(run, 3) == doctest::Approx(seen).epsilon(1e-12));
  run.step();
  CHECK(run.samples().back().reference.q[0] < 0.08);
  run.behind_mm = 0.2;  // the last stop waits for nothing
  run.finish();
  CHECK(run.all(Kind::Finished).size() == 1);
}

}  // namespace

TEST_CASE("what stands behind a stop with a window waits for the measured axes, under Paul's law") {
  test::GantryRun run;
  give(run, [&] { run.stop(0, within_mm(0.1)); });
  check_waits(run);
}

TEST_CASE("what stands behind a stop with a window waits for the measured axes, looking ahead") {
  test::LookAheadRun run;
  give(run, [&] { run.stop(within_mm(0.1)); });
  check_waits(run);
}

TEST_CASE("axes that pass through the window are not in position, those that creep in it are") {
  test::GantryRun run;
  give(run, [&] { run.stop(0, within_mm(0.1)); });
  run.behind_mm = 0.5;
  rest_at(run, 80, 2);
  for (run.behind_mm = 0.3; run.behind_mm > -0.4; run.behind_mm -= 0.021) run.step();
  CHECK(acted(run, 3) < 0);  // 2.1 mm/s: 0.1 mm in less than 50 ms
  for (run.behind_mm = 0.3; run.behind_mm > 0; run.behind_mm -= 0.019) run.step();
  CHECK(acted(run, 3) > 0);  // 1.9 mm/s
}

TEST_CASE("who is in position when the reference comes to rest loses no time") {
  test::GantryRun with;
  give(with, [&] { with.stop(0, within_mm(0.1)); });
  test::GantryRun without;
  give(without, [&] { without.stop(); });
  with.finish();
  without.finish();
  CHECK(with.all(Kind::Finished).front().time == without.all(Kind::Finished).front().time);
  for (const std::uint32_t id : {1U, 2U, 3U}) CHECK(acted(with, id) == acted(without, id));
}

TEST_CASE("when the time is over nothing more begins, and what stands behind does not act") {
  test::GantryRun run;
  give(run, [&] { run.stop(0, within_mm(0.1, 0.3)); });
  run.behind_mm = 0.2;
  const double rest = rest_at(run, 80, 60);
  REQUIRE(run.all(Kind::Unsettled).size() == 1);
  const motion::MotionEvent event = run.all(Kind::Unsettled).front();
  CHECK(event.time == doctest::Approx(rest + 0.3).epsilon(kCycle));
  CHECK(event.off.kind == PositionError::Kind::Place);
  CHECK(event.off.value == doctest::Approx(0.2e-3));
  CHECK(event.off.limit == doctest::Approx(0.1e-3));
  CHECK(acted(run, 2) < 0);
  CHECK(acted(run, 3) < 0);
  CHECK(run.samples().back().reference.q[0] == doctest::Approx(0.08));
}

TEST_CASE("a hold stops the time in which the axes have to come into position") {
  test::GantryRun run;
  give(run, [&] { run.stop(0, within_mm(0.1, 0.3)); });
  run.behind_mm = 0.2;
  rest_at(run, 80, 10);
  run.generator().hold();
  for (int i = 0; i < 100; ++i) run.step();
  CHECK(run.all(Kind::Unsettled).empty());
  run.behind_mm = 0;
  for (int i = 0; i < 10; ++i) run.step();
  CHECK(acted(run, 3) < 0);  // a held robot does not go on
  run.generator().resume();
  run.finish();
  CHECK(acted(run, 3) > 0);
}

TEST_CASE("waiting for the measured axes takes no memory") {
  test::GantryRun run;
  give(run, [&] { run.stop(0, within_mm(0.1)); });
  run.behind_mm = 0.2;
  rest_at(run, 80, 3);
  motion::CycleView view;
  view.reference = view.measured = run.samples().back().reference.q;
  view.measured[0] -= 0.0002;
  const test::NoAllocation guard;
  for (std::int64_t k = run.period() + 1; k < run.period() + 20; ++k) {
    view.time = static_cast<double>(k) * kCycle;
    run.generator().look(view);
    run.generator().advance(k);
  }
  CHECK(guard.count() == 0);
}

TEST_CASE("a robot is in position if its tool's place and turn are, and its rotary axes") {
  const motion::RobotModel gantry = motion::embedded_robot("gantry");
  const auto at = [&](motion::SettleWindow window, double x, double y, double theta) {
    return motion::position_error(gantry, window, test::gantry_q(x, y, theta),
                                  test::gantry_q(0, 0, 0));
  };
  CHECK(at(within_mm(5), 3, 4, 90).kind == PositionError::Kind::None);  // hypot(3, 4) = 5
  CHECK(at(within_mm(4.99), 3, 4, 0).value == doctest::Approx(5e-3));
  motion::SettleWindow turn;
  turn.angle = 1 * test::kDegree;
  CHECK(at(turn, 90, 90, 0.99).kind == PositionError::Kind::None);
  CHECK(at(turn, 0, 0, -1.01).kind == PositionError::Kind::Turn);
  CHECK(at(turn, 0, 0, -1.01).axis == -1);  // of the tool, not of an axis
  CHECK(at(within_mm(4.99), 3, 4, 0).axis == -1);
  CHECK(at(turn, 0, 0, -1.01).value == doctest::Approx(1.01 * test::kDegree));
  motion::SettleWindow swung = within_mm(1);  // a tip 100 mm off the axis: 1 deg is 1.745 mm
  swung.tip = {0.1, 0, 0};
  CHECK(at(swung, 0, 0, 0.57).kind == PositionError::Kind::None);
  CHECK(at(swung, 0, 0, 0.58).value == doctest::Approx(0.2 * std::sin(0.29 * test::kDegree)));
  // The gripper of the SO-101 turns no tool.
  const motion::RobotModel so101 = motion::embedded_robot("so101");
  motion::JointVector q = so101.start;
  q[5] += 2 * test::kDegree;
  const PositionError off = motion::position_error(so101, turn, q, so101.start);
  CHECK(off.kind == PositionError::Kind::Axis);
  CHECK(off.axis == 5);
  // No number is in no window.
  q[5] = std::nan("");
  CHECK(motion::position_error(so101, turn, q, so101.start).kind != PositionError::Kind::None);
}
