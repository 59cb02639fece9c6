#pragma once

#include <optional>

#include "motion/space/joint_vector.h"
#include "motion/space/pose.h"

namespace rob::motion {

/// From axes to tool. All calls are pure, take no memory and may be used in the tick.
class Kinematics {
 public:
  virtual ~Kinematics() = default;

  virtual int axes() const noexcept = 0;
  /// The tool's pose in the world; q: axes() values in m or rad.
  virtual Pose forward(const JointVector& q) const noexcept = 0;
  /// The axis values that bring the tool to a pose: of all solutions the one nearest to `near`.
  /// None if there is no solution. Limits of the axes are not looked at.
  virtual std::optional<JointVector> inverse(const Pose& pose,
                                             const JointVector& near) const noexcept = 0;
  /// In words, for messages: "places and turns its tool …".
  virtual const char* reach() const noexcept = 0;
};

}  // namespace rob::motion
