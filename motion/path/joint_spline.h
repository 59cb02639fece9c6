#pragma once

#include <optional>
#include <vector>

#include "motion/path/joint_path.h"
#include "motion/path/tool_path.h"
#include "motion/robots/robot_model.h"

namespace rob::motion {

/// A smooth curve of the axes exactly through any number of points: a cubic spline of each axis,
/// twice continuously differentiable, without a second derivative at its ends. Its parameter goes
/// with the time that the slowest axis takes from point to point at its full speed. As a ToolPath
/// it is what the tip of a tool does meanwhile; what it turns is what the axis does that turns
/// most.
class JointSpline final : public ToolPath {
 public:
  /// Needs two points or more, m and rad; `tip`: of the tool, seen from the flange. None where two
  /// neighbours are one. The robot must outlive it.
  static std::optional<JointSpline> through(const RobotModel& robot, const Pose& tip,
                                            const std::vector<JointVector>& points);

  const JointPath* axes() const noexcept override { return &axes_; }
  Pose at(double s) const noexcept override;
  double way() const noexcept override { return lengths_.back(); }
  double turn() const noexcept override { return turn_; }
  double greatest_speed() const noexcept override { return greatest_speed_; }
  double greatest_turning() const noexcept override { return greatest_turning_; }
  double first_point() const noexcept override { return first_point_; }
  double last_point() const noexcept override { return last_point_; }
  double at_share(double share) const noexcept override { return parameter_of(*this, share); }
  double share_at(double s) const noexcept override;

 private:
  JointSpline(const RobotModel& robot, const Pose& tip) : robot_(&robot), tip_(tip) {}

  void measure();

  const RobotModel* robot_;
  Pose tip_;
  JointPath axes_;
  std::vector<double> lengths_;  ///< of the tip's way, m, at even places of the parameter
  double turn_ = 0;
  double greatest_speed_ = 0;
  double greatest_turning_ = 0;
  double first_point_ = 1;
  double last_point_ = 0;
};

}  // namespace rob::motion
