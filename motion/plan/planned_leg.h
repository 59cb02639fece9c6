#pragma once

#include <optional>

#include "motion/path/joint_path.h"
#include "motion/path/paced_path.h"
#include "motion/path/tool_line.h"
#include "motion/plan/corner.h"

namespace rob::motion {

/// The geometry that a SegmentDescriptor points into.
struct PlannedLeg {
  std::optional<JointPath> axes;  ///< none: straight in the axes
  std::optional<ToolLine> line;   ///< where the tip runs straight and evenly along `axes`
  std::optional<PaceLaw> pace;    ///< where it is slowed down at places: what made `axes`
  std::optional<Corner> corner;   ///< out of the motion before
};

}  // namespace rob::motion
