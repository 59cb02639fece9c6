#include "motion/kinematics/gantry_kinematics.h"

#include <cmath>
#include <numbers>

namespace rob::motion {

Pose GantryKinematics::forward(const JointVector& q) const noexcept {
  const double half = q[2] / 2;
  return {Eigen::Vector3d(q[0], q[1], 0), Eigen::Quaterniond(std::cos(half), 0, 0, std::sin(half))};
}

InverseSolutions GantryKinematics::solutions(const Pose& pose,
                                             const JointVector& near) const noexcept {
  // m, and rad as the sine of half an angle. [choice] far above rounding, far below an encoder.
  constexpr double kOffPlane = 1e-9;
  const Eigen::Quaterniond& turn = pose.orientation;
  const bool in_plane =
      std::fabs(pose.position.z()) <= kOffPlane && std::hypot(turn.x(), turn.y()) <= kOffPlane;
  InverseSolutions found;
  if (!in_plane || !pose.position.allFinite()) return found;
  const double angle = 2 * std::atan2(turn.z(), turn.w());
  const double from_near = std::remainder(angle - near[2], 2 * std::numbers::pi);
  found.count = 1;
  found.q[0].resize(3);
  found.q[0] << pose.position.x(), pose.position.y(), near[2] + from_near;
  return found;
}

double GantryKinematics::lever(int axis, const Eigen::Vector3d& tip) const noexcept {
  return axis == 2 ? std::hypot(tip.x(), tip.y()) : 0;
}

}  // namespace rob::motion
