#include "motion/servo/reference_extrapolation.h"

#include <doctest/doctest.h>

#include "tests/motion/servo/two_axes.h"
#include "tests/support/no_allocation.h"
#include "tests/support/relative.h"

namespace rob::motion {
namespace {

using test::both;

// mm instead of m, so that the numbers can be checked by eye; nothing here knows the unit.
const JointVector kSpeeds = both(20, 20);
const JointVector kAccelerations = both(100, 100);
constexpr double kPeriod = 0.01;

ReferenceExtrapolation from(const JointVector& qd, const JointVector& qdd) {
  ReferenceExtrapolation extrapolation(kPeriod, kSpeeds, kAccelerations);
  extrapolation.start({1.0, both(40, 50), qd, qdd});
  return extrapolation;
}

}  // namespace

TEST_CASE("without a reference the axes go on at constant acceleration for three periods") {
  const auto extrapolation = from(both(10, 0), both(50, -25));
  const JointReference at = extrapolation.at(1.02);
  CHECK(at.q[0] == test::relative(40 + 0.2 + 0.01, 1e-14));
  CHECK(at.qd[0] == test::relative(11, 1e-14));
  CHECK(at.qdd[0] == 50);
  CHECK(at.q[1] == test::relative(50 - 0.005, 1e-14));
  CHECK(at.qd[1] == test::relative(-0.5, 1e-14));
}

TEST_CASE("extrapolation does not accelerate beyond the greatest speed") {
  // 19 mm/s + 100 mm/s² is 20 mm/s after 10 ms, on a way of 0.195 mm.
  const auto extrapolation = from(both(19, -19), both(100, -100));
  const JointReference at = extrapolation.at(1.03);
  CHECK(at.qd[0] == test::relative(20, 1e-14));
  CHECK(at.qd[1] == test::relative(-20, 1e-14));
  CHECK(at.q[0] == test::relative(40 + 0.195 + 0.4, 1e-14));
  CHECK(at.q[1] == test::relative(50 - 0.195 - 0.4, 1e-14));
  CHECK(at.qdd[0] == 0);
}

TEST_CASE("after three periods the axes come to rest together, the faster one at its limit") {
  const auto extrapolation = from(both(10, -4), both(0, 0));
  const JointReference ramp = extrapolation.at(1.05);  // 20 ms into a ramp of 100 ms
  CHECK(ramp.qd[0] == test::relative(8, 1e-13));
  CHECK(ramp.qd[1] == test::relative(-3.2, 1e-13));
  CHECK(ramp.qdd[0] == test::relative(-100, 1e-13));
  CHECK(ramp.qdd[1] == test::relative(40, 1e-13));
  for (const double later : {1.13 + 1e-9, 2.0, 100.0}) {
    const JointReference rest = extrapolation.at(later);
    CHECK(rest.q[0] == test::relative(40 + 0.3 + 0.5, 1e-13));
    CHECK(rest.q[1] == test::relative(50 - 0.12 - 0.2, 1e-13));
    CHECK(rest.qd.cwiseAbs().maxCoeff() < 1e-12);
    CHECK(rest.qdd.isZero(0));
  }
}

TEST_CASE("what stands is held where it stands") {
  const auto extrapolation = from(both(0, 0), both(0, 0));
  CHECK(extrapolation.at_rest());
  CHECK(extrapolation.at(1000.0).q == both(40, 50));
  CHECK_FALSE(from(both(0, 0), both(0, 1)).at_rest());
}

TEST_CASE("extrapolation takes no memory") {
  ReferenceExtrapolation extrapolation(kPeriod, kSpeeds, kAccelerations);
  const JointReference last{1.0, both(40, 50), both(10, -4), both(50, 0)};
  test::NoAllocation guard;
  extrapolation.start(last);
  const double sum = extrapolation.at(1.02).q.sum() + extrapolation.at(1.05).q.sum();
  CHECK(guard.count() == 0);
  CHECK(sum > 0);
}

}  // namespace rob::motion
