#pragma once

#include "motion/kinematics/kinematics.h"

namespace rob::motion {

/// S1's gantry: axes x, y (m) and theta (rad) place and turn the tool in the plane z = 0. Linear
/// in the axes is linear in the world; there are no singularities.
class GantryKinematics final : public Kinematics {
 public:
  int axes() const noexcept override { return 3; }
  /// (x, y, theta) → position (x, y, 0), turned by c = theta about z.
  Pose forward(const JointVector& q) const noexcept override;
  /// Poses off the plane z = 0, or turned about another axis than z, have none.
  InverseSolutions solutions(const Pose& pose, const JointVector& near) const noexcept override;
  /// The flange is on the axis theta.
  double lever(int axis, const Eigen::Vector3d& tip) const noexcept override;
  const char* reach() const noexcept override {
    return "places its tool in the plane z = 0mm and turns it about z alone";
  }
};

}  // namespace rob::motion
