#include <doctest/doctest.h>

#include <cmath>

#include "motion/robots/time_scaling.h"
#include "tests/motion/generate/gantry_run.h"
#include "tests/support/no_allocation.h"

using namespace rob::motion;
using namespace rob::test;
using Kind = MotionEvent::Kind;

namespace {

MotionRequest zoned(double x_mm, double y_mm, double t_acc) {
  MotionRequest request = move_to(gantry_q(x_mm, y_mm, 0));
  request.zone = MotionRequest::Zone::Time;
  request.zone_value = t_acc;
  return request;
}

/// There and back along x with the tightest corners, held at the given period.
double greatest_acceleration(std::int64_t held_at) {
  GantryRun run;
  for (int k = 0; k < 4; ++k) run.move(zoned(k % 2 == 0 ? 40 : 0, 0, 0.01));
  run.close();
  double most = 0;
  for (std::int64_t period = 0; period < 1500; ++period) {
    if (period == held_at) run.generator().hold();
    most = std::max(most, std::abs(run.step().reference.qdd[0]));
  }
  CHECK(run.all(Kind::Held).size() == 1);
  return most;
}

}  // namespace

TEST_CASE("a hold in or before the tightest corner keeps every axis within its acceleration") {
  const double a_max = embedded_robot("gantry").axes[0].a_max;
  for (std::int64_t period = 300; period < 460; period += 7) {
    CAPTURE(period);
    CHECK(greatest_acceleration(period) <= a_max * (1 + 1e-9));
  }
}

TEST_CASE("a tighter corner that becomes known while the robot slows down is made exact") {
  GantryRun run;
  run.move(40, 0, 0);
  for (int k = 0; k < 268; ++k) run.step();
  run.generator().set_override(0.2);
  run.step();
  run.move(zoned(40, 40, 0.4));
  for (int k = 0; k < 60; ++k) run.step();
  CHECK(run.saw(Kind::LateDecision));
  run.generator().set_override(1);
  run.close();
  run.finish();
  CHECK(run.samples().back().reference.q == gantry_q(40, 40, 0));
}

TEST_CASE("corners of their own take no memory in the tick") {
  GantryRun run;
  for (int k = 0; k < 4; ++k) run.move(zoned(k % 2 == 0 ? 40 : 0, 0, 0.4 + 0.1 * k));
  run.close();
  const NoAllocation guard;
  for (std::int64_t period = 1; period < 1500; ++period) run.generator().advance(period);
  CHECK(guard.count() == 0);
}
