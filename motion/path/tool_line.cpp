#include "motion/path/tool_line.h"

#include "motion/space/rotation.h"

namespace rob::motion {

std::optional<ToolLine> ToolLine::between(const Pose& from, const Pose& to) {
  const Eigen::Vector3d rotation = rotation_between(from.orientation, to.orientation);
  if (rotation.norm() > kLongestTurn) return std::nullopt;
  return ToolLine(from, to.position - from.position, rotation);
}

Pose ToolLine::at(double s) const noexcept {
  return {from_.position + s * shift_, rotation_by(s * rotation_) * from_.orientation};
}

}  // namespace rob::motion
