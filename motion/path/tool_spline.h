#pragma once

#include <optional>
#include <vector>

#include "motion/path/tool_path.h"

namespace rob::motion {

/// A smooth curve exactly through any number of poses: a cubic spline of place and rotation vector
/// (about axes of the world, from the first orientation on), twice continuously differentiable,
/// without curvature at its ends. Its parameter goes with the distances of the points.
class ToolSpline final : public ToolPath {
 public:
  /// Needs two poses or more. None where two neighbours are one, or half a turn apart.
  static std::optional<ToolSpline> through(const std::vector<Pose>& points);

  Pose at(double s) const noexcept override;
  double way() const noexcept override { return lengths_.back(); }
  double turn() const noexcept override { return turn_; }
  double greatest_speed() const noexcept override { return greatest_speed_; }
  double greatest_turning() const noexcept override { return greatest_turning_; }
  double first_point() const noexcept override { return knots_[1]; }
  double last_point() const noexcept override { return knots_[knots_.size() - 2]; }
  double parts() const noexcept override { return 8 + 2 / shortest_; }
  double at_share(double share) const noexcept override;
  double share_at(double s) const noexcept override;

 private:
  using Value = Eigen::Matrix<double, 6, 1>;  // m, rad

  void bend();
  void measure();

  Eigen::Quaterniond first_;
  std::vector<double> knots_;  ///< parameter of each point, 0 … 1
  std::vector<Value> values_;
  std::vector<Value> bends_;     ///< second derivatives in the points
  std::vector<double> lengths_;  ///< of the way, at even places of the parameter
  double shortest_ = 1;          ///< part between two knots
  double turn_ = 0;
  double greatest_speed_ = 0;
  double greatest_turning_ = 0;
};

}  // namespace rob::motion
