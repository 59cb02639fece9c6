#include "motion/servo/reference_join.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/support/no_allocation.h"
#include "tests/support/relative.h"

namespace rob::motion {
namespace {

constexpr double kPeriod = 0.01;

JointVector both(double x, double y) {
  JointVector v(2);
  v << x, y;
  return v;
}

const JointVector kVMax = both(0.02, 0.35);
const JointVector kAMax = both(0.1, 1.75);

JointReference standing(double time) { return {time, both(0, 0), both(0, 0), both(0, 0)}; }

// What the join adds, seen over references that stand at 0.
JointReference offset(ReferenceJoin join, double time) {
  JointReference reference = standing(time);
  join.apply(reference);
  return reference;
}

JointReference seeded_difference(std::mt19937& random) {
  std::uniform_real_distribution<double> share(-1, 1);
  JointReference from = standing(0);
  for (int i = 0; i < 2; ++i) {
    from.q[i] = 0.1 * kVMax[i] * share(random);
    from.qd[i] = kVMax[i] * share(random);
    from.qdd[i] = kAMax[i] * share(random);
  }
  return from;
}

}  // namespace

TEST_CASE("a join begins with the whole difference and ends with none") {
  std::mt19937 random(20);
  for (int n = 0; n < 50; ++n) {
    const JointReference from = seeded_difference(random);
    ReferenceJoin join(kPeriod, kVMax, kAMax);
    join.start(from, standing(0));
    const JointReference first = offset(join, 0);
    CHECK((first.q - from.q).cwiseAbs().maxCoeff() < 1e-15);
    CHECK((first.qd - from.qd).cwiseAbs().maxCoeff() < 1e-15);
    CHECK((first.qdd - from.qdd).cwiseAbs().maxCoeff() < 1e-14);

    JointReference last = standing(60);
    join.apply(last);
    CHECK_FALSE(join.active());
    CHECK(last.q.isZero(0));
    CHECK(last.qd.isZero(0));
    CHECK(last.qdd.isZero(0));
  }
}

TEST_CASE("a join keeps the speed and the acceleration that it promises, and never jumps") {
  constexpr double kStep = 0.0005;
  std::mt19937 random(21);
  for (int n = 0; n < 50; ++n) {
    const JointReference from = seeded_difference(random);
    ReferenceJoin join(kPeriod, kVMax, kAMax);
    join.start(from, standing(0));
    JointReference before = offset(join, 0);
    for (double t = kStep; t < 60 && join.active(); t += kStep) {
      JointReference now = standing(t);
      join.apply(now);
      for (int i = 0; i < 2; ++i) {
        const double towards_zero =
            std::clamp(now.qd[i], std::min(0.0, from.qd[i]), std::max(0.0, from.qd[i]));
        REQUIRE(std::abs(now.qd[i] - towards_zero) <= 0.15 * kVMax[i] * (1 + 1e-9));
        REQUIRE(std::abs(now.qdd[i]) <= 0.5 * kAMax[i] + std::abs(from.qdd[i]) + 1e-12);
        // The mean of both ends is the mean velocity but for h²/12 of the third derivative.
        const double mean = 0.5 * (before.qd[i] + now.qd[i]);
        REQUIRE(std::abs((now.q[i] - before.q[i]) / kStep - mean) < 1e-5 * kVMax[i]);
        // A jump of acceleration would be felt as half of itself, whatever the step.
        const double mean2 = 0.5 * (before.qdd[i] + now.qdd[i]);
        REQUIRE(std::abs((now.qd[i] - before.qd[i]) / kStep - mean2) < 0.01 * kAMax[i]);
      }
      before = now;
    }
    REQUIRE_FALSE(join.active());
  }
}

TEST_CASE("a difference in position alone is made up at a tenth of the greatest speed") {
  JointReference from = standing(0);
  from.q[0] = 0.001;  // 1.875·1 mm/T = 2 mm/s: T = 0.9375 s
  ReferenceJoin join(kPeriod, kVMax, kAMax);
  join.start(from, standing(0));
  CHECK(offset(join, 0.9375 / 2).q[0] == test::relative(0.0005, 1e-12));
  CHECK(offset(join, 0.9375 / 2).qd[0] == test::relative(-0.002, 1e-12));
  CHECK(offset(join, 0.93749).q[0] > 0);
  CHECK(offset(join, 0.93751).q[0] == 0);
}

TEST_CASE("a difference in acceleration, however great, is given a whole period") {
  JointReference from = standing(0);
  from.qdd[0] = 2;  // after h = 1/2 of it (1 − h)(1 − 3h) = −1/4 is left
  ReferenceJoin join(kPeriod, kVMax, kAMax);
  join.start(from, standing(0));
  CHECK(offset(join, 0.5 * kPeriod).qdd[0] == test::relative(-0.5, 0.05));
}

TEST_CASE("axes that are off in a fixed proportion join in that proportion") {
  JointReference from = standing(0);
  from.q = both(0.001, 0.0005);
  from.qd = both(-0.01, -0.005);
  ReferenceJoin join(kPeriod, kVMax, kAMax);
  join.start(from, standing(0));
  for (double t = 0; t < 2; t += 0.05) {
    const JointReference now = offset(join, t);
    CHECK(now.q[1] == test::relative(0.5 * now.q[0], 1e-12));
  }
}

TEST_CASE("where there is no difference there is no join") {
  ReferenceJoin join(kPeriod, kVMax, kAMax);
  join.start(standing(3), standing(3));
  CHECK_FALSE(join.active());
}

TEST_CASE("a join takes no memory") {
  ReferenceJoin join(kPeriod, kVMax, kAMax);
  std::mt19937 random(22);
  const JointReference from = seeded_difference(random);
  JointReference reference = standing(0.02);
  const JointReference to = standing(0);
  test::NoAllocation guard;
  join.start(from, to);
  join.apply(reference);
  CHECK(guard.count() == 0);
  CHECK(reference.q[0] != 0);
}

}  // namespace rob::motion
