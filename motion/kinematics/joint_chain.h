#pragma once

#include <limits>
#include <vector>

#include <Eigen/Core>

#include "motion/space/joint_vector.h"
#include "motion/space/pose.h"

namespace rob::motion {

/// One axis of a chain: it turns about the z of its frame, or slides along it.
struct ChainJoint {
  Pose place;  ///< its frame seen from that of the joint before, the first from the base; at zero
  bool linear = false;
  double min = -std::numeric_limits<double>::infinity();  ///< m or rad
  double max = std::numeric_limits<double>::infinity();
};

/// Up to eight joints, one after the other, in whatever places. m, rad. Calls take no memory.
class JointChain {
 public:
  /// [velocity of the flange; its angular velocity] = jacobian·q', both in the base; columns beyond
  /// the joints are 0.
  using Jacobian = Eigen::Matrix<double, 6, kMaxJoints>;

  /// `flange`: seen from the last joint.
  JointChain(std::vector<ChainJoint> joints, const Pose& flange);

  int size() const noexcept { return static_cast<int>(joints_.size()); }
  const ChainJoint& joint(int i) const noexcept { return joints_[static_cast<std::size_t>(i)]; }
  const Pose& flange() const noexcept { return flange_; }

  /// Only the first size() values of q count.
  Pose forward(const JointVector& q) const noexcept { return walk(q, nullptr); }
  Pose forward(const JointVector& q, Jacobian& jacobian) const noexcept {
    return walk(q, &jacobian);
  }

  /// Where the axes are at q: each a point on it and its direction, in the base.
  struct Line {
    Eigen::Vector3d point;
    Eigen::Vector3d direction;
  };
  std::vector<Line> lines(const JointVector& q) const;

 private:
  struct Step {
    Eigen::Matrix3d turn;
    Eigen::Vector3d place;
  };

  Pose walk(const JointVector& q, Jacobian* jacobian) const noexcept;

  std::vector<ChainJoint> joints_;
  std::vector<Step> steps_;  ///< the places of the joints, as matrices
  Pose flange_;
};

}  // namespace rob::motion
