#pragma once

#include <Eigen/Core>

namespace rob::motion {

inline constexpr int kMaxJoints = 8;

/// One value per axis: m or rad, or their rates. Lives wholly in the object (no heap), so it may be
/// used in the tick.
using JointVector = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, kMaxJoints, 1>;

/// Where every axis shall be at one instant, and how it is moving there. s, SI.
struct JointReference {
  double time = 0;
  JointVector q;
  JointVector qd;
  JointVector qdd;
};

/// What the servo measured at one instant. s, SI. Velocities are estimates.
struct JointMeasurement {
  double time = 0;
  JointVector q;
  JointVector qd;
};

}  // namespace rob::motion
