#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

namespace rob::runtime {

/// A convex body. m.
struct Hull {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::array<int, 3>> faces;  ///< triangles, by the numbers of the vertices
};

/// The convex hull of points, of which there is at least one. Points in one plane or line have a
/// hull without volume.
Hull convex_hull(const std::vector<Eigen::Vector3d>& points);

/// The moments of a body of even density.
struct HullMoments {
  double volume = 0;  ///< m³
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< its principal axes, a column each
};
HullMoments moments_of(const Hull& hull);

/// The part of the hull at which `direction`·x lies from `low` to `high`. Empty where there is
/// none.
std::vector<Eigen::Vector3d> slice_of(const Hull& hull, const Eigen::Vector3d& direction,
                                      double low, double high);

/// m, from a point to the hull; 0 inside.
double distance_to(const Hull& hull, const Eigen::Vector3d& point);

}  // namespace rob::runtime
