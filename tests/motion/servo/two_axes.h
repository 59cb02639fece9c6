#pragma once

#include "motion/space/joint_vector.h"

namespace rob::test {

/// One value for each of two axes.
inline motion::JointVector both(double x, double y) {
  motion::JointVector v(2);
  v << x, y;
  return v;
}

}  // namespace rob::test
