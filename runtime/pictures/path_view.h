#pragma once

#include <string>
#include <utility>
#include <vector>

#include "motion/robots/robot_model.h"
#include "runtime/pictures/tool_way.h"

namespace rob::runtime {

/// A way as it is seen from one side, mm: from above (x to the right, y up), or from the side (x to
/// the right, z up). The field is a little larger than what it shows, and never empty.
struct PathView {
  const char* id;      ///< "plan" or "side"
  const char* across;  ///< "x"
  const char* upward;  ///< "y" or "z"
  int up;              ///< the coordinate, from 0 on
  double left = 0, right = 0, bottom = 0, top = 0;

  double width() const { return right - left; }
  double height() const { return top - bottom; }
  /// A place of the world, m, as it is seen.
  std::pair<double, double> seen(const Eigen::Vector3d& place) const;
  /// Half of the way along the polyline.
  std::pair<double, double> middle_of(const std::vector<Eigen::Vector3d>& points) const;
  /// The distance between two lines of a grid: 1, 2 or 5 times a power of ten.
  double grid_step() const;
};

/// From above; of an arm, and where the way goes up or down, from the side, too.
std::vector<PathView> views_of(const motion::RobotModel& robot,
                               const std::vector<ToolWay::Stretch>& stretches);

}  // namespace rob::runtime
