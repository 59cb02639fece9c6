#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "motion/path/joint_path.h"
#include "motion/path/tool_path.h"
#include "motion/path/value_spline.h"
#include "motion/robots/robot_model.h"

namespace rob::motion {

/// Why the axes cannot follow a path, and where.
struct PathTrouble {
  enum class Kind : std::uint8_t {
    OutOfReach,  ///< the tool cannot be there
    Singular,    ///< the axes would have to jump
    TooLong      ///< it takes more than kMostNodes
  };

  Kind kind = Kind::OutOfReach;
  double at = 0;  ///< the path's parameter
  int axis = -1;  ///< of Singular: the one that turns most
};

/// The axes along a path: all of it, or up to where they cannot go on.
struct Followed {
  JointPath axes;  ///< empty where not even its beginning can be followed
  std::optional<PathTrouble> trouble;
};

/// [choice] 1 MB of a path, and 20 m of an arm's line
inline constexpr std::size_t kMostNodes = 4096;

/// The motion of the axes by which the tip of a tool, which `tip` places on the flange, follows
/// `path`. They begin at `start`, which brings it to the path's beginning; further on continuity
/// decides among the closed form's solutions. Limits of the axes are not looked at.
///
/// Between nodes no axis turns by more than 5°, and the tip is within 0.0005 mm and 1e-5 rad of the
/// path: nodes are set until that holds. Axes that would turn farther within 0.01 mm of the path
/// and 1.25° of the tool's own turning, or 0.01° where the tip stands still, cannot follow it.
/// Where they are found by iteration it is 0.05 rad and 0.001 mm, and the place half-way between
/// two nodes must be the same from either.
///
/// `first`, `last`: what the axes do at the ends where other paths join; else the closed form says.
/// `spare`: the value of the robot's spare axis along the path; without it that axis stands.
Followed follow(const RobotModel& robot, const ToolPath& path, const Pose& tip,
                const JointVector& start, const PathPoint* first = nullptr,
                const PathPoint* last = nullptr, const ValueSpline* spare = nullptr);

}  // namespace rob::motion
