#include "motion/space/quintic.h"

namespace rob::motion {

// With s = (now − a.time)/h the curve is a's own parabola plus c3·s³ + c4·s⁴ + c5·s⁵. D, V and A
// are what that parabola lacks at b in position, velocity·h and acceleration·h².
JointReference quintic_between(const JointReference& a, const JointReference& b,
                               double now) noexcept {
  const double h = b.time - a.time;
  const double t = now - a.time;
  const double s = t / h;
  const JointVector D = b.q - (a.q + a.qd * h + a.qdd * (0.5 * h * h));
  const JointVector V = (b.qd - a.qd - a.qdd * h) * h;
  const JointVector A = (b.qdd - a.qdd) * (h * h);
  const JointVector c3 = 10 * D - 4 * V + 0.5 * A;
  const JointVector c4 = -15 * D + 7 * V - A;
  const JointVector c5 = 6 * D - 3 * V + 0.5 * A;

  JointReference at;
  at.time = now;
  at.q = a.q + a.qd * t + a.qdd * (0.5 * t * t) + (c3 + (c4 + c5 * s) * s) * (s * s * s);
  at.qd = a.qd + a.qdd * t + (3 * c3 + (4 * c4 + 5 * c5 * s) * s) * (s * s / h);
  at.qdd = a.qdd + (6 * c3 + (12 * c4 + 20 * c5 * s) * s) * (s / (h * h));
  return at;
}

}  // namespace rob::motion
