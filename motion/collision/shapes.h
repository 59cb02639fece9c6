#pragma once

#include <Eigen/Core>

#include "motion/space/pose.h"

/// Simple bodies, m, in the frame of what carries them.
namespace rob::motion {

/// All that is within `radius` of a segment. Links, tools and gripped parts are made of them.
struct Capsule {
  Eigen::Vector3d from = Eigen::Vector3d::Zero();
  Eigen::Vector3d to = Eigen::Vector3d::Zero();
  double radius = 0;
};

struct Sphere {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  double radius = 0;
};

struct Box {
  Pose centre;
  Eigen::Vector3d half = Eigen::Vector3d::Zero();  ///< of its edges
};

/// All that is not above a height: a table, a floor.
struct HalfSpace {
  double height = 0;
};

inline Capsule moved(const Capsule& capsule, const Pose& frame) {
  return {place_of(capsule.from, frame), place_of(capsule.to, frame), capsule.radius};
}

}  // namespace rob::motion
