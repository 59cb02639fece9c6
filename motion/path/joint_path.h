#pragma once

#include <vector>

#include "motion/space/joint_vector.h"
#include "motion/space/path_point.h"

namespace rob::motion {

/// The motion of the axes along a path: a quintic from node to node, so that values, first and
/// second derivatives are continuous. m, rad.
///
/// A node is a JointReference whose `time` is the path's parameter. Making one takes memory; at()
/// may be used in the tick: a search in the nodes and one polynomial.
class JointPath {
 public:
  using Node = JointReference;

  JointPath() = default;
  /// Needs two nodes or more, of rising parameter.
  explicit JointPath(std::vector<Node> nodes) : nodes_(std::move(nodes)) {}

  double begin() const noexcept { return nodes_.front().time; }
  double end() const noexcept { return nodes_.back().time; }
  const std::vector<Node>& nodes() const noexcept { return nodes_; }

  /// At a parameter; beyond an end, that end.
  PathPoint at(double parameter) const noexcept;

  /// The part between two parameters, as a path of 0 … 1.
  JointPath part(double from, double to) const;

  /// Brings one axis evenly from where it begins to `target`, at rest at both ends, whatever it did
  /// before.
  void bring(int axis, double target);

  /// Calls visit(parameter, point) at `parts` places of each piece, in order, and at the end.
  template <typename Visit>
  void survey(int parts, Visit&& visit) const {
    for (std::size_t i = 0; i + 1 < nodes_.size(); ++i) {
      const double step = (nodes_[i + 1].time - nodes_[i].time) / parts;
      for (int k = 0; k < parts; ++k) {
        const double parameter = nodes_[i].time + k * step;
        visit(parameter, between(i, parameter));
      }
    }
    visit(end(), at(end()));
  }

 private:
  PathPoint between(std::size_t i, double parameter) const noexcept;

  std::vector<Node> nodes_;
};

}  // namespace rob::motion
