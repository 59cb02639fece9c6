#pragma once

#include "motion/path/joint_path.h"

namespace rob::motion {

/// The motion of the axes from the beginning of one motion to its end: straight, or along a path of
/// the tool. m, rad, s. Calls may be used in the tick.
struct LegMotion {
  const JointPath* path = nullptr;  ///< of a parameter 0 … 1; null: straight in the axes
  JointVector from;
  JointVector to;
  double duration = 1;  ///< s from end to end, evenly along the leg's parameter

  /// At a share of the leg that has these derivatives.
  PathPoint along(double share, double rate, double acceleration) const noexcept {
    if (path != nullptr) return driven(path->at(share), rate, acceleration);
    const JointVector way = to - from;
    return {from + way * share, way * rate, way * acceleration};
  }
  /// `t` s after its beginning.
  PathPoint at(double t) const noexcept { return along(t / duration, 1 / duration, 0); }
};

}  // namespace rob::motion
