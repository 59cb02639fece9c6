#pragma once

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
};

}  // namespace rob::motion
