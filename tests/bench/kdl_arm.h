#pragma once

#include <memory>

#include "motion/kinematics/arm_kinematics.h"

namespace rob::bench {

/// The same arm under KDL (Orocos Kinematics and Dynamics Library), whose solvers serve any chain
/// of joints: forward and Jacobian by recursion, inverse by iteration (Levenberg-Marquardt) to one
/// solution. Angles are θ of ArmParameters, all signs and offsets left out.
class KdlArm {
 public:
  explicit KdlArm(const motion::ArmParameters& parameters);
  ~KdlArm();

  motion::Pose forward(const motion::JointVector& theta);
  /// Iterates from `from`; false: it has not found the pose within 1e-9 (its own measure).
  bool inverse(const motion::Pose& pose, const motion::JointVector& from,
               motion::JointVector& theta);
  Eigen::Matrix<double, 6, 6> jacobian(const motion::JointVector& theta);

 private:
  struct Solvers;
  std::unique_ptr<Solvers> solvers_;
};

}  // namespace rob::bench
