#include "motion/servo/following_supervisor.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "tests/motion/servo/two_axes.h"
#include "tests/support/no_allocation.h"
#include "tests/support/relative.h"

namespace rob::motion {
namespace {

using test::both;

using Verdict = FollowingFinding::Verdict;
using Cause = FollowingFinding::Cause;

constexpr double kServoPeriod = 0.005;
constexpr double kCount = 1e-6;

// 12 kg at 40 rad/s: kp = 19200 N/m; 0.48 N of Coulomb friction are 25 µm, 40 mm/s² as much. A
// reference may thus go 20 counts + 75 µm + 25 µm = 120 µm before a count is due.
DriveData drive() {
  DriveData d;
  d.inertia = 12;
  d.coulomb_friction = 0.48;
  d.force_max = 60;
  d.encoder_resolution = kCount;
  d.bandwidth = 40;
  d.following_warn = 0.0005;
  d.following_limit = 0.001;
  return d;
}

const JointVector kSpeedLimits = JointVector::Constant(2, 0.020);
const JointVector kAccelerationLimits = JointVector::Constant(2, 0.040);

// Two axes, both at 0 with their reference at 0, at t = 0.
FollowingSupervisor supervisor_at_rest() {
  FollowingSupervisor supervisor(std::vector{drive(), drive()}, kSpeedLimits, kAccelerationLimits,
                                 kServoPeriod);
  const JointVector zero = both(0, 0);
  supervisor.reset({0, zero, zero, zero}, {0, zero, zero});
  return supervisor;
}

FollowingFinding check(FollowingSupervisor& supervisor, double t, const JointVector& q0,
                       const JointVector& v0, const JointVector& q) {
  return supervisor.check(DriverStatus::Ok, {t, q0, v0, both(0, 0)}, q0, {t, q, both(0, 0)});
}

// One check of the second axis, which is `error` behind a reference of velocity v0.
FollowingFinding with_error(double error, double v0) {
  FollowingSupervisor supervisor = supervisor_at_rest();
  const JointVector at = both(0, 0.0001);
  return check(supervisor, kServoPeriod, both(0, 0.0001 + error), both(0, v0), at);
}

}  // namespace

TEST_CASE("a machine that follows raises nothing") {
  FollowingSupervisor supervisor = supervisor_at_rest();
  for (int k = 1; k < 1000; ++k) {
    const double t = k * kServoPeriod;
    const JointVector q0 = both(0.02 * t, -0.01 * t);
    CHECK(check(supervisor, t, q0, both(0.02, -0.01), q0 - both(1e-5, 1e-5)).verdict ==
          Verdict::None);
  }
}

TEST_CASE("fault 18: the following error warns at half its limit and stops at it") {
  CHECK(with_error(0.000249, 0).verdict == Verdict::None);
  const FollowingFinding warning = with_error(0.000251, 0);
  CHECK(warning.verdict == Verdict::Warn);
  CHECK(warning.cause == Cause::FollowingError);
  CHECK(warning.axis == 1);
  CHECK(warning.value == test::relative(0.000251));
  CHECK(warning.limit == test::relative(0.0005));
  CHECK(with_error(0.000499, 0).verdict == Verdict::Warn);
  const FollowingFinding stop = with_error(-0.000501, 0);
  CHECK(stop.verdict == Verdict::Stop);
  CHECK(stop.cause == Cause::FollowingError);
  CHECK(stop.value == test::relative(0.000501));
}

TEST_CASE("fault 18: the limit grows with speed, from half the greatest speed on") {
  CHECK(with_error(0.000501, 0.010).verdict == Verdict::Stop);
  CHECK(with_error(0.000501, -0.0101).verdict == Verdict::Warn);
  CHECK(with_error(0.000749, 0.015).limit == test::relative(0.00075));
  CHECK(with_error(0.000999, -0.020).verdict == Verdict::Warn);
  CHECK(with_error(0.001001, 0.020).verdict == Verdict::Stop);
}

TEST_CASE("fault 19: an encoder without a count while the reference moves is frozen") {
  for (const double speed : {0.020, 0.0001}) {
    FollowingSupervisor supervisor = supervisor_at_rest();
    FollowingFinding found;
    double way = 0;
    for (int k = 1; found.verdict == Verdict::None; ++k) {
      way = speed * k * kServoPeriod;
      found = check(supervisor, k * kServoPeriod, both(way, 0), both(speed, 0), both(0, 0));
    }
    CHECK(found.verdict == Verdict::Stop);
    CHECK(found.cause == Cause::Frozen);
    CHECK(found.axis == 0);
    const double three_cycles = 3 * speed * kServoPeriod;
    CHECK(way > 120e-6 * (1 - 1e-9));
    CHECK(way <= std::max(120e-6 + speed * kServoPeriod, three_cycles) * (1 + 1e-9));
  }
}

TEST_CASE("a jump is measured against the longest time that may have passed") {
  // 2·0.020 m/s·(5 ms + 2 ms + 1 ms) = 0.32 mm
  for (const double step : {0.319e-3, 0.321e-3}) {
    FollowingSupervisor supervisor = supervisor_at_rest();
    const JointReference reference{0, both(0, 0), both(0, 0), both(0, 0)};
    supervisor.check(DriverStatus::Ok, reference, reference.q,
                     {kServoPeriod, both(0, 0), both(0, 0)}, 0.002);
    const FollowingFinding found =
        supervisor.check(DriverStatus::Ok, reference, reference.q,
                         {2 * kServoPeriod, both(step, 0), both(0, 0)}, 0.001);
    CHECK((found.cause == Cause::Jump) == (step > 0.32e-3));
  }
}

TEST_CASE("a drive that repeats an answer twice is not taken for frozen") {
  FollowingSupervisor supervisor = supervisor_at_rest();
  for (int k = 1; k < 100; ++k) {
    const double q0 = 0.020 * k * kServoPeriod;
    const double old = 0.020 * (k - k % 3) * kServoPeriod;
    CHECK(check(supervisor, k * kServoPeriod, both(q0, 0), both(0.02, 0), both(old, 0)).cause !=
          Cause::Frozen);
  }
}

TEST_CASE("no motion is so slow that it looks like a frozen encoder") {
  // One count every 20 s, behind by all that friction can hold.
  FollowingSupervisor supervisor = supervisor_at_rest();
  const double speed = 50e-9;
  for (int k = 1; k < 100000; ++k) {
    const double q0 = speed * k * kServoPeriod;
    const double q = std::floor(std::max(0.0, q0 - 25e-6) / kCount) * kCount;
    REQUIRE(check(supervisor, k * kServoPeriod, both(q0, 0), both(speed, 0), both(q, 0)).verdict ==
            Verdict::None);
  }
}

TEST_CASE("a reference that comes back to an axis that lags behind asks for no count") {
  FollowingSupervisor supervisor = supervisor_at_rest();
  const double lag = 240e-6;  // no warning yet
  CHECK(check(supervisor, kServoPeriod, both(lag, 0), both(0, 0), both(0, 0)).cause !=
        Cause::Frozen);
  int k = 2;
  for (double q0 = lag; q0 > 0; q0 -= 60e-6, ++k) {
    CHECK(
        check(supervisor, k * kServoPeriod, both(q0, 0), both(-0.012, 0), both(1e-6, 0)).verdict ==
        Verdict::None);
  }
  // It then leaves to the other side: what counts is the way from where it met the axis.
  const FollowingFinding found =
      check(supervisor, k * kServoPeriod, both(-122e-6, 0), both(-0.012, 0), both(1e-6, 0));
  CHECK(found.cause == Cause::Frozen);
}

TEST_CASE("an axis that is held at rest may stand for ever") {
  FollowingSupervisor supervisor = supervisor_at_rest();
  for (int k = 1; k < 1000; ++k) {
    const double wobble = (k % 2 == 0) ? 60e-6 : 0;  // below what must move it
    CHECK(check(supervisor, k * kServoPeriod, both(wobble, 0), both(0, 0), both(0, 0)).verdict ==
          Verdict::None);
  }
}

TEST_CASE("fault 19: no axis moves more than twice its greatest speed allows") {
  // 2·20 mm/s·5 ms = 0.2 mm
  FollowingSupervisor supervisor = supervisor_at_rest();
  CHECK(check(supervisor, kServoPeriod, both(0, 0.0001), both(0, 0), both(0, 0.000199)).verdict ==
        Verdict::None);
  const FollowingFinding jump =
      check(supervisor, 2 * kServoPeriod, both(0, 0.0002), both(0, 0), both(0, -0.000002));
  CHECK(jump.verdict == Verdict::Stop);
  CHECK(jump.cause == Cause::Jump);
  CHECK(jump.axis == 1);
  CHECK(jump.value == test::relative(0.000201));
  CHECK(jump.limit == test::relative(0.0002));
}

TEST_CASE("fault 19: what an axis lags behind its goal it may make up at once, and no more") {
  // The goal is 0.4 mm ahead after a late command; 2·20 mm/s·5 ms = 0.2 mm beyond it is credible.
  for (const double place : {0.0004, 0.000599, 0.000601, -0.000199, -0.000201}) {
    FollowingSupervisor supervisor = supervisor_at_rest();
    const FollowingFinding found =
        check(supervisor, kServoPeriod, both(0.0004, 0), both(0, 0), both(place, 0));
    const bool jumps = place > 0.0006 || place < -0.0002;
    CHECK((found.cause == Cause::Jump) == jumps);
    if (jumps) CHECK(found.value == test::relative(0.000201));
  }
}

TEST_CASE("after a late cycle an axis may have gone further") {
  FollowingSupervisor supervisor = supervisor_at_rest();
  CHECK(
      check(supervisor, 4 * kServoPeriod, both(0.0006, 0), both(0, 0), both(0.00079, 0)).verdict ==
      Verdict::None);
}

TEST_CASE("fault 7: what is not a number is found, whichever value it is") {
  const double bad[] = {std::numeric_limits<double>::quiet_NaN(),
                        std::numeric_limits<double>::infinity()};
  for (const double value : bad) {
    for (int where = 0; where < 5; ++where) {
      JointVector v[5] = {both(0, 0), both(0, 0), both(0, 0), both(0, 0), both(0, 0)};
      v[where][1] = value;
      FollowingSupervisor supervisor = supervisor_at_rest();
      const FollowingFinding found = supervisor.check(
          DriverStatus::Ok, {kServoPeriod, v[0], v[1], v[2]}, v[0], {kServoPeriod, v[3], v[4]});
      CHECK(found.verdict == Verdict::Stop);
      CHECK(found.cause == Cause::NotFinite);
      CHECK(found.axis == 1);
    }
  }
}

TEST_CASE("the gravest finding is reported, of equals that of the lowest axis") {
  FollowingSupervisor supervisor = supervisor_at_rest();
  const JointVector q = both(0.0001, 0.0001);
  const FollowingFinding found =
      check(supervisor, kServoPeriod, q + both(0.0003, 0.0006), both(0, 0), q);
  CHECK(found.verdict == Verdict::Stop);
  CHECK(found.axis == 1);
  CHECK(check(supervisor, 2 * kServoPeriod, q + both(0.0006, 0.0007), both(0, 0), q).axis == 0);
}

TEST_CASE("a machine may miss two answers in a row, not three") {
  FollowingSupervisor supervisor = supervisor_at_rest();
  const JointVector zero = both(0, 0);
  const JointReference reference{0, zero, zero, zero};
  const JointMeasurement stale{0, zero, zero};
  const auto silent = [&] {
    return supervisor.check(DriverStatus::Silent, reference, reference.q, stale);
  };
  for (int round = 0; round < 3; ++round) {
    CHECK(silent().verdict == Verdict::None);
    CHECK(silent().verdict == Verdict::None);
    CHECK(supervisor.check(DriverStatus::Ok, reference, reference.q, stale).verdict ==
          Verdict::None);
  }
  silent();
  silent();
  const FollowingFinding found = silent();
  CHECK(found.verdict == Verdict::Stop);
  CHECK(found.cause == Cause::Silent);
  CHECK(found.axis == -1);
  CHECK(silent().verdict == Verdict::Stop);
}

TEST_CASE(
    "an answer that is not due yet, and a computer that is late, are not counted as silence") {
  FollowingSupervisor supervisor = supervisor_at_rest();
  const JointVector zero = both(0, 0);
  const JointReference reference{0, zero, zero, zero};
  const JointMeasurement stale{0, zero, zero};
  const auto status = [&](DriverStatus value) {
    return supervisor.check(value, reference, reference.q, stale);
  };
  for (int i = 0; i < 10; ++i) {
    CHECK(status(DriverStatus::Pending).verdict == Verdict::None);
    CHECK(status(DriverStatus::Late).verdict == Verdict::None);
  }
  // In between they do not make silence good.
  status(DriverStatus::Silent);
  status(DriverStatus::Pending);
  status(DriverStatus::Silent);
  status(DriverStatus::Late);
  CHECK(status(DriverStatus::Silent).cause == Cause::Silent);
}

TEST_CASE("a machine that is gone stops the run at once") {
  FollowingSupervisor supervisor = supervisor_at_rest();
  const FollowingFinding found = supervisor.check(DriverStatus::Lost, {}, {}, {});
  CHECK(found.verdict == Verdict::Stop);
  CHECK(found.cause == Cause::Lost);
}

TEST_CASE("reset believes what is measured now") {
  FollowingSupervisor supervisor = supervisor_at_rest();
  const JointVector there = both(0.3, 0.2);
  supervisor.reset({9, there, both(0, 0), both(0, 0)}, {9, there, both(0, 0)});
  CHECK(check(supervisor, 9 + kServoPeriod, there, both(0, 0), there).verdict == Verdict::None);
}

TEST_CASE("supervision takes no memory") {
  FollowingSupervisor supervisor = supervisor_at_rest();
  const JointReference reference{0, both(0, 0), both(0, 0), both(0, 0)};
  const JointMeasurement at{0, both(0, 0), both(0, 0)};
  test::NoAllocation guard;
  supervisor.reset(reference, at);
  const FollowingFinding found = supervisor.check(DriverStatus::Ok, reference, reference.q, at);
  CHECK(guard.count() == 0);
  CHECK(found.verdict == Verdict::None);
}

}  // namespace rob::motion
