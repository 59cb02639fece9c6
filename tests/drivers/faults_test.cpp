#include <doctest/doctest.h>

#include <cmath>

#include "drivers/sim/sim_gantry.h"
#include "tests/drivers/gantry_bench.h"
#include "tests/support/faulty_backend.h"
#include "tests/support/relative.h"

// Supervision on a machine that goes wrong while x, y and θ move.

namespace rob::drivers {
namespace {

using motion::FollowingFinding;
using test::FaultyBackend;
using Verdict = FollowingFinding::Verdict;
using Cause = FollowingFinding::Cause;

constexpr double kFaultAt = 2.0;  // at 20 mm/s along x, 10 mm/s along y

struct Caught {
  FollowingFinding warning;  // the first
  FollowingFinding stop;
  int findings_before = 0;
  double after = 0;  // s from the fault to the stop
};

Caught run_into(FaultyBackend::Fault fault, int axis) {
  SimGantry gantry(test::gantry_parameters());
  FaultyBackend machine(gantry);
  test::GantryBench bench(machine, test::gantry_drives());
  machine.inject(fault, kFaultAt, axis);
  Caught caught;
  while (bench.now() < test::kShuttleTime) {
    const double t = bench.now();
    const FollowingFinding found = bench.cycle(test::shuttle(t));
    if (found.verdict == Verdict::None) continue;
    if (t < kFaultAt - 1e-9) ++caught.findings_before;
    if (found.verdict == Verdict::Warn && caught.warning.verdict == Verdict::None)
      caught.warning = found;
    if (found.verdict != Verdict::Stop) continue;
    caught.stop = found;
    caught.after = t - kFaultAt;
    break;
  }
  CHECK(caught.findings_before == 0);
  return caught;
}

}  // namespace

TEST_CASE("a machine without a fault runs to the end") {
  const Caught caught = run_into(FaultyBackend::Fault::None, 0);
  CHECK(caught.stop.verdict == Verdict::None);
  CHECK(caught.warning.verdict == Verdict::None);
}

TEST_CASE("fault 18: a locked joint warns at half the limit and stops at the limit") {
  // At full speed the limit is 1 mm along x: 50 ms of way. At half speed 0.5 mm along y: 50 ms too.
  for (const int axis : {0, 1}) {
    const double limit = axis == 0 ? 0.001 : 0.0005;
    const Caught caught = run_into(FaultyBackend::Fault::LockedJoint, axis);
    CHECK(caught.warning.cause == Cause::FollowingError);
    CHECK(caught.warning.axis == axis);
    CHECK(caught.warning.value > 0.5 * limit);
    CHECK(caught.warning.value < 0.75 * limit);
    CHECK(caught.stop.cause == Cause::FollowingError);
    CHECK(caught.stop.axis == axis);
    CHECK(caught.stop.limit == test::relative(limit));
    CHECK(caught.after <= 0.050 + 3 * test::kServoPeriod);
  }
}

TEST_CASE("fault 19: a frozen encoder is found before the axis runs away") {
  // 20 counts + 2·0.3 N/(19200 N/m) = 51 µm: less than three cycles' way at these speeds.
  for (const int axis : {0, 1}) {
    const Caught caught = run_into(FaultyBackend::Fault::FrozenEncoder, axis);
    CHECK(caught.stop.cause == Cause::Frozen);
    CHECK(caught.stop.axis == axis);
    CHECK(caught.after <= 3 * test::kServoPeriod + 1e-9);
    CHECK(caught.warning.verdict == Verdict::None);
  }
  CHECK(run_into(FaultyBackend::Fault::FrozenEncoder, 2).stop.cause == Cause::Frozen);
}

TEST_CASE("fault 19: an encoder that jumps is found in the same cycle") {
  for (const int axis : {0, 1, 2}) {
    const Caught caught = run_into(FaultyBackend::Fault::JumpingEncoder, axis);
    CHECK(caught.stop.cause == Cause::Jump);
    CHECK(caught.stop.axis == axis);
    CHECK(caught.after < 1e-9);
  }
}

TEST_CASE("fault 7: a measurement that is no number is found in the same cycle") {
  const Caught caught = run_into(FaultyBackend::Fault::NotANumber, 2);
  CHECK(caught.stop.cause == Cause::NotFinite);
  CHECK(caught.stop.axis == 2);
  CHECK(caught.after < 1e-9);
}

TEST_CASE("a measurement that is no number never becomes a force") {
  SimGantry gantry(test::gantry_parameters());
  FaultyBackend machine(gantry);
  test::GantryBench bench(machine, test::gantry_drives());
  machine.inject(FaultyBackend::Fault::NotANumber, kFaultAt, 1);
  while (bench.now() < kFaultAt + 0.1) bench.cycle(test::shuttle(bench.now()));
  CHECK(std::isnan(bench.state().measured.q[1]));
  CHECK(bench.command().drive[1] == 0);
  CHECK(bench.command().drive[0] != 0);
}

TEST_CASE("fault 28: a machine that falls silent stops the run within three periods") {
  const Caught caught = run_into(FaultyBackend::Fault::Silent, 0);
  CHECK(caught.stop.cause == Cause::Silent);
  CHECK(caught.stop.axis == -1);
  CHECK(caught.after <= 2 * test::kServoPeriod + 1e-9);
}

TEST_CASE("fault 23: a machine that is gone stops the run at once") {
  const Caught caught = run_into(FaultyBackend::Fault::Lost, 0);
  CHECK(caught.stop.cause == Cause::Lost);
  CHECK(caught.after < 1e-9);
}

}  // namespace rob::drivers
