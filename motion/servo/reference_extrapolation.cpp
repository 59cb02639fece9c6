#include "motion/servo/reference_extrapolation.h"

#include <algorithm>
#include <cmath>

namespace rob::motion {
namespace {

// When constant acceleration brings the speed to v_max, if it grows at all.
double time_to_limit(double v, double a, double v_max) noexcept {
  const double towards = std::copysign(1.0, a);
  return std::max(0.0, (v_max - v * towards) / std::abs(a));
}

}  // namespace

ReferenceExtrapolation::ReferenceExtrapolation(double period, const JointVector& v_max,
                                               const JointVector& a_max)
    : coast_time_(kPeriods * period), v_max_(v_max), a_max_(a_max) {}

void ReferenceExtrapolation::start(const JointReference& last) noexcept {
  base_ = last;
  at_rest_ = last.qd.isZero(0) && last.qdd.isZero(0);
  ramp_ = coast(last.time + coast_time_);
  ramp_time_ = (ramp_.qd.cwiseAbs().array() / a_max_.array()).maxCoeff();
}

JointReference ReferenceExtrapolation::at(double now) const noexcept {
  if (at_rest_ || now <= ramp_.time) return coast(now);
  JointReference at = ramp_;
  at.time = now;
  at.qdd.setZero();
  if (ramp_time_ == 0) return at;
  const double t = std::min(now - ramp_.time, ramp_time_);
  at.q += ramp_.qd * (t * (1 - 0.5 * t / ramp_time_));
  at.qd *= 1 - t / ramp_time_;
  if (t < ramp_time_) at.qdd = ramp_.qd * (-1 / ramp_time_);
  return at;
}

JointReference ReferenceExtrapolation::coast(double now) const noexcept {
  JointReference at = base_;
  at.time = now;
  const double t = now - base_.time;
  for (Eigen::Index i = 0; i < at.q.size(); ++i) {
    const double v = base_.qd[i];
    const double a = base_.qdd[i];
    const double faster = a == 0 ? t : std::min(t, time_to_limit(v, a, v_max_[i]));
    at.qd[i] = v + a * faster;
    at.q[i] += (v + 0.5 * a * faster) * faster + at.qd[i] * (t - faster);
    if (faster < t) at.qdd[i] = 0;
  }
  return at;
}

}  // namespace rob::motion
