#include "motion/space/quintic.h"

#include <doctest/doctest.h>

namespace rob::motion {
namespace {

// 1 + 2t − 3t² + 0.5t³ + 4t⁴ − 2t⁵ on the first axis, its negative half on the second.
JointReference on_polynomial(double t) {
  JointReference r;
  r.time = t;
  r.q.resize(2);
  r.qd.resize(2);
  r.qdd.resize(2);
  r.q[0] = 1 + t * (2 + t * (-3 + t * (0.5 + t * (4 - 2 * t))));
  r.qd[0] = 2 + t * (-6 + t * (1.5 + t * (16 - 10 * t)));
  r.qdd[0] = -6 + t * (3 + t * (48 - 40 * t));
  r.q[1] = -0.5 * r.q[0];
  r.qd[1] = -0.5 * r.qd[0];
  r.qdd[1] = -0.5 * r.qdd[0];
  return r;
}

}  // namespace

TEST_CASE("a curve of the fifth degree is found again from two of its points") {
  const JointReference a = on_polynomial(0.3);
  const JointReference b = on_polynomial(0.8);
  for (int i = 0; i <= 50; ++i) {
    const double t = 0.3 + 0.01 * i;
    const JointReference expected = on_polynomial(t);
    const JointReference found = quintic_between(a, b, t);
    CHECK(found.time == t);
    CHECK((found.q - expected.q).cwiseAbs().maxCoeff() < 1e-13);
    CHECK((found.qd - expected.qd).cwiseAbs().maxCoeff() < 1e-12);
    CHECK((found.qdd - expected.qdd).cwiseAbs().maxCoeff() < 1e-11);
  }
}

}  // namespace rob::motion
