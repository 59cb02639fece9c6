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

JointPath JointPath::part(double from, double to) const {
  const double scale = to - from;
  std::vector<Node> part;
  const auto add = [&](double parameter) {
    const PathPoint point = at(parameter);
    part.push_back(
        {(parameter - from) / scale, point.q, scale * point.qd, scale * scale * point.qdd});
  };
  constexpr double kApart = 1e-9;  // of the part: nodes that are nearer are one
  add(from);
  for (const Node& node : nodes_)
    if (node.time > from + kApart * scale && node.time < to - kApart * scale) add(node.time);
  add(to);
  part.back().time = 1;
  return JointPath(std::move(part));
}

/// The quintic 10u³ − 15u⁴ + 6u⁵, which the pieces between the nodes reproduce.
void JointPath::bring(int axis, double target) {
  const double from = nodes_.front().q[axis];
  const double length = end() - begin();
  const double first = begin();
  for (Node& node : nodes_) {
    const double u = (node.time - first) / length;
    const double rest = 1 - u;
    node.q[axis] = from + (target - from) * u * u * u * (10 - 15 * u + 6 * u * u);
    node.qd[axis] = (target - from) * 30 * u * u * rest * rest / length;
    node.qdd[axis] = (target - from) * 60 * u * rest * (1 - 2 * u) / (length * length);
  }
}

PathPoint JointPath::between(std::size_t i, double parameter) const noexcept {
  const JointReference point = quintic_between(nodes_[i], nodes_[i + 1], parameter);
  return {point.q, point.qd, point.qdd};
}

}  // namespace rob::motion
