#include "motion/kinematics/kinematics.h"

#include <limits>

namespace rob::motion {

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
