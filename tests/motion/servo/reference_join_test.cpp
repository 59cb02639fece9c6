#include "motion/servo/reference_join.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "tests/motion/servo/two_axes.h"
#include "tests/support/no_allocation.h"
#include "tests/support/relative.h"

namespace rob::motion {
namespace {

using test::both;

const JointVector kVMax = both(0.02, 0.35);
const JointVector kAMax = both(0.1, 1.75);
const JointVector kJMax = both(1, 17.5);

JointReference standing(double time) { return {time, both(0, 0), both(0, 0), both(0, 0)}; }

ReferenceJoin join_from(const JointReference& from, const JointVector& j_max = kJMax) {
  ReferenceJoin join(kVMax, kAMax, j_max);
  join.start(from, standing(from.time));
  return join;
}

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

// Until it has ended, and once more.
std::vector<JointReference> samples(ReferenceJoin join, double step) {
  std::vector<JointReference> all;
  for (int n = 0; join.active() && n < 100'000; ++n) {
    all.push_back(standing(n * step));
    join.apply(all.back());
  }
  return all;
}

// s for which the jerk takes an acceleration back, of the axis that takes longest: half of j_max.
double time_to_take_back(const JointVector& qdd, const JointVector& j_max) {
  return (qdd.cwiseAbs().array() / (j_max.array() / 2)).maxCoeff();
}

// Of the speed: the way back, and beyond Δq' what Δq'' adds to it or takes from it.
void check_speed(const JointReference& now, const JointReference& from, double tau) {
  for (int i = 0; i < 2; ++i) {
    const double towards_zero =
        std::clamp(now.qd[i], std::min(0.0, from.qd[i]), std::max(0.0, from.qd[i]));
    const double most = 0.1 * kVMax[i] + std::abs(from.qdd[i]) * tau / 2;
    REQUIRE(std::abs(now.qd[i] - towards_zero) <= most * (1 + 1e-9));
    REQUIRE(std::abs(now.qdd[i]) <= (0.5 * kAMax[i] + std::abs(from.qdd[i])) * (1 + 1e-9));
  }
}

}  // namespace

TEST_CASE("a join begins with the whole difference and ends with none") {
  std::mt19937 random(20);
  for (int n = 0; n < 50; ++n) {
    const JointReference from = seeded_difference(random);
    ReferenceJoin join = join_from(from);
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

TEST_CASE("a join keeps the speed, the acceleration and the jerk that it promises") {
  constexpr double kStep = 0.002;
  std::mt19937 random(21);
  JointVector hardest = both(0, 0);
  for (int n = 0; n < 200; ++n) {
    const JointReference from = seeded_difference(random);
    const std::vector<JointReference> sent = samples(join_from(from), kStep);
    const double tau = time_to_take_back(from.qdd, kJMax);
    for (const JointReference& now : sent) check_speed(now, from, tau);
    // The third difference of the position is a mean of the jerk over three steps.
    for (std::size_t k = 3; k < sent.size(); ++k) {
      const JointVector third = sent[k].q - sent[k - 3].q - 3 * (sent[k - 1].q - sent[k - 2].q);
      const JointVector share = (third / std::pow(kStep, 3)).cwiseQuotient(kJMax).cwiseAbs();
      REQUIRE(share.maxCoeff() <= 0.5 + 1e-5);
      hardest = hardest.cwiseMax(share);
    }
    REQUIRE(sent.back().q.isZero(0));
    REQUIRE(sent.back().qd.isZero(0));
  }
  CHECK(hardest.minCoeff() > 0.49);
}

TEST_CASE("position, speed and acceleration of a join belong together") {
  constexpr double kStep = 0.0005;
  std::mt19937 random(23);
  for (int n = 0; n < 50; ++n) {
    const std::vector<JointReference> sent = samples(join_from(seeded_difference(random)), kStep);
    for (std::size_t k = 1; k < sent.size(); ++k) {
      const JointReference& before = sent[k - 1];
      const JointReference& now = sent[k];
      for (int i = 0; i < 2; ++i) {
        // The trapezoids are off by h²/12 of the rate of the rate; no step is beyond half of j_max.
        const double q = before.q[i] + (before.qd[i] + now.qd[i]) * kStep / 2;
        REQUIRE(std::abs(now.q[i] - q) <=
                1.5 * kAMax[i] * std::pow(kStep, 3) / 12 + kJMax[i] * std::pow(kStep, 3) / 12);
        const double v = before.qd[i] + (before.qdd[i] + now.qdd[i]) * kStep / 2;
        REQUIRE(std::abs(now.qd[i] - v) <= kJMax[i] * kStep * kStep / 8);
        REQUIRE(std::abs(now.qdd[i] - before.qdd[i]) <= 0.5 * kJMax[i] * kStep * (1 + 1e-9));
      }
    }
  }
}

TEST_CASE("a difference in position alone is made up at a tenth of the greatest speed") {
  JointReference from = standing(0);
  from.q[0] = 0.001;
  ReferenceJoin join = join_from(from);
  // v = 2 mm/s, a = 100/2 mm/s², j = 1000/2 mm/s³: the ramps of √(v/j) = 0.0632 s never reach a.
  // T = d/v + 2·√(v/j)
  const double time = 0.5 + 2 * std::sqrt(0.002 / 0.5);
  CHECK(offset(join, time / 2).q[0] == test::relative(0.0005, 1e-12));
  CHECK(offset(join, time / 2).qd[0] == test::relative(-0.002, 1e-12));
  CHECK(offset(join, time - 1e-3).q[0] > 0);
  CHECK(offset(join, time + 1e-12).q[0] == 0);
}

TEST_CASE("a difference in acceleration alone is taken back with half of the jerk at first") {
  JointReference from = standing(0);
  from.qdd[1] = 1.75;
  const ReferenceJoin join = join_from(from);
  CHECK(offset(join, 0.02).qdd[1] == test::relative(1.75 - 0.5 * 17.5 * 0.02, 1e-12));
}

TEST_CASE("axes that are off in a fixed proportion join in that proportion") {
  const JointVector direction = both(1, -0.7);
  std::mt19937 random(24);
  std::uniform_real_distribution<double> size(-0.02, 0.02);
  for (int n = 0; n < 50; ++n) {
    const JointReference from{0, direction * size(random), direction * size(random),
                              direction * size(random)};
    for (const JointReference& now : samples(join_from(from), 0.05)) {
      CHECK(std::abs(now.q[1] + 0.7 * now.q[0]) < 1e-15);
      CHECK(std::abs(now.qd[1] + 0.7 * now.qd[0]) < 1e-15);
    }
  }
}

TEST_CASE("a join that is started again from what is left goes on as it was") {
  std::mt19937 random(26);
  const JointVector direction = both(1, -0.7);
  std::uniform_real_distribution<double> size(-0.02, 0.02);
  for (int n = 0; n < 100; ++n) {
    CAPTURE(n);
    JointReference from = seeded_difference(random);
    if (n % 2 == 0)
      from = {0, direction * size(random), direction * size(random), direction * size(random)};
    ReferenceJoin once = join_from(from);
    ReferenceJoin again = once;
    double time = 0;
    while (once.active()) {
      time += 0.01;
      const JointReference left = offset(again, time);
      // Along a line to the digit; else what could have been there sooner may be.
      if (n % 2 == 0) REQUIRE((left.q - offset(once, time).q).cwiseAbs().maxCoeff() < 1e-12);
      again.start(left, standing(time));
      JointReference at = standing(time);
      once.apply(at);
    }
    // Near its end it may lie along one direction, and be led in proportion from there.
    CHECK(offset(again, time + 0.01).q.isZero(0));
  }
}

TEST_CASE("a join that is disturbed in every period closes in its time") {
  // What the references' jerk, a quarter of j_max at random, makes in half of a period in which
  // they are late.
  constexpr double kPeriod = 0.01;
  constexpr double kLate = kPeriod / 2;
  const double left_by_one = std::pow(kLate, 3);  // times j_max
  std::mt19937 random(27);
  std::uniform_real_distribution<double> share(-0.25, 0.25);
  JointReference from = standing(0);
  from.q = both(0.001, -0.0175);
  ReferenceJoin join = join_from(from);
  const double undisturbed = 0.5 + 2 * std::sqrt(0.002 / 0.5);  // as above
  for (int k = 1; k <= 1000; ++k) {
    JointReference at = offset(join, k * kPeriod);
    const JointVector jerk = both(kJMax[0] * share(random), kJMax[1] * share(random));
    at.q += jerk * (kLate * kLate * kLate / 6);
    at.qd += jerk * (kLate * kLate / 2);
    at.qdd += jerk * kLate;
    join.start(at, standing(k * kPeriod));
    if (k * kPeriod > 1.2 * undisturbed)
      REQUIRE(at.q.cwiseQuotient(kJMax).cwiseAbs().maxCoeff() < 10 * left_by_one);
  }
  CHECK(offset(join, 11).q.isZero(0));
}

TEST_CASE("where the jerk is not limited, speed and acceleration are") {
  constexpr double kStep = 0.0005;
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  std::mt19937 random(25);
  for (const JointVector& j_max : {both(kInfinite, kInfinite), both(1, kInfinite)}) {
    for (int n = 0; n < 50; ++n) {
      const JointReference from = seeded_difference(random);
      const std::vector<JointReference> sent = samples(join_from(from, j_max), kStep);
      REQUIRE((sent.front().q - from.q).cwiseAbs().maxCoeff() < 1e-15);
      REQUIRE((sent.front().qd - from.qd).cwiseAbs().maxCoeff() < 1e-15);
      REQUIRE(sent.back().q.isZero(0));
      const double tau = time_to_take_back(from.qdd, j_max);
      for (std::size_t k = 0; k < sent.size(); ++k) {
        check_speed(sent[k], from, tau);
        if (k == 0) continue;
        const JointVector most = 0.5 * kAMax + from.qdd.cwiseAbs();
        const JointVector change = (sent[k].qd - sent[k - 1].qd).cwiseAbs() / kStep;
        REQUIRE((change - most).maxCoeff() <= 1e-9);
        const JointVector mean = 0.5 * (sent[k].qd + sent[k - 1].qd);
        const JointVector leap = (sent[k].q - sent[k - 1].q - mean * kStep).cwiseAbs();
        REQUIRE((leap - most * (kStep * kStep / 4)).maxCoeff() <= 1e-15);
      }
    }
  }
}

TEST_CASE("where there is no difference there is no join") {
  ReferenceJoin join(kVMax, kAMax, kJMax);
  join.start(standing(3), standing(3));
  CHECK_FALSE(join.active());
}

TEST_CASE("a join takes no memory") {
  ReferenceJoin join(kVMax, kAMax, kJMax);
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
