#include "motion/servo/reference_join.h"

#include <algorithm>
#include <cmath>

namespace rob::motion {
namespace {

// The greatest slopes of the curves in the header, for a way or a velocity of 1 in a time of 1.
constexpr double kBumpPeak = 4.0 / 27;        // h − 2h² + h³ at h = 1/3
constexpr double kVelocityPeak = 1.5;         // |1 − 3r² + 2r³|' at r = 1/2
constexpr double kWayPeak = 1.875;            // |1 − 10s³ + 15s⁴ − 6s⁵|' at s = 1/2
constexpr double kWayPeak2 = 5.773502691897;  // its second derivative: 10/√3

// Shares of v_max and a_max.
constexpr double kSpeedOfWay = 1.0 / 10;
constexpr double kSpeedOfBump = 1.0 / 20;
constexpr double kAccelerationOfVelocity = 3.0 / 8;
constexpr double kAccelerationOfWay = 1.0 / 8;

}  // namespace

ReferenceJoin::ReferenceJoin(double period, const JointVector& v_max, const JointVector& a_max)
    : period_(period), v_max_(v_max), a_max_(a_max) {}

void ReferenceJoin::start(const JointReference& from, const JointReference& to) noexcept {
  start_ = to.time;
  const JointVector dq = from.q - to.q;
  dv_ = from.qd - to.qd;
  da_ = from.qdd - to.qdd;
  active_ = !(dq.isZero(0) && dv_.isZero(0) && da_.isZero(0));
  if (active_) choose_times(dq);
}

void ReferenceJoin::choose_times(const JointVector& dq) noexcept {
  d_v_ = period_;
  for (Eigen::Index i = 0; i < dq.size(); ++i) {
    const double a = kAccelerationOfVelocity * a_max_[i];
    d_v_ = std::max(d_v_, kVelocityPeak * std::abs(dv_[i]) / a);
  }
  d_a_ = d_v_;
  for (Eigen::Index i = 0; i < dq.size(); ++i) {
    const double v = kSpeedOfBump * v_max_[i];
    if (kBumpPeak * d_a_ * std::abs(da_[i]) > v) d_a_ = v / (kBumpPeak * std::abs(da_[i]));
  }
  d_a_ = std::max(d_a_, period_);

  way_ = dq + dv_ * (d_v_ / 2) + da_ * (d_a_ * d_a_ / 12);
  d_q_ = period_;
  for (Eigen::Index i = 0; i < dq.size(); ++i) {
    const double way = std::abs(way_[i]);
    d_q_ = std::max({d_q_, kWayPeak * way / (kSpeedOfWay * v_max_[i]),
                     std::sqrt(kWayPeak2 * way / (kAccelerationOfWay * a_max_[i]))});
  }
}

void ReferenceJoin::apply(JointReference& reference) noexcept {
  if (!active_) return;
  const double t = reference.time - start_;
  if (t >= std::max(d_v_, d_q_)) {  // d_a_ <= d_v_
    active_ = false;
    return;
  }
  add_acceleration_part(std::min(t / d_a_, 1.0), reference);
  add_velocity_part(std::min(t / d_v_, 1.0), reference);
  add_way_part(std::min(t / d_q_, 1.0), reference);
}

// The integrals of p' in the header, each less its share of c.
void ReferenceJoin::add_acceleration_part(double h, JointReference& reference) const noexcept {
  const double p = h * h * (0.5 + h * (0.25 * h - 2.0 / 3));
  reference.q += da_ * (d_a_ * d_a_ * (p - 1.0 / 12));
  reference.qd += da_ * (d_a_ * h * (1 - h) * (1 - h));
  reference.qdd += da_ * ((1 - h) * (1 - 3 * h));
}

void ReferenceJoin::add_velocity_part(double r, JointReference& reference) const noexcept {
  const double p = r * (1 + r * r * (0.5 * r - 1));
  reference.q += dv_ * (d_v_ * (p - 0.5));
  reference.qd += dv_ * (1 + r * r * (2 * r - 3));
  reference.qdd += dv_ * (6 * r * (r - 1) / d_v_);
}

void ReferenceJoin::add_way_part(double s, JointReference& reference) const noexcept {
  reference.q += way_ * (1 - s * s * s * (10 + s * (6 * s - 15)));
  reference.qd -= way_ * (30 * s * s * (1 - s) * (1 - s) / d_q_);
  reference.qdd -= way_ * (60 * s * (1 - s) * (1 - 2 * s) / (d_q_ * d_q_));
}

}  // namespace rob::motion
