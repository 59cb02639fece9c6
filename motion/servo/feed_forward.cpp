#include "motion/servo/feed_forward.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace rob::motion {

FeedForward::FeedForward(std::span<const DriveData> drives, const std::optional<ArmMechanics>& arm)
    : count_(static_cast<int>(drives.size())), arm_(arm), carrying_(arm) {
  assert(drives.size() <= drives_.size());
  assert(!arm || count_ == Ums7Dynamics::kAxes);
  std::copy(drives.begin(), drives.end(), drives_.begin());
}

MotionForces FeedForward::at(const JointReference& reference) const noexcept {
  return arm_ ? of_arm(reference) : of_axes(reference);
}

MotionForces FeedForward::of_axes(const JointReference& reference) const noexcept {
  MotionForces forces{JointVector(count_), JointVector(count_), 0};
  for (int i = 0; i < count_; ++i) {
    const DriveData& drive = drives_[static_cast<std::size_t>(i)];
    forces.inertia[i] = drive.inertia;
    forces.u0[i] = drive.inertia * reference.qdd[i] + drive.viscous_friction * reference.qd[i];
  }
  return forces;
}

MotionForces FeedForward::of_arm(const JointReference& reference) const noexcept {
  const ArmInertia H = carrying_->dynamics.inertia(reference.q);
  JointVector G = arm_->dynamics.published_gravity(reference.q);
  if (load_) G += load_->gravity(reference.q);
  MotionForces forces{JointVector(count_), H.diagonal(), 0};
  JointVector P = H.times(reference.qdd) + G;
  for (int i = 0; i < count_; ++i) {
    const double most = arm_->motors[static_cast<std::size_t>(i)].torque_max;
    forces.load = std::max(forces.load, std::abs(P[i]) / most);
    P[i] = std::clamp(P[i], -most, most);
  }
  const JointVector admissible = forces.load > 1 ? H.solve(P - G) : reference.qdd;
  for (int i = 0; i < count_; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const auto& [Da, Db, most] = arm_->motors[at];
    forces.u0[i] = Da * P[i] + Db * admissible[i] + drives_[at].viscous_friction * reference.qd[i];
    forces.inertia[i] = Da * forces.inertia[i] + Db;
  }
  return forces;
}

void FeedForward::carry(const ArmLoad& load) noexcept {
  if (!arm_) return;
  carrying_ = arm_->carrying(load);
  load_.reset();
  if (load.mass > 0) load_ = arm_->load_alone(load);
}

JointVector FeedForward::load_weight(const JointVector& q) const noexcept {
  if (!load_) return JointVector::Zero(count_);
  JointVector weight = load_->gravity(q);
  for (int i = 0; i < count_; ++i)
    weight[i] *= arm_->motors[static_cast<std::size_t>(i)].load_factor;
  return weight;
}

}  // namespace rob::motion
