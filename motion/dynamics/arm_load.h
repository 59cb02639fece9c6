#pragma once

#include <Eigen/Core>

namespace rob::motion {

/// The load at an arm's flange: the tool, or an object that it has grasped. Loads add up.
struct ArmLoad {
  double mass = 0;                                   ///< kg
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();  ///< Σ m·r, r seen from the flange, kg·m
  double along = 0;                                  ///< Σ m·z², kg·m²
  double across = 0;                                 ///< Σ m·(x² + y²), kg·m²

  /// A mass (kg) as a point at `cog` (m), seen from the flange.
  static ArmLoad point(double mass, const Eigen::Vector3d& cog) noexcept {
    return {mass, mass * cog, mass * cog.z() * cog.z(), mass * cog.head<2>().squaredNorm()};
  }

  friend ArmLoad operator+(const ArmLoad& a, const ArmLoad& b) noexcept {
    return {a.mass + b.mass, a.moment + b.moment, a.along + b.along, a.across + b.across};
  }
  friend bool operator==(const ArmLoad&, const ArmLoad&) = default;
};

/// The two parts of an arm's load.
struct CarriedLoad {
  ArmLoad tool;
  ArmLoad grasped;

  ArmLoad all() const noexcept { return tool + grasped; }
  friend bool operator==(const CarriedLoad&, const CarriedLoad&) = default;
};

/// From the arm's axes to its flange, m.
struct ArmLengths {
  double upper_arm = 0;
  double forearm = 0;
  double hand = 0;  ///< from the wrist to the flange
};

}  // namespace rob::motion
