#include "motion/path/paul_transition.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>

#include "tests/support/no_allocation.h"

using namespace rob::motion;

namespace {

/// One axis of S1's transition, multiplied out: with u = ΔC·t_acc/T1 + ΔB the published
/// [u·(2 − h)·h² − 2ΔB]·h + B + ΔB is A − 2ΔB·h + 2u·h³ − u·h⁴.
struct Quartic {
  double a, b, c, t1, t_acc;

  double position(double t) const {
    if (t > t_acc) return b + (c - b) / t1 * t;
    const double h = (t + t_acc) / (2 * t_acc);
    const double u = (c - b) * t_acc / t1 + (a - b);
    return a - 2 * (a - b) * h + 2 * u * h * h * h - u * h * h * h * h;
  }
};

struct Drawn {
  JointVector a{2}, b{2}, c{2};
  double t1 = 0;
  double t_acc = 0;
};

Drawn draw(std::mt19937& random) {
  std::uniform_real_distribution<> place(-0.2, 0.2);
  std::uniform_real_distribution<> time(0.2, 2);
  Drawn drawn;
  for (int i = 0; i < 2; ++i) {
    drawn.a[i] = place(random);
    drawn.b[i] = place(random);
    drawn.c[i] = place(random);
  }
  drawn.t_acc = time(random);
  drawn.t1 = 2 * drawn.t_acc + time(random);
  return drawn;
}

}  // namespace

TEST_CASE("position, speed and acceleration are S1's polynomial and its derivatives") {
  std::mt19937 random(1);
  for (int n = 0; n < 200; ++n) {
    const auto [a, b, c, t1, t_acc] = draw(random);
    const PaulTransition segment(a, b, c, t1, t_acc);
    const double d = 1e-4;  // central differences: errors of d²/6 and d²/12 of higher derivatives
    for (double t = -t_acc + d; t < t1; t += 0.0371) {
      if (std::abs(t - t_acc) < d) continue;  // the third derivative steps there
      for (int i = 0; i < 2; ++i) {
        const Quartic law{a[i], b[i], c[i], t1, t_acc};
        const double before = law.position(t - d);
        const double at = law.position(t);
        const double after = law.position(t + d);
        const PathPoint point = segment.sample(t);
        CHECK(point.q[i] == doctest::Approx(at).epsilon(1e-12));
        CHECK(std::abs(point.qd[i] - (after - before) / (2 * d)) < 1e-6);
        CHECK(std::abs(point.qdd[i] - (after - 2 * at + before) / (d * d)) < 1e-5);
      }
    }
  }
}

TEST_CASE(
    "a transition begins at A with the incoming speed and ends on the line with the outgoing") {
  std::mt19937 random(2);
  for (int n = 0; n < 200; ++n) {
    const auto [a, b, c, t1, t_acc] = draw(random);
    const PaulTransition segment(a, b, c, t1, t_acc);
    const PathPoint first = segment.sample(-t_acc);
    CHECK(first.q.isApprox(a, 1e-12));
    CHECK(first.qd.isApprox((b - a) / t_acc, 1e-12));
    CHECK(first.qdd.isZero(0));
    const PathPoint before = segment.sample(t_acc * (1 - 1e-13));
    const PathPoint after = segment.sample(t_acc);
    CHECK(before.q.isApprox(after.q, 1e-11));
    CHECK(before.qd.isApprox(after.qd, 1e-11));
    CHECK((before.qdd - after.qdd).cwiseAbs().maxCoeff() < 1e-11);
    CHECK(segment.sample(t1).q.isApprox(c, 1e-12));
  }
}

TEST_CASE("the acceleration peaks in the middle of the corner, at 0.75 Δv/t_acc") {
  JointVector a(1), b(1), c(1);
  // In at +0.02 m/s, out at −0.02 m/s, t_acc 0.5 s: 0.75·0.04/0.5 = 0.06 m/s².
  a << -0.01;
  b << 0;
  c << -0.04;
  const PaulTransition corner(a, b, c, 2, 0.5);
  CHECK(corner.sample(0).qdd[0] == doctest::Approx(-0.06));
  for (double t = -0.5; t < 0.5; t += 0.01) CHECK(corner.sample(t).qdd[0] >= -0.06 - 1e-15);
}

TEST_CASE("a corner stays within the triangle of A, B and the line's beginning") {
  std::mt19937 random(3);
  for (int n = 0; n < 100; ++n) {
    const auto [a, b, c, t1, t_acc] = draw(random);
    const PaulTransition segment(a, b, c, t1, t_acc);
    const JointVector exit = segment.sample(t_acc).q;
    for (double t = -t_acc; t < t_acc; t += 0.01) {
      const JointVector q = segment.sample(t).q;
      for (int i = 0; i < 2; ++i) {
        CHECK(q[i] >= std::min({a[i], b[i], exit[i]}) - 1e-15);
        CHECK(q[i] <= std::max({a[i], b[i], exit[i]}) + 1e-15);
      }
    }
  }
}

TEST_CASE("a segment of no length ends on its target to the last bit") {
  JointVector a(1), b(1);
  a << 0.1234567;
  b << 0.3;
  const PaulTransition stop(a, b, b, 2.75, 1.375);
  CHECK(stop.sample(1.375).q[0] == 0.3);
  CHECK(stop.sample(1.375).qd[0] == 0);
  CHECK(stop.sample(1.375).qdd[0] == 0);
}

TEST_CASE("a transition takes no memory") {
  const JointVector a = JointVector::Constant(8, 0.1);
  const JointVector b = JointVector::Constant(8, 0.2);
  const JointVector c = JointVector::Constant(8, 0.7);
  rob::test::NoAllocation guard;
  const PaulTransition segment(a, b, c, 3, 1);
  const PathPoint corner = segment.sample(0.3);
  const PathPoint line = segment.sample(1.5);
  CHECK(guard.count() == 0);
  CHECK(line.q[0] > corner.q[0]);
}
