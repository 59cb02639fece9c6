#include "motion/generate/axis_brake.h"

#include <doctest/doctest.h>

using rob::motion::AxisBrake;
using rob::motion::JointReference;
using rob::motion::JointVector;

namespace {

JointVector vector(double a, double b) {
  JointVector v(2);
  v << a, b;
  return v;
}

}  // namespace

// 0.3 m/s at 2 m/s² takes 0.15 s and 0.0225 m; 0.1 m/s at 1 m/s² would take 0.1 s, so it waits for
// the first and goes 0.1·0.15/2 m.
TEST_CASE("all axes come to rest together, one of them with all that it has") {
  AxisBrake brake(vector(2, 1));
  CHECK_FALSE(brake.active());
  const JointReference from{5, vector(1, 1), vector(0.3, -0.1), vector(7, 7)};
  brake.start(from);
  CHECK(brake.active());
  CHECK(brake.rest() == doctest::Approx(5.15));
  const JointReference rest = brake.at(6);
  CHECK(rest.q[0] == doctest::Approx(1.0225));
  CHECK(rest.q[1] == doctest::Approx(0.9925));
  CHECK(rest.qd.isZero(1e-15));
  CHECK(rest.qdd.isZero());
  CHECK(rest.time == 6);
}

TEST_CASE("on the way the references are those of a constant deceleration") {
  AxisBrake brake(vector(2, 1));
  brake.start({0, vector(0, 0), vector(0.3, -0.1), vector(0, 0)});
  constexpr double kStep = 1e-4;
  for (double t = kStep; t + kStep < brake.rest(); t += 0.01) {
    const JointReference at = brake.at(t);
    const JointVector before = brake.at(t - kStep).q;
    const JointVector after = brake.at(t + kStep).q;
    CHECK(((after - before) / (2 * kStep) - at.qd).norm() < 1e-9);
    CHECK(((after - 2 * at.q + before) / (kStep * kStep) - at.qdd).norm() < 1e-6);
    CHECK(at.qdd[0] == doctest::Approx(-2));
  }
}

TEST_CASE("the rest is told once, and at once to axes that stand") {
  AxisBrake brake(vector(2, 1));
  brake.start({5, vector(0, 0), vector(0.3, 0), vector(0, 0)});
  CHECK_FALSE(brake.take_rest(5.1));
  CHECK(brake.take_rest(5.2));
  CHECK_FALSE(brake.take_rest(5.3));
  brake.start({6, vector(1, 2), vector(0, 0), vector(0, 0)});
  CHECK(brake.rest() == 6);
  CHECK(brake.at(7).q == vector(1, 2));
  CHECK(brake.take_rest(6));
}
