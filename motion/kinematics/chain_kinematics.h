#pragma once

#include <vector>

#include "motion/kinematics/kinematics.h"

namespace rob::motion {

/// An arm of rotary axes, one after the other, in whatever places: from axes to tool alone. Such a
/// robot is commanded in its axes. Axes after the chain, a gripper's, do not move the flange.
class ChainKinematics final : public Kinematics {
 public:
  /// `joints`: the frame of each as seen from that of the one before, the first from the base; it
  /// turns about its own z. `flange`: as seen from the last. `axes`: as many as joints, or more.
  ChainKinematics(std::vector<Pose> joints, const Pose& flange, int axes);

  int axes() const noexcept override { return axes_; }
  Pose forward(const JointVector& q) const noexcept override;
  bool inverts() const noexcept override { return false; }
  InverseSolutions solutions(const Pose& pose, const JointVector& near) const noexcept override;
  /// The chain stretched out from there.
  double lever(int axis, const Eigen::Vector3d& tip) const noexcept override;
  LinkFrames frames(const JointVector& q) const noexcept override;
  const char* reach() const noexcept override;

 private:
  std::vector<Pose> joints_;
  Pose flange_;
  int axes_;
};

}  // namespace rob::motion
