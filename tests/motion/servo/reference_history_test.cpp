#include "motion/servo/reference_history.h"

#include <doctest/doctest.h>

#include "tests/support/no_allocation.h"
#include "tests/support/relative.h"

namespace rob::motion {
namespace {

/// At 3 mm/s from 1 mm on.
JointReference moving(double time) {
  return {time, JointVector::Constant(1, 1e-3 + 3e-3 * time), JointVector::Constant(1, 3e-3),
          JointVector::Constant(1, 0)};
}

ReferenceHistory of_a_second(double period) {
  ReferenceHistory history;
  history.reset(moving(0));
  for (int k = 1; k * period <= 1; ++k) history.push(moving(k * period));
  return history;
}

}  // namespace

TEST_CASE("what was told before is found again, between two cycles as well") {
  const ReferenceHistory history = of_a_second(0.02);
  for (const double time : {0.0, 0.013, 0.5, 0.987})
    CHECK(history.at(time).q[0] == test::relative(moving(time).q[0]));
}

TEST_CASE("from the newest on it is the newest, bit for bit") {
  const ReferenceHistory history = of_a_second(0.02);
  CHECK(history.at(1.0).q[0] == moving(50 * 0.02).q[0]);
  CHECK(history.at(7).q[0] == moving(50 * 0.02).q[0]);
}

TEST_CASE("before the oldest that is kept it is the oldest") {
  const ReferenceHistory history = of_a_second(0.005);  // 201 of which 64 are kept
  CHECK(history.at(0).q[0] == test::relative(moving((200 - 63) * 0.005).q[0]));
}

TEST_CASE("what was before reset() is forgotten, and no memory is taken") {
  ReferenceHistory history = of_a_second(0.02);
  test::NoAllocation guard;
  history.reset(moving(2));
  CHECK(history.at(0.5).q[0] == moving(2).q[0]);
  CHECK(guard.count() == 0);
}

}  // namespace rob::motion
