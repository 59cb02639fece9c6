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

Pose turned(const Pose& pose, const FreeTurn& free, double angle) noexcept {
  const double half = std::sin(angle / 2);
  const auto about = [&](const Eigen::Vector3d& axis) {
    return Eigen::Quaterniond(std::cos(angle / 2), half * axis.x(), half * axis.y(),
                              half * axis.z());
  };
  Pose result = pose;
  if (free.kind == Freedom::C) result.orientation = about(free.axis) * pose.orientation;
  if (free.kind == Freedom::Spin)
    result.orientation = pose.orientation * about(Eigen::Vector3d::UnitZ());
  return result;
}

/// The rotation that is left is the shortest where it does not turn about the free axis: with
/// R = w + v, the turn back by 2·atan2(v·axis, w).
Pose nearest_turn(const Pose& pose, const FreeTurn& free, const Eigen::Quaterniond& from) noexcept {
  const bool spin = free.kind == Freedom::Spin;
  const Eigen::Quaterniond turn =
      spin ? from.conjugate() * pose.orientation : pose.orientation * from.conjugate();
  const double along = spin ? turn.z() : turn.vec().dot(free.axis);
  return turned(pose, free, -2 * std::atan2(along, turn.w()));
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
