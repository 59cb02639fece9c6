#include "motion/servo/reference_join.h"

#include <array>

namespace rob::motion {
namespace {

constexpr double kOfSpeed = 1.0 / 10;
constexpr double kOfAcceleration = 1.0 / 2;
constexpr double kOfJerk = 1.0 / 2;

constexpr double kMoment = 0.1;  ///< s, to compare the three. [choice] What a join takes
constexpr double kAlong = 1e-6;  ///< of the greatest, beside it. [choice] More than rounding leaves

/// The limits in proportion to a direction.
JointVector in_proportion(const JointVector& limits, const JointVector& direction) noexcept {
  return direction * (limits.array() / direction.array()).minCoeff();
}

}  // namespace

ReferenceJoin::ReferenceJoin(const JointVector& v_max, const JointVector& a_max,
                             const JointVector& j_max)
    : v_max_(kOfSpeed * v_max),
      a_max_(kOfAcceleration * a_max),
      j_max_(kOfJerk * j_max),
      way_(v_max_, a_max_, j_max_) {}

void ReferenceJoin::start(const JointReference& from, const JointReference& to) noexcept {
  const JointReference left = {to.time, from.q - to.q, from.qd - to.qd, from.qdd - to.qdd};
  active_ = !(left.q.isZero(0) && left.qd.isZero(0) && left.qdd.isZero(0));
  if (!active_) return;
  const JointVector direction = direction_of(left);
  way_ = direction.size() == 0
             ? PointToPoint(v_max_, a_max_, j_max_)
             : PointToPoint(in_proportion(v_max_, direction), in_proportion(a_max_, direction),
                            in_proportion(j_max_, direction));
  way_.aim(left, JointVector::Zero(v_max_.size()));
}

/// Along which all of it lies, none of its components 0; of no size where there is none.
JointVector ReferenceJoin::direction_of(const JointReference& left) const noexcept {
  const std::array<JointVector, 3> parts = {left.q.cwiseQuotient(v_max_),
                                            left.qd.cwiseQuotient(v_max_) * kMoment,
                                            left.qdd.cwiseQuotient(v_max_) * (kMoment * kMoment)};
  JointVector most = parts[0];
  for (const JointVector& part : parts)
    if (part.norm() > most.norm()) most = part;
  for (const JointVector& part : parts) {
    const JointVector beside = part - most * (part.dot(most) / most.squaredNorm());
    if (beside.norm() > kAlong * most.norm()) return {};
  }
  return most.cwiseAbs().cwiseMax(kAlong * most.norm()).cwiseProduct(v_max_);
}

void ReferenceJoin::apply(JointReference& reference) noexcept {
  active_ = active_ && reference.time < way_.arrival();
  behind_ = 0;
  if (!active_) return;
  const JointReference left = way_.at(reference.time);
  behind_ = kOfSpeed * (left.q.array() / v_max_.array()).abs().maxCoeff();
  reference.q += left.q;
  reference.qd += left.qd;
  reference.qdd += left.qdd;
}

}  // namespace rob::motion
