#pragma once

#include "motion/space/joint_vector.h"

namespace rob::test {

/// The greatest difference of an axis, m or rad.
inline double distance(const motion::JointVector& a, const motion::JointVector& b) {
  return (a - b).cwiseAbs().maxCoeff();
}

}  // namespace rob::test
