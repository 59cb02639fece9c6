#include "motion/servo/reference_join.h"

#include <algorithm>

namespace rob::motion {
namespace {

// What the parts of f, g and h may take of the limits. [choice] Of the jerk most is h's: the longer
// the acceleration goes on, the farther the speed goes.
constexpr double kSpeedOfWay = 1.0 / 10;
constexpr double kAccelerationOfWay = 1.0 / 8;
constexpr double kAccelerationOfStop = 3.0 / 8;
constexpr double kJerkOfWay = 1.0 / 16;
constexpr double kJerkOfStop = 1.0 / 8;
constexpr double kJerkOfAcceleration = 5.0 / 16;

/// Of a difference over its limit: one that is none takes no time, by limits that are still finite.
constexpr double kNothing = 1e-30;

/// How many times the difference a factor of it may change by, for a share of the limits.
double factor_limit(double share, const JointVector& limits, const JointVector& part) noexcept {
  return share / std::max((part.array().abs() / limits.array()).maxCoeff(), kNothing);
}

JointVector three(double f, double g, double h) noexcept {
  JointVector values(3);
  values << f, g, h;
  return values;
}

}  // namespace

ReferenceJoin::ReferenceJoin(const JointVector& v_max, const JointVector& a_max,
                             const JointVector& j_max)
    : v_max_(v_max), a_max_(a_max), j_max_(j_max), fgh_(v_max, a_max, j_max) {}

void ReferenceJoin::start(const JointReference& from, const JointReference& to) noexcept {
  way_ = from.q - to.q;
  speed_ = from.qd - to.qd;
  acceleration_ = from.qdd - to.qdd;
  active_ = !(way_.isZero(0) && speed_.isZero(0) && acceleration_.isZero(0));
  if (!active_) return;

  const double jerk = factor_limit(kJerkOfAcceleration, j_max_, acceleration_);
  const double tau = 1 / jerk;
  speed_ += acceleration_ * (tau / 2);

  const AxisState moving = {0, 1, 0};
  const AxisLimits to_stop = {1, factor_limit(kAccelerationOfStop, a_max_, speed_),
                              factor_limit(kJerkOfStop, j_max_, speed_)};
  const double lost = speed_change(moving, 0, to_stop).end(moving).q;
  way_ += speed_ * lost - acceleration_ * (tau * tau / 6);

  fgh_ = PointToPoint(three(factor_limit(kSpeedOfWay, v_max_, way_), to_stop.v, tau),
                      three(factor_limit(kAccelerationOfWay, a_max_, way_), to_stop.a, 1),
                      three(factor_limit(kJerkOfWay, j_max_, way_), to_stop.j, jerk));
  fgh_.aim({to.time, three(1, -lost, tau * tau / 6), three(0, 1, -tau / 2), three(0, 0, 1)},
           three(0, 0, 0));
}

void ReferenceJoin::apply(JointReference& reference) noexcept {
  if (!active_) return;
  active_ = reference.time < fgh_.arrival();
  if (!active_) return;
  const auto [time, c, cd, cdd] = fgh_.at(reference.time);
  reference.q += way_ * c[0] + speed_ * c[1] + acceleration_ * c[2];
  reference.qd += way_ * cd[0] + speed_ * cd[1] + acceleration_ * cd[2];
  reference.qdd += way_ * cdd[0] + speed_ * cdd[1] + acceleration_ * cdd[2];
}

}  // namespace rob::motion
