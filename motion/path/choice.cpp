#include "motion/path/choice.h"

#include <algorithm>

#include "base/unit_factors.h"

namespace rob::motion {

std::optional<JointVector> Choice::axes(double s, double value,
                                        const JointVector& near) const noexcept {
  JointVector from = near;
  if (axis_ >= 0) from[axis_] = value;
  const Pose tip = turned(path_.at(s), free_, value);
  return robot_.kinematics->beside(composed(tip, flange_), from);
}

double spread_of(const Axis& axis) noexcept {
  const double range = axis.max - axis.min;
  return axis.kind == AxisKind::Rotary ? std::min(range, kFullTurn) : range;
}

double Choice::apart() const noexcept {
  if (axis_ < 0) return kFullTurn / kSpreadValues;
  return spread_of(robot_.axes[static_cast<std::size_t>(axis_)]) / kSpreadValues;
}

}  // namespace rob::motion
