#pragma once

#include <Eigen/Core>

namespace rob::drivers {

/// How the tool's spring acts where it presses on something: SI.
struct ContactLaw {
  double stiffness = 0;     ///< N/m, alike in all directions
  double damping_time = 0;  ///< s: damping over stiffness, across the surface
  double friction = 0;      ///< Coulomb's, 1
};

/// A point that the tool carries: where it would be if nothing were in its way, and how that moves.
struct Carried {
  Eigen::Vector3d place = Eigen::Vector3d::Zero();     ///< m
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  ///< m/s
};

struct Plane {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< of length 1, towards where it is free
};

/// Where the carried point really is, and the force of the world on it. The tool hangs on its place
/// like a spring without mass, so that no step is too long to be stable.
struct Pressed {
  Eigen::Vector3d place = Eigen::Vector3d::Zero();  ///< m
  Eigen::Vector3d force = Eigen::Vector3d::Zero();  ///< N
  bool touching = false;
};

/// Presses a carried point, which was at `before`, on a plane: across it N = k·(depth + T·depth'),
/// at least 0; along it the spring holds the point where it sticks, and it slips as soon as k·(way)
/// would exceed μ·N. May be used in the tick.
Pressed press(const Plane& plane, const Carried& carried, const Eigen::Vector3d& before,
              const ContactLaw& law) noexcept;

}  // namespace rob::drivers
