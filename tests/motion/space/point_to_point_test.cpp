#include "motion/space/point_to_point.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/support/no_allocation.h"
#include "tests/support/relative.h"

namespace rob::motion {
namespace {

JointVector three(double x, double y, double z) {
  JointVector v(3);
  v << x, y, z;
  return v;
}

const JointVector kMostRate = three(1, 0.5, 2);
const JointVector kMostRateChange = three(2, 3, 4);
const JointVector kMostBend = three(20, 15, 60);
const JointVector kNone = three(0, 0, 0);

JointVector random_vector(std::mt19937& random, double size) {
  std::uniform_real_distribution<double> share(-size, size);
  return three(share(random), share(random), share(random));
}

double time_alone(int axis, double way) {
  return AxisMotion({0, 0, 0}, way, {kMostRate[axis], kMostRateChange[axis], kMostBend[axis]})
      .duration();
}

}  // namespace

TEST_CASE("axes arrive together, when the slowest can") {
  PointToPoint motion(kMostRate, kMostRateChange, kMostBend);
  const JointVector target = three(0.5, -0.1, 1);
  motion.aim({3, kNone, kNone, kNone}, target);
  double slowest = 0;
  for (int i = 0; i < 3; ++i) slowest = std::max(slowest, time_alone(i, target[i]));
  CHECK(motion.arrival() == test::relative(3 + slowest, 1e-15));

  const JointReference before = motion.at(motion.arrival() - 1e-3);
  for (int i = 0; i < 3; ++i) {
    CAPTURE(i);
    CHECK(before.qd[i] * target[i] > 0);
    CHECK(std::abs(before.q[i] - target[i]) < 1e-6);
  }
  const JointReference end = motion.at(motion.arrival());
  CHECK(end.q == target);
  CHECK(end.qd.isZero(0));
  CHECK(end.qdd.isZero(0));
}

TEST_CASE("from rest, axes of like limits keep to a straight line") {
  const JointVector v = three(1, 1, 1);
  PointToPoint motion(v, v * 2, v * 20);
  motion.aim({0, kNone, kNone, kNone}, three(0.8, -0.4, 0.1));
  for (double t = 0; t < motion.arrival(); t += 0.01) {
    const JointVector q = motion.at(t).q;
    CHECK(std::abs(q[0] + 2 * q[1]) < 1e-14);
    CHECK(std::abs(q[0] - 8 * q[2]) < 1e-14);
  }
}

TEST_CASE("a target changed at any instant: nothing leaps, and limits hold") {
  constexpr double kStep = 0.002;
  std::mt19937 random(8);
  PointToPoint motion(kMostRate, kMostRateChange, kMostBend);
  motion.aim({0, kNone, kNone, kNone}, random_vector(random, 1));
  JointReference before = motion.at(0);
  std::uniform_real_distribution<double> chance(0, 1);
  int aims = 0;
  for (int i = 1; i < 50'000; ++i) {
    if (chance(random) < 0.01 || before.time >= motion.arrival()) {
      motion.aim(before, random_vector(random, chance(random)));
      ++aims;
    }
    const JointReference now = motion.at(i * kStep);
    for (int k = 0; k < 3; ++k) {
      REQUIRE(std::abs(now.qd[k]) <= kMostRate[k] * (1 + 1e-9));
      REQUIRE(std::abs(now.qdd[k]) <= kMostRateChange[k] * (1 + 1e-9));
      REQUIRE(std::abs(now.qdd[k] - before.qdd[k]) <= kMostBend[k] * kStep * (1 + 1e-7));
      const double v = before.qd[k] + (before.qdd[k] + now.qdd[k]) * kStep / 2;
      REQUIRE(std::abs(now.qd[k] - v) <= kMostBend[k] * kStep * kStep / 4 * (1 + 1e-7));
      const double q = before.q[k] + (before.qd[k] + now.qd[k]) * kStep / 2;
      REQUIRE(std::abs(now.q[k] - q) <= kMostRateChange[k] * kStep * kStep / 8);
    }
    before = now;
  }
  CHECK(aims > 500);
}

TEST_CASE("aimed at the same target again and again it arrives as without") {
  PointToPoint motion(kMostRate, kMostRateChange, kMostBend);
  const JointVector target = three(0.5, -0.1, 1);
  motion.aim({0, kNone, three(0.5, 0.2, -1), three(1, -2, 0)}, target);
  const double arrival = motion.arrival();
  for (double t = 0.01; t < arrival - 0.02; t += 0.01) motion.aim(motion.at(t), target);
  CHECK(std::abs(motion.arrival() - arrival) < 1e-3);
  CHECK(motion.at(arrival + 1e-3).q == target);
}

TEST_CASE("a motion from point to point takes no memory") {
  PointToPoint motion(kMostRate, kMostRateChange, kMostBend);
  const JointReference from{1, kNone, three(0.5, 0.2, -1), three(1, -2, 0)};
  const JointVector target = three(0.5, -0.1, 1);
  test::NoAllocation guard;
  motion.aim(from, target);
  const JointReference now = motion.at(1.1);
  CHECK(guard.count() == 0);
  CHECK(now.q[0] > 0);
}

}  // namespace rob::motion
