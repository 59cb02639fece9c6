#pragma once

#include "motion/space/joint_vector.h"

namespace rob::motion {

/// A place on a path and its derivatives along the path's own parameter or time.
struct PathPoint {
  JointVector q;
  JointVector qd;
  JointVector qdd;
};

/// The same where the parameter is itself a function of time: the chain rule.
inline PathPoint driven(const PathPoint& along, double rate, double acceleration) noexcept {
  return {along.q, along.qd * rate, along.qdd * (rate * rate) + along.qd * acceleration};
}

}  // namespace rob::motion
