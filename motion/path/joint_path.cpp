#include "motion/path/joint_path.h"

#include <algorithm>

#include "motion/space/quintic.h"

namespace rob::motion {

PathPoint JointPath::at(double parameter) const noexcept {
  const double within = std::clamp(parameter, begin(), end());
  const auto behind =
      std::upper_bound(nodes_.begin() + 1, nodes_.end() - 1, within,
                       [](double value, const Node& node) { return value < node.time; });
  return between(static_cast<std::size_t>(behind - nodes_.begin()) - 1, within);
}

PathPoint JointPath::between(std::size_t i, double parameter) const noexcept {
  const JointReference point = quintic_between(nodes_[i], nodes_[i + 1], parameter);
  return {point.q, point.qd, point.qdd};
}

}  // namespace rob::motion
