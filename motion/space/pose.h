#pragma once

#include <Eigen/Geometry>

namespace rob::motion {

/// Position (m) and orientation of a frame seen from another. May be used in the tick.
struct Pose {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
};

/// Where a point is that is seen from a frame, m, as seen from where the frame itself is.
inline Eigen::Vector3d place_of(const Eigen::Vector3d& point, const Pose& frame) {
  return frame.position + frame.orientation * point;
}

/// A frame that is seen from another, as seen from where that one is.
inline Pose composed(const Pose& frame, const Pose& inner) {
  return {place_of(inner.position, frame), frame.orientation * inner.orientation};
}

/// The frame from which this one is seen, as seen from it.
inline Pose inverse(const Pose& pose) {
  const Eigen::Quaterniond back = pose.orientation.conjugate();
  return {-(back * pose.position), back};
}

/// Rotations about the fixed axes x, y, z, in rad: R = Rz(c)·Ry(b)·Rx(a) (seeds: S3).
struct FixedAngles {
  double a = 0;
  double b = 0;
  double c = 0;
};

Eigen::Quaterniond orientation_from(const FixedAngles& angles);

/// a and c in (−π, π], b in [−π/2, π/2]. At b = ±π/2 only c ∓ a is determined: a is then 0.
FixedAngles fixed_angles(const Eigen::Quaterniond& orientation);

}  // namespace rob::motion
