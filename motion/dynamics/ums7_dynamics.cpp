#include "motion/dynamics/ums7_dynamics.h"

#include <cmath>

namespace rob::motion {

namespace {

constexpr double kGravity = 9.80665;      // m/s², standard acceleration
constexpr double kTwiceTolerance = 1e-9;  // decimal numbers in a file

/// Sine and cosine of the angles that S2's formulas have; S = q2 + q3.
struct Trig {
  double s2, c2, s3, c3, s4, c4, s5, c5, s6, c6, sS, cS;
  explicit Trig(const JointVector& q) noexcept
      : s2(std::sin(q[1])),
        c2(std::cos(q[1])),
        s3(std::sin(q[2])),
        c3(std::cos(q[2])),
        s4(std::sin(q[3])),
        c4(std::cos(q[3])),
        s5(std::sin(q[4])),
        c5(std::cos(q[4])),
        s6(std::sin(q[5])),
        c6(std::cos(q[5])),
        sS(std::sin(q[1] + q[2])),
        cS(std::cos(q[1] + q[2])) {}
};

/// The moment of the load beside axis 6 along the flange's x and y at q6 = 0, and how far these
/// directions point up.
struct Sides {
  double along_x, along_y, up_x, up_y;
  Sides(const Trig& t, const Ums7Parameters& p) noexcept
      : along_x(p.side_x * t.c6 - p.side_y * t.s6),
        along_y(p.side_x * t.s6 + p.side_y * t.c6),
        up_x(-(t.sS * t.c4 * t.c5 + t.cS * t.s5)),
        up_y(t.sS * t.s4) {}
};

JointVector six(double a, double b, double c, double d, double e, double f) noexcept {
  JointVector v(Ums7Dynamics::kAxes);
  v[0] = a;
  v[1] = b;
  v[2] = c;
  v[3] = d;
  v[4] = e;
  v[5] = f;
  return v;
}

}  // namespace

const char* fault_of(const Ums7Parameters& p) {
  if (!(p.c0 > 0 && p.c7 > 0 && p.c8 > 0)) return "c0, c7 and c8 must be above 0";
  if (std::abs(p.c2 - 2 * p.c5) > kTwiceTolerance * std::abs(p.c2)) return "c2 must be 2*c5";
  if (!(p.c3 * (p.c4 - p.c3) > p.c5 * p.c5)) return "c3*(c4 - c3) must be more than c5^2";
  if (!(p.c1 * p.c3 >= p.c5 * p.c5)) return "c1*c3 must not be less than c5^2";
  return nullptr;
}

Ums7Parameters with_load(const Ums7Parameters& parameters, const ArmLoad& load,
                         const ArmLengths& lengths) noexcept {
  const auto [upper, fore, hand] = lengths;
  // From the wrist: Σ m·z and Σ m·z².
  const double first = load.moment.z() + load.mass * hand;
  const double second = load.along + 2 * hand * load.moment.z() + load.mass * hand * hand;
  Ums7Parameters p = parameters;
  p.c1 += load.mass * upper * upper;
  p.c2 += 2 * load.mass * upper * fore;
  p.c3 += load.mass * fore * fore;
  p.c4 += load.mass * (upper * upper + fore * fore);
  p.c5 += load.mass * upper * fore;
  p.c6 += kGravity * first;
  p.c7 += second + load.across / 2;
  p.c8 += load.across;
  p.upper_pull += load.mass * kGravity * upper;
  p.fore_pull += load.mass * kGravity * fore;
  p.side_x += kGravity * load.moment.x();
  p.side_y += kGravity * load.moment.y();
  return p;
}

Ums7Parameters with_payload(const Ums7Parameters& parameters, double mass, double upper_arm,
                            double forearm, double hand) noexcept {
  return with_load(parameters, ArmLoad::point(mass, Eigen::Vector3d::Zero()),
                   {upper_arm, forearm, hand});
}

Ums7Parameters scaled(const Ums7Parameters& parameters, double masses) {
  Ums7Parameters p = parameters;
  for (double* c : {&p.c0, &p.c1, &p.c2, &p.c3, &p.c4, &p.c5, &p.c6, &p.c7, &p.c8, &p.upper_pull,
                    &p.fore_pull, &p.side_x, &p.side_y}) {
    *c *= masses;
  }
  return p;
}

JointVector ArmInertia::diagonal() const noexcept { return six(h11, h22, h33, h44, h55, h66); }

void ArmInertia::add_diagonal(const JointVector& inertias) noexcept {
  h11 += inertias[0];
  h22 += inertias[1];
  h33 += inertias[2];
  h44 += inertias[3];
  h55 += inertias[4];
  h66 += inertias[5];
}

JointVector ArmInertia::times(const JointVector& x) const noexcept {
  return six(h11 * x[0], h22 * x[1] + h32 * x[2], h32 * x[1] + h33 * x[2], h44 * x[3], h55 * x[4],
             h66 * x[5]);
}

JointVector ArmInertia::solve(const JointVector& rhs) const noexcept {
  const double det = h22 * h33 - h32 * h32;
  return six(rhs[0] / h11, (h33 * rhs[1] - h32 * rhs[2]) / det, (h22 * rhs[2] - h32 * rhs[1]) / det,
             rhs[3] / h44, rhs[4] / h55, rhs[5] / h66);
}

ArmInertia Ums7Dynamics::inertia(const JointVector& q) const noexcept {
  const Trig t(q);
  ArmInertia h;
  h.h11 = p_.c0 + (p_.c1 * t.c2 + p_.c2 * t.sS) * t.c2 + p_.c3 * t.sS * t.sS;
  h.h22 = p_.c4 + p_.c2 * t.s3;
  h.h32 = p_.c3 + p_.c5 * t.s3;
  h.h33 = p_.c3;
  h.h44 = p_.c7 * t.s5 * t.s5 + p_.c8 * t.c5 * t.c5;
  h.h55 = p_.c7;
  h.h66 = p_.c8;
  return h;
}

// S2 prints sin² q4 in G4: a misprint, for then G4 and G5 would belong to no potential.
JointVector Ums7Dynamics::published_gravity(const JointVector& q) const noexcept {
  const Trig t(q);
  const double G4 = p_.c6 * t.s4 * t.s5 * t.sS;
  const double G5 = -p_.c6 * (t.c4 * t.c5 * t.sS + t.s5 * t.cS);
  return six(0, 0, 0, G4, G5, 0);
}

JointVector Ums7Dynamics::coriolis(const JointVector& q, const JointVector& qd) const noexcept {
  const Trig t(q);
  const double h11_3 = (p_.c2 * t.c2 + 2 * p_.c3 * t.sS) * t.cS;
  const double h11_2 = h11_3 - (2 * p_.c1 * t.c2 + p_.c2 * t.sS) * t.s2;
  const double h22_3 = p_.c2 * t.c3;
  const double h32_3 = p_.c5 * t.c3;
  const double h44_5 = 2 * (p_.c7 - p_.c8) * t.s5 * t.c5;
  const double v1 = qd[0];
  const double v2 = qd[1];
  const double v3 = qd[2];
  const double v4 = qd[3];
  const double v5 = qd[4];
  return six((h11_2 * v2 + h11_3 * v3) * v1,                          //
             (h22_3 * v2 + h32_3 * v3) * v3 - 0.5 * h11_2 * v1 * v1,  //
             -0.5 * (h11_3 * v1 * v1 + h22_3 * v2 * v2),              //
             h44_5 * v5 * v4, -0.5 * h44_5 * v4 * v4, 0);
}

double Ums7Dynamics::potential(const JointVector& q) const noexcept {
  const Trig t(q);
  const Sides sides(t, p_);
  return p_.c6 * (t.c5 * t.cS - t.c4 * t.s5 * t.sS) - p_.upper_pull * t.s2 + p_.fore_pull * t.cS +
         sides.up_x * sides.along_x + sides.up_y * sides.along_y;
}

JointVector Ums7Dynamics::gravity(const JointVector& q) const noexcept {
  const Trig t(q);
  JointVector g = published_gravity(q);
  g[2] = -p_.c6 * (t.c4 * t.s5 * t.cS + t.c5 * t.sS) - p_.fore_pull * t.sS;
  if (p_.side_x != 0 || p_.side_y != 0) {
    const Sides sides(t, p_);
    g[2] += (t.s5 * t.sS - t.c4 * t.c5 * t.cS) * sides.along_x + t.cS * t.s4 * sides.along_y;
    g[3] += t.sS * (t.s4 * t.c5 * sides.along_x + t.c4 * sides.along_y);
    g[4] += (t.sS * t.c4 * t.s5 - t.cS * t.c5) * sides.along_x;
    g[5] = sides.up_y * sides.along_x - sides.up_x * sides.along_y;
  }
  g[1] = g[2] - p_.upper_pull * t.c2;
  return g;
}

double Ums7Dynamics::kinetic_energy(const JointVector& q, const JointVector& qd) const noexcept {
  return 0.5 * qd.dot(inertia(q).times(qd));
}

}  // namespace rob::motion
