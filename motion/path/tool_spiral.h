#pragma once

#include <optional>

#include "motion/path/tool_path.h"

namespace rob::motion {

/// S4's search: an Archimedean spiral from a radius inwards to its centre, in the plane normal to
/// the tool's z axis. The tool does not turn.
///
/// The centre lies `radius` along the frame's x axis, as that looks in the plane; from −x the
/// curve goes through +y. The radius shrinks evenly with the angle, which grows evenly with the
/// parameter: so the tip slows down with the radius. Its speed, which AT names, is that of the
/// circle at the beginning: 2π·r·n per unit of s.
class ToolSpiral final : public ToolPath {
 public:
  /// Needs radius and turns above 0. None where the frame's x axis stands on the plane.
  static std::optional<ToolSpiral> inwards(const Pose& from, const Eigen::Quaterniond& frame,
                                           double radius, double turns);

  Pose at(double s) const noexcept override;
  double way() const noexcept override { return left(1); }
  double turn() const noexcept override { return 0; }
  double greatest_speed() const noexcept override { return radius_ * angle_; }
  double parts() const noexcept override { return 8 + 2 * angle_; }
  double at_share(double share) const noexcept override;
  double share_at(double s) const noexcept override { return 1 - left(1 - s) / left(1); }

 private:
  double left(double radii) const noexcept;

  Pose from_;
  Eigen::Vector3d x_;
  Eigen::Vector3d y_;
  double radius_ = 0;
  double angle_ = 0;  ///< of all turns, rad
};

}  // namespace rob::motion
