#include "motion/path/tool_spiral.h"

#include <cmath>

#include "base/unit_factors.h"

namespace rob::motion {

std::optional<ToolSpiral> ToolSpiral::inwards(const Pose& from, const Eigen::Quaterniond& frame,
                                              double radius, double turns) {
  constexpr double kStands = 1e-6;  // [choice] rad off the plane's normal
  const Eigen::Vector3d normal = from.orientation * Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d x = frame * Eigen::Vector3d::UnitX();
  const Eigen::Vector3d in_plane = x - x.dot(normal) * normal;
  if (in_plane.norm() < kStands) return std::nullopt;
  ToolSpiral spiral;
  spiral.from_ = from;
  spiral.x_ = in_plane.normalized();
  spiral.y_ = normal.cross(spiral.x_);
  if (spiral.y_.dot(frame * Eigen::Vector3d::UnitY()) < 0) spiral.y_ = -spiral.y_;
  spiral.radius_ = radius;
  spiral.angle_ = kFullTurn * turns;
  return spiral;
}

Pose ToolSpiral::at(double s) const noexcept {
  const double angle = s * angle_;
  const double radius = (1 - s) * radius_;
  return {
      from_.position + (radius_ - radius * std::cos(angle)) * x_ + radius * std::sin(angle) * y_,
      from_.orientation};
}

/// The rest of the way where the radius is that share of the first: ∫ r·√(1 + k²u²) du.
double ToolSpiral::left(double radii) const noexcept {
  const double ku = angle_ * radii;
  return radius_ / 2 * (radii * std::sqrt(1 + ku * ku) + std::asinh(ku) / angle_);
}

double ToolSpiral::at_share(double share) const noexcept { return parameter_of(*this, share); }

}  // namespace rob::motion
