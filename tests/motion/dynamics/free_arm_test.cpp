#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "motion/dynamics/ums7_dynamics.h"
#include "tests/motion/dynamics/random_arm.h"

// The complete mechanics, left to themselves or driven: energy is neither made nor lost.

using namespace rob::motion;

namespace {

struct State {
  JointVector q, v;
};

using Torque = JointVector (*)(double t);

JointVector none(double) { return JointVector::Zero(6); }

JointVector wave(double t) {
  JointVector u(6);
  for (int i = 0; i < 6; ++i) u[i] = (i < 3 ? 3 : 0.03) * std::sin(2 * t + i);
  return u;
}

State rate(const Ums7Dynamics& arm, const State& x, const JointVector& u) {
  return {x.v, arm.inertia(x.q).solve(u - arm.coriolis(x.q, x.v) - arm.gravity(x.q))};
}

State moved(const State& x, const State& d, double h) { return {x.q + h * d.q, x.v + h * d.v}; }

/// Runge and Kutta's fourth-order step.
State step(const Ums7Dynamics& arm, const State& x, double t, double h, Torque u) {
  const State a = rate(arm, x, u(t));
  const State b = rate(arm, moved(x, a, h / 2), u(t + h / 2));
  const State c = rate(arm, moved(x, b, h / 2), u(t + h / 2));
  const State d = rate(arm, moved(x, c, h), u(t + h));
  return {x.q + h / 6 * (a.q + 2 * b.q + 2 * c.q + d.q),
          x.v + h / 6 * (a.v + 2 * b.v + 2 * c.v + d.v)};
}

double energy(const Ums7Dynamics& arm, const State& x) {
  return arm.kinetic_energy(x.q, x.v) + arm.potential(x.q);
}

State start() {
  State x{JointVector::Zero(6), JointVector::Zero(6)};
  x.q << 0, -0.8, 2.3, 0.3, 1.0, 0;
  x.v << 0.5, 0.3, -0.4, 0.6, -0.5, 0.2;
  return x;
}

/// The greatest change of energy, less the work of u, in 2 s.
double drift(double h, Torque u) {
  const Ums7Dynamics arm(rob::test::plain_arm());
  State x = start();
  const double begin = energy(arm, x);
  double work = 0;
  double worst = 0;
  const int steps = static_cast<int>(std::lround(2 / h));
  for (int k = 0; k < steps; ++k) {
    // Simpson's rule over two half steps: of the same order as the step.
    const double t = k * h;
    const State half = step(arm, x, t, h / 2, u);
    const State next = step(arm, half, t + h / 2, h / 2, u);
    work += h / 6 * (u(t).dot(x.v) + 4 * u(t + h / 2).dot(half.v) + u(t + h).dot(next.v));
    x = next;
    worst = std::max(worst, std::abs(energy(arm, x) - begin - work));
  }
  return worst;
}

}  // namespace

TEST_CASE("a free arm keeps its energy, but for the error of the steps") {
  const double coarse = drift(4e-3, none);
  const double fine = drift(2e-3, none);
  CHECK(fine < 1e-6);         // of 50 J
  CHECK(coarse > 12 * fine);  // fourth order: a step of twice the length errs 16 times as much
  CHECK(drift(5e-4, none) < 1e-8);
}

TEST_CASE("what the torques work is what the arm's energy grows by") {
  CHECK(drift(2e-3, wave) < 1e-6);
  CHECK(drift(5e-4, wave) < 1e-8);
}
