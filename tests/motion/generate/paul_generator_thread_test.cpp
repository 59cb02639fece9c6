#include <doctest/doctest.h>

#include <atomic>
#include <thread>

#include "tests/motion/generate/gantry_run.h"

using namespace rob::motion;
using namespace rob::test;
using Kind = MotionEvent::Kind;

TEST_CASE("a program in another thread, however slow, leaves no motion out and makes no jump") {
  constexpr std::uint32_t kMoves = 200;
  const RobotModel robot = embedded_robot("gantry");
  LookAheadBuffer buffer(4);
  PaulGenerator generator(robot, buffer, robot.start);

  std::thread program([&] {
    MotionPlanner planner(robot, robot.start);
    RandomTargets targets(robot, 23);
    for (std::uint32_t n = 1; n <= kMoves; ++n) {
      while (buffer.full()) std::this_thread::yield();
      buffer.push(std::get<PlannedSegment>(planner.plan(move_to(targets.next()))).segment);
      Effect effect;
      effect.id = n;
      effect.after = n;
      buffer.push(effect);
      // An observation now and then: the program waits for the decision point.
      while (n % 10 == 0 && generator.decidable() < n) std::this_thread::yield();
    }
    if (const auto stop = planner.stop(0)) {
      while (buffer.full()) std::this_thread::yield();
      buffer.push(*stop);
    }
    buffer.close();
  });

  std::uint32_t started = 0;
  std::uint32_t effects = 0;
  int wrong = 0;
  bool finished = false;
  JointVector last = robot.start;
  for (std::int64_t period = 0; !finished; ++period) {
    const JointVector& q = generator.advance(period).reference.q;
    for (int i = 0; i < 3; ++i) {
      const double v_max = robot.axes[static_cast<std::size_t>(i)].v_max;
      if (std::abs(q[i] - last[i]) > v_max * robot.reference_period * (1 + 1e-9)) ++wrong;
    }
    last = q;
    MotionEvent event;
    while (generator.take_event(event)) {
      if (event.kind == Kind::SegmentStarted && event.number != ++started) ++wrong;
      if (event.kind == Kind::EffectDue && event.effect.id != ++effects) ++wrong;
      finished = finished || event.kind == Kind::Finished;
    }
  }
  program.join();
  CHECK(wrong == 0);
  CHECK(started >= kMoves);
  CHECK(effects == kMoves);
}
