#pragma once

#include <optional>

#include "motion/kinematics/kinematics.h"
#include "motion/path/tool_path.h"
#include "motion/robots/robot_model.h"

namespace rob::motion {

/// In so many evenly spread values a choice is looked at.
inline constexpr double kSpreadValues = 72;
/// Over which range: of an axis that turns round one turn.
double spread_of(const Axis& axis) noexcept;

/// One number that a robot may choose freely at each place of a path: the angle of a free turn, or
/// the value of its spare axis, rad (or m). Robot and path must outlive it.
class Choice {
 public:
  static Choice of_turn(const RobotModel& robot, const ToolPath& path, const Pose& tip,
                        const FreeTurn& free) {
    return Choice(robot, path, tip, free, -1);
  }
  /// The robot must have a spare axis (Kinematics::spare).
  static Choice of_axis(const RobotModel& robot, const ToolPath& path, const Pose& tip) {
    return Choice(robot, path, tip, {}, robot.kinematics->spare());
  }

  /// The axis values right beside `near` that bring the tip to the path's place s; none where there
  /// are none.
  std::optional<JointVector> axes(double s, double value, const JointVector& near) const noexcept;
  /// The choice where a path begins with these axis values.
  double first(const JointVector& start) const noexcept { return axis_ < 0 ? 0 : start[axis_]; }
  /// Between two of 72 evenly spread values: of a turn, or of the axis' range.
  double apart() const noexcept;

 private:
  Choice(const RobotModel& robot, const ToolPath& path, const Pose& tip, const FreeTurn& free,
         int axis)
      : robot_(robot), path_(path), flange_(inverse(tip)), free_(free), axis_(axis) {}

  const RobotModel& robot_;
  const ToolPath& path_;
  Pose flange_;  ///< seen from the tip
  FreeTurn free_;
  int axis_;  ///< −1: a turn is chosen
};

}  // namespace rob::motion
