#include "motion/servo/reference_interpolator.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "tests/motion/servo/two_axes.h"
#include "tests/support/no_allocation.h"

namespace rob::motion {
namespace {

using test::both;

constexpr double kReferencePeriod = 0.01;

const JointVector kMostSpeed = both(0.02, 0.35);
const JointVector kMostAcceleration = both(0.1, 1.75);
const JointVector kMostJerk = both(1, 17.5);

double stamp(int k) { return k * kReferencePeriod; }

// A smooth motion inside the limits: 9 mm·sin 2t and 0.15 rad·(1 − cos 2t).
JointReference on_path(double t) {
  const double s = std::sin(2 * t);
  const double c = std::cos(2 * t);
  return {t, both(0.009 * s, 0.15 * (1 - c)), both(0.018 * c, 0.3 * s), both(-0.036 * s, 0.6 * c)};
}

bool same_to_the_bit(const JointReference& a, const JointReference& b) {
  return a.time == b.time && a.q == b.q && a.qd == b.qd && a.qdd == b.qdd;
}

ReferenceInterpolator standing_at_start() {
  ReferenceInterpolator interpolator(kReferencePeriod, kMostSpeed, kMostAcceleration, kMostJerk);
  interpolator.reset({0, both(0, 0), both(0, 0), both(0, 0)});
  return interpolator;
}

// Follows `reference_at`, which reaches the interpolator one period before its stamp, but for those
// of stamps in (from, from + missing]. Samples every millisecond up to `end`.
template <typename Path>
std::vector<JointReference> run_with_gap(ReferenceInterpolator& interpolator, Path reference_at,
                                         int from, int missing, int end) {
  std::vector<JointReference> sent;
  for (int k = 0; k < end; ++k) {
    const bool lost = k + 1 > from && k + 1 <= from + missing;
    if (!lost) interpolator.push(reference_at(stamp(k + 1)));
    for (int ms = 0; ms < 10; ++ms) sent.push_back(interpolator.at(stamp(k) + 0.001 * ms));
  }
  return sent;
}

struct Worst {
  JointVector speed = both(0, 0);
  JointVector position_jump = both(0, 0);  // beyond what the speeds at both ends explain
  JointVector acceleration = both(0, 0);   // change of speed over time
};

Worst worst_of(const std::vector<JointReference>& sent, std::size_t first) {
  Worst worst;
  for (std::size_t n = first + 1; n < sent.size(); ++n) {
    const double h = sent[n].time - sent[n - 1].time;
    const JointVector mean = 0.5 * (sent[n].qd + sent[n - 1].qd);
    const JointVector jump = (sent[n].q - sent[n - 1].q - mean * h).cwiseAbs();
    const JointVector rate = (sent[n].qd - sent[n - 1].qd).cwiseAbs() / h;
    worst.speed = worst.speed.cwiseMax(sent[n].qd.cwiseAbs());
    worst.position_jump = worst.position_jump.cwiseMax(jump);
    worst.acceleration = worst.acceleration.cwiseMax(rate);
  }
  return worst;
}

}  // namespace

TEST_CASE("at its stamp a reference is sent bit for bit") {
  ReferenceInterpolator interpolator = standing_at_start();
  interpolator.push(on_path(stamp(1)));
  for (int k = 1; k < 300; ++k) {
    interpolator.push(on_path(stamp(k + 1)));
    CHECK(same_to_the_bit(interpolator.at(stamp(k)), on_path(stamp(k))));
  }
  CHECK(interpolator.starved() == 0);
}

TEST_CASE("between stamps the axes follow the path, with its velocity and acceleration") {
  ReferenceInterpolator interpolator = standing_at_start();
  interpolator.push(on_path(stamp(1)));
  interpolator.push(on_path(stamp(2)));
  for (int k = 1; k < 300; ++k) {
    for (int i = 0; i < 10; ++i) {
      const double now = stamp(k) + 0.001 * i;
      const JointReference sent = interpolator.at(now);
      const JointReference path = on_path(now);
      // The quintic's error is h⁶/46080 of the sixth derivative: far below a nanometre.
      CHECK((sent.q - path.q).cwiseAbs().maxCoeff() < 1e-14);
      CHECK((sent.qd - path.qd).cwiseAbs().maxCoeff() < 1e-11);
      CHECK((sent.qdd - path.qdd).cwiseAbs().maxCoeff() < 1e-8);
    }
    interpolator.push(on_path(stamp(k + 2)));
  }
}

TEST_CASE("a servo that wakes up late goes on where the path is by then") {
  ReferenceInterpolator interpolator = standing_at_start();
  interpolator.push(on_path(stamp(1)));
  interpolator.push(on_path(stamp(2)));
  interpolator.at(stamp(1));
  for (int k = 3; k <= 40; ++k) interpolator.push(on_path(stamp(k)));
  const double now = stamp(39) + 0.004;
  CHECK((interpolator.at(now).q - on_path(now).q).cwiseAbs().maxCoeff() < 1e-14);
  CHECK(interpolator.starved() == 0);
  CHECK_FALSE(interpolator.joining());
}

TEST_CASE("up to three skipped stamps are bridged by one curve") {
  ReferenceInterpolator interpolator = standing_at_start();
  interpolator.push(on_path(stamp(1)));
  interpolator.push(on_path(stamp(5)));
  for (double now = stamp(1); now <= stamp(5); now += 0.001)
    CHECK((interpolator.at(now).q - on_path(now).q).cwiseAbs().maxCoeff() < 1e-10);
  CHECK(interpolator.starved() == 0);
}

TEST_CASE("reset means: stand there, whatever was asked before") {
  ReferenceInterpolator interpolator = standing_at_start();
  interpolator.push(on_path(stamp(1)));
  interpolator.reset({7.0, both(0.1, 0.2), both(1, 1), both(1, 1)});
  for (const double now : {7.0, 7.005, 20.0}) {
    const JointReference sent = interpolator.at(now);
    CHECK(sent.time == now);
    CHECK(sent.q == both(0.1, 0.2));
    CHECK(sent.qd.isZero(0));
    CHECK(sent.qdd.isZero(0));
  }
  CHECK(interpolator.starved() == 0);
}

TEST_CASE("a reference that is not a number, or not later, is never sent") {
  ReferenceInterpolator interpolator = standing_at_start();
  CHECK(interpolator.push(on_path(stamp(1))));
  JointReference bad = on_path(stamp(2));
  bad.q[1] = std::numeric_limits<double>::quiet_NaN();
  CHECK_FALSE(interpolator.push(bad));
  bad = on_path(stamp(2));
  bad.qdd[0] = std::numeric_limits<double>::infinity();
  CHECK_FALSE(interpolator.push(bad));
  CHECK_FALSE(interpolator.push(on_path(stamp(1))));
  CHECK_FALSE(interpolator.push(on_path(stamp(0))));
  CHECK(interpolator.at(stamp(2)).q.allFinite());
}

TEST_CASE("asked for an instant before all that it keeps, it gives the oldest") {
  ReferenceInterpolator interpolator = standing_at_start();
  for (int k = 1; k <= 20; ++k) interpolator.push(on_path(stamp(k)));
  CHECK(same_to_the_bit(interpolator.at(stamp(2)), on_path(stamp(13))));
}

TEST_CASE("missing references are bridged without a jump, and joined again") {
  for (const int missing : {1, 2, 3, 4, 5, 12, 40}) {
    for (const int from : {20, 78, 120, 157, 200}) {
      CAPTURE(missing);
      CAPTURE(from);
      ReferenceInterpolator interpolator = standing_at_start();
      const auto sent = run_with_gap(interpolator, on_path, from, missing, 1500);
      // From the second period on: the path itself begins with a jump of velocity.
      const Worst worst = worst_of(sent, 20);
      for (int i = 0; i < 2; ++i) {
        // The path's own acceleration, the share that a join may add, and the difference that it
        // finds: ramp against path.
        const double path = i == 0 ? 0.036 : 0.6;
        CHECK(worst.acceleration[i] <=
              path + 0.5 * kMostAcceleration[i] + (kMostAcceleration[i] + path));
        CHECK(worst.position_jump[i] <= 2 * kMostAcceleration[i] * 0.001 * 0.001);
        CHECK(worst.speed[i] <= 1.5 * kMostSpeed[i]);
      }
      CHECK(interpolator.starved() == static_cast<std::uint64_t>(missing));
      CHECK_FALSE(interpolator.joining());
      CHECK(same_to_the_bit(sent[14990], on_path(stamp(1499))));
    }
  }
}

TEST_CASE("catching up at full speed exceeds it by no more than a tenth") {
  const auto at_v_max = [](double t) {
    return JointReference{t, kMostSpeed * t, kMostSpeed, both(0, 0)};
  };
  for (const int missing : {1, 3, 5, 19}) {
    CAPTURE(missing);
    ReferenceInterpolator interpolator = standing_at_start();
    const auto sent = run_with_gap(interpolator, at_v_max, 20, missing, 3000);
    const Worst worst = worst_of(sent, 20);
    CHECK(worst.speed[0] <= 1.1 * kMostSpeed[0] * (1 + 1e-9));
    CHECK(worst.speed[1] <= 1.1 * kMostSpeed[1] * (1 + 1e-9));
    CHECK(same_to_the_bit(sent[29990], at_v_max(stamp(2999))));
  }
}

TEST_CASE("three missing references at constant speed are not felt at all") {
  const auto at_v_max = [](double t) {
    return JointReference{t, kMostSpeed * t, kMostSpeed, both(0, 0)};
  };
  ReferenceInterpolator interpolator = standing_at_start();
  const auto sent = run_with_gap(interpolator, at_v_max, 20, 3, 100);
  for (std::size_t n = 20; n < sent.size(); ++n)
    CHECK((sent[n].q - kMostSpeed * sent[n].time).cwiseAbs().maxCoeff() < 1e-15);
}

TEST_CASE("after a stall the axes go back to where the references go on") {
  // The generator was stopped for a second and goes on from the last reference sent.
  const auto stalled = [](double t) {
    JointReference r = on_path(t <= stamp(30) ? t : std::max(t - 1.0, stamp(30)));
    r.time = t;
    return r;
  };
  ReferenceInterpolator interpolator = standing_at_start();
  const auto sent = run_with_gap(interpolator, stalled, 30, 100, 1500);
  const Worst worst = worst_of(sent, 20);
  CHECK(worst.acceleration[0] <= 0.036 + 0.5 * kMostAcceleration[0] + kMostAcceleration[0] + 0.036);
  CHECK(worst.position_jump[0] <= 2 * kMostAcceleration[0] * 0.001 * 0.001);
  CHECK(same_to_the_bit(sent[14990], stalled(stamp(1499))));
}

TEST_CASE("a single reference that comes at its own instant is joined from there") {
  ReferenceInterpolator interpolator = standing_at_start();
  interpolator.push(on_path(stamp(1)));
  interpolator.push(on_path(stamp(2)));
  const JointReference before = interpolator.at(stamp(9) - 1e-6);
  interpolator.push(on_path(stamp(9)));
  const JointReference sent = interpolator.at(stamp(9));
  CHECK((sent.q - before.q).cwiseAbs().maxCoeff() < 1e-6);
  CHECK((sent.qd - before.qd).cwiseAbs().maxCoeff() < 1e-5);
  CHECK((sent.q - on_path(stamp(9)).q).cwiseAbs().maxCoeff() > 1e-5);
  CHECK(interpolator.joining());
  CHECK(interpolator.starved() == 7);
}

TEST_CASE("a reference that comes when its instant is past corrects the extrapolation") {
  ReferenceInterpolator interpolator = standing_at_start();
  for (int k = 1; k <= 20; ++k) interpolator.push(on_path(stamp(k)));
  interpolator.at(stamp(20));
  std::vector<JointReference> sent;
  for (int ms = 0; ms < 4000; ++ms) {
    if (ms == 25) interpolator.push(on_path(stamp(21)));
    sent.push_back(interpolator.at(stamp(20) + 0.001 * ms));
  }
  const Worst worst = worst_of(sent, 0);
  CHECK(worst.position_jump[0] <= 2 * kMostAcceleration[0] * 0.001 * 0.001);
  CHECK(worst.acceleration[0] <= 2 * kMostAcceleration[0]);
  ReferenceExtrapolation from_21(kReferencePeriod, kMostSpeed, kMostAcceleration);
  from_21.start(on_path(stamp(21)));
  CHECK(sent.back().q == from_21.at(sent.back().time).q);
  CHECK_FALSE(interpolator.joining());
}

TEST_CASE("a reference that comes a moment late is not counted as starvation") {
  ReferenceInterpolator interpolator = standing_at_start();
  interpolator.push(on_path(stamp(1)));
  for (int k = 1; k < 100; ++k) {
    interpolator.at(stamp(k) + 50e-6);
    interpolator.push(on_path(stamp(k + 1)));
    const double now = stamp(k) + 0.005;
    CHECK((interpolator.at(now).q - on_path(now).q).cwiseAbs().maxCoeff() < 1e-9);
  }
  CHECK(interpolator.starved() == 0);
}

TEST_CASE("a servo that is always a moment before the next reference keeps to the path") {
  for (const double late : {50e-6, 0.001, 0.003}) {
    CAPTURE(late);
    ReferenceInterpolator interpolator = standing_at_start();
    interpolator.push(on_path(stamp(1)));
    interpolator.at(stamp(1));
    // What constant acceleration misses of the path, j·late³/6, and what the way back may add to it
    // until it has taken up the path's jerk: as much again.
    const JointVector most = both(0.072, 1.2) * (2 * late * late * late / 6);
    for (int k = 1; k < 1000; ++k) {
      const double now = stamp(k) + late;
      const JointVector off = (interpolator.at(now).q - on_path(now).q).cwiseAbs();
      REQUIRE((off - most).maxCoeff() < 1e-14);
      interpolator.push(on_path(stamp(k + 1)));
    }
    CHECK(interpolator.starved() == 0);
  }
}

TEST_CASE("a machine found elsewhere is led back to the references slowly, whoever comes first") {
  for (const int known_before : {0, 1, 2}) {
    ReferenceInterpolator interpolator = standing_at_start();
    JointReference found = on_path(stamp(50));
    found.q += both(0.003, -0.003);
    interpolator.rejoin(found);
    for (int k = 1; k <= known_before; ++k)  // in time, or not yet
      interpolator.push(on_path(stamp(50 + k)));
    std::vector<JointReference> sent;
    for (int ms = 0; ms < 20000; ++ms) {
      if (ms % 10 == 9) interpolator.push(on_path(stamp(52 + ms / 10)));
      sent.push_back(interpolator.at(stamp(50) + 0.0003 + 0.001 * ms));
    }
    CAPTURE(known_before);
    CHECK((sent.front().q - found.q).cwiseAbs().maxCoeff() < 20e-6);
    const Worst worst = worst_of(sent, 1);
    CHECK(worst.position_jump[0] <= 2 * kMostAcceleration[0] * 0.001 * 0.001);
    // The path's speed, the difference in speed at the start, what taking back the difference in
    // acceleration adds to it, and the join's tenth.
    const double added = 0.036 * (0.036 / (0.5 * kMostJerk[0])) / 2;
    CHECK(worst.speed[0] <= 0.018 + 0.018 + added + 0.1 * kMostSpeed[0]);
    CHECK_FALSE(interpolator.joining());
    const double end = sent.back().time;
    CHECK((sent.back().q - on_path(end).q).cwiseAbs().maxCoeff() < 1e-8);
  }
}

TEST_CASE("a machine found off its references while moving is led back from where it is") {
  ReferenceInterpolator interpolator = standing_at_start();
  for (int k = 1; k <= 2; ++k) interpolator.push(on_path(stamp(k)));
  interpolator.at(stamp(1));
  interpolator.push(on_path(stamp(17)));  // what lies between was never made
  JointReference found = on_path(stamp(16) + 0.004);
  found.q += both(0.001, 0);
  found.qd += both(0.002, 0);
  interpolator.join_from(found);
  std::vector<JointReference> sent;
  for (int ms = 4; ms < 5000; ++ms) {
    if (ms % 10 == 4) interpolator.push(on_path(stamp(18 + ms / 10)));
    sent.push_back(interpolator.at(stamp(16) + 0.001 * ms));
  }
  CHECK((sent.front().q - found.q).cwiseAbs().maxCoeff() < 1e-9);
  CHECK((sent.front().qd - found.qd).cwiseAbs().maxCoeff() < 1e-9);
  const Worst worst = worst_of(sent, 0);
  CHECK(worst.position_jump[0] <= 2 * kMostAcceleration[0] * 0.001 * 0.001);
  CHECK(worst.speed[0] <= 0.018 + 0.002 + 0.1 * kMostSpeed[0]);
  const double end = sent.back().time;
  CHECK((sent.back().q - on_path(end).q).cwiseAbs().maxCoeff() < 1e-8);
}

TEST_CASE("interpolation, extrapolation and the way back take no memory") {
  ReferenceInterpolator interpolator = standing_at_start();
  const JointReference one = on_path(stamp(1));
  const JointReference two = on_path(stamp(2));
  const JointReference eight = on_path(stamp(8));
  const JointReference nine = on_path(stamp(9));
  test::NoAllocation guard;
  interpolator.reset({0, one.q, one.qd, one.qdd});
  interpolator.push(one);
  interpolator.push(two);
  double sum = interpolator.at(0.015).q.sum() + interpolator.at(0.065).q.sum();
  interpolator.push(eight);
  interpolator.push(nine);
  sum += interpolator.at(0.075).q.sum() + interpolator.at(0.085).q.sum();
  CHECK(guard.count() == 0);
  CHECK(interpolator.joining());
  CHECK(sum != 0);
}

}  // namespace rob::motion
