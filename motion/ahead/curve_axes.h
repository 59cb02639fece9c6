#pragma once

#include "motion/ahead/path_item.h"
#include "motion/path/curve_fit.h"
#include "motion/robots/robot_model.h"

namespace rob::motion {

/// From u to u of a CurveFit, both settled.
struct CurvePart {
  double begin = 0;
  double end = 0;
};

/// The axes of an arm whose tool follows a part of a curve without turning, with `first`
/// at its beginning, of a parameter 0 … 1; its derivatives may be empty. `like`: of a motion on it
/// that has a line. If the axes cannot follow, they lead through the targets of the stretch's
/// motions instead, which they can reach.
JointPath follow_curve(const RobotModel& robot, const CurveFit& fit, const CurvePart& part,
                       const PathStretch& stretch, const LegBounds& like, const PathPoint& first);

/// The same with its last place, but for rounding, there.
JointPath ending_at(const JointPath& axes, const JointVector& q);

/// Fills PathStretch::slopes.
void note_slopes(const CurveFit& fit, const CurvePart& part, PathStretch& stretch);

}  // namespace rob::motion
