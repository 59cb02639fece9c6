#pragma once

#include <optional>

#include "motion/path/tool_path.h"

namespace rob::motion {

/// A straight line, on which the tool turns by the shortest rotation, both evenly.
class ToolLine final : public ToolPath {
 public:
  /// None where the orientations are half a turn apart.
  static std::optional<ToolLine> between(const Pose& from, const Pose& to);

  Pose at(double s) const noexcept override;
  double way() const noexcept override { return shift_.norm(); }
  double turn() const noexcept override { return rotation_.norm(); }

  /// From end to end: m; rad about axes of the world.
  const Eigen::Vector3d& shift() const noexcept { return shift_; }
  const Eigen::Vector3d& rotation() const noexcept { return rotation_; }

 private:
  ToolLine(const Pose& from, const Eigen::Vector3d& shift, const Eigen::Vector3d& rotation)
      : from_(from), shift_(shift), rotation_(rotation) {}

  Pose from_;
  Eigen::Vector3d shift_;
  Eigen::Vector3d rotation_;
};

}  // namespace rob::motion
