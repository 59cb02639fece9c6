#include "motion/kinematics/gantry_kinematics.h"

#include <cmath>

namespace rob::motion {

Pose GantryKinematics::forward(const JointVector& q) const noexcept {
  const double half = q[2] / 2;
  return {Eigen::Vector3d(q[0], q[1], 0), Eigen::Quaterniond(std::cos(half), 0, 0, std::sin(half))};
}

}  // namespace rob::motion
