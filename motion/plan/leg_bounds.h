#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

#include "motion/dynamics/arm_mechanics.h"
#include "motion/path/tool_line.h"
#include "motion/space/joint_vector.h"
#include "motion/space/pose.h"

namespace rob::motion {

/// The bounds that a motion asks of the look-ahead law. The path is measured by σ: the way of the
/// tool's tip, m; where the tip does not move, 1 mm for each degree that the axes turn most.
struct LegBounds {
  static constexpr double kAny = std::numeric_limits<double>::infinity();

  JointVector from;                ///< m, rad: where the axes begin
  Pose tip;                        ///< of the tool, seen from the flange
  const ToolLine* line = nullptr;  ///< along which the tip is led; kept as long as the path
  /// An arm with what it carries; kept as long as the run. Null: its mechanics are not known.
  const ArmMechanics* mechanics = nullptr;
  double length = 0;        ///< m of σ from end to end; 0: no length
  double speed = kAny;      ///< m/s of σ: what AT and OVER ask for, whatever the axes can do
  double acceleration = 1;  ///< share of each axis' a_max that ACCEL and jerk leave, above 0
  double full = 1;          ///< the same whatever the jerk
  double window = 0;        ///< s: of the average that bounds the jerk; 0: it is unbounded
  double miss = kAny;       ///< m by which the tip may miss the target
  double turn = kAny;       ///< rad by which the tool's orientation and its rotary axes may
  double lead = kAny;       ///< m before the target from which the corner may begin
  double share = 1;         ///< of half of each leg that a corner at the target may take
  double first = kAny;      ///< m from its beginning that a corner may take of it
  double last = kAny;       ///< m before its end that one may
  bool paced = false;       ///< AT or OVER set `speed`
};

/// The target is one of two motions: it is passed within both of their zones.
inline void keep_within(const LegBounds& other, LegBounds& bounds) {
  bounds.miss = std::min(bounds.miss, other.miss);
  bounds.turn = std::min(bounds.turn, other.turn);
  bounds.lead = std::min(bounds.lead, other.lead);
  bounds.share = std::min(bounds.share, other.share);
}

}  // namespace rob::motion
