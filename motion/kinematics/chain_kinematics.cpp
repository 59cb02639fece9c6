#include "motion/kinematics/chain_kinematics.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rob::motion {

ChainKinematics::ChainKinematics(std::vector<Pose> joints, const Pose& flange, int axes)
    : joints_(std::move(joints)), flange_(flange), axes_(axes) {}

Pose ChainKinematics::forward(const JointVector& q) const noexcept {
  Pose flange = frames(q)[static_cast<std::size_t>(axes_)];
  flange.orientation.normalize();
  return flange;
}

/// Axes after the chain carry nothing that is known: they stand in the flange.
LinkFrames ChainKinematics::frames(const JointVector& q) const noexcept {
  LinkFrames frames;
  Pose pose;
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const double half = q[static_cast<Eigen::Index>(i)] / 2;
    pose = composed(pose, joints_[i]);
    pose.orientation = pose.orientation * Eigen::Quaterniond(std::cos(half), 0, 0, std::sin(half));
    frames[i] = pose;
  }
  std::fill(frames.begin() + static_cast<std::ptrdiff_t>(joints_.size()), frames.end(),
            composed(pose, flange_));
  return frames;
}

InverseSolutions ChainKinematics::solutions(const Pose& /*pose*/,
                                            const JointVector& /*near*/) const noexcept {
  return {};
}

double ChainKinematics::lever(int axis, const Eigen::Vector3d& tip) const noexcept {
  const auto first = static_cast<std::size_t>(axis);
  if (first >= joints_.size()) return 0;
  double length = flange_.position.norm() + tip.norm();
  for (std::size_t i = first + 1; i < joints_.size(); ++i) length += joints_[i].position.norm();
  return length;
}

const char* ChainKinematics::reach() const noexcept {
  return "is commanded in its axes alone, with MOVE and JOG JOINT: this version knows where they"
         " bring its tool, not what brings it to a pose";
}

}  // namespace rob::motion
