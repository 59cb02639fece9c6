#pragma once

#include <optional>

#include "motion/path/tool_path.h"

namespace rob::motion {

/// The arc of a circle, on which the tool turns by the shortest rotation, both evenly. The point
/// that it goes through says where, not how the tool is turned there.
class ToolArc final : public ToolPath {
 public:
  /// None where the places lie on a line (within 1e-9 of their distances) or the orientations are
  /// half a turn apart.
  static std::optional<ToolArc> through(const Pose& from, const Eigen::Vector3d& via,
                                        const Pose& to);

  Pose at(double s) const noexcept override;
  double way() const noexcept override { return angle_ * out_.norm(); }
  double turn() const noexcept override { return rotation_.norm(); }

 private:
  Pose from_;
  Eigen::Vector3d centre_;
  Eigen::Vector3d out_;    ///< from the centre to the beginning
  Eigen::Vector3d ahead_;  ///< as long, where the curve leads there
  double angle_ = 0;       ///< above 0, below a whole turn
  Eigen::Vector3d rotation_;
};

}  // namespace rob::motion
