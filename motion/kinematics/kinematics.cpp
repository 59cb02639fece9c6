#include "motion/kinematics/kinematics.h"

#include <cmath>
#include <limits>

namespace rob::motion {

namespace {

/// A turn about z, multiplied from the left or the right, that leaves the shortest rotation.
Eigen::Quaterniond untwisted(const Eigen::Quaterniond& turn, bool left) {
  const double length = std::hypot(turn.w(), turn.z());
  if (!(length > 0)) return turn;
  const Eigen::Quaterniond back(turn.w() / length, 0, 0, -turn.z() / length);
  return left ? back * turn : turn * back;
}

}  // namespace

Eigen::Quaterniond without_free(const Eigen::Quaterniond& turn, Freedom freedom,
                                const Eigen::Quaterniond& frame) noexcept {
  if (freedom == Freedom::None) return turn;
  if (freedom == Freedom::C) return untwisted(turn, true);
  // Seen from the tool, where the free axis is z.
  return frame * untwisted(frame.conjugate() * turn * frame, false) * frame.conjugate();
}

std::optional<JointVector> Kinematics::inverse(const Pose& pose,
                                               const JointVector& near) const noexcept {
  std::optional<JointVector> nearest;
  double least = std::numeric_limits<double>::infinity();
  for (const JointVector& q : solutions(pose, near)) {
    const double distance = (q - near).squaredNorm();
    if (!(distance < least)) continue;
    least = distance;
    nearest = q;
  }
  return nearest;
}

}  // namespace rob::motion
