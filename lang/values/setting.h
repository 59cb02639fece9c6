#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "lang/values/pose_math.h"

namespace rob::lang {

/// All that is within `radius` of a segment, m. Without a radius it is nothing.
struct CapsuleValue {
  Vector3 from;
  Vector3 to;
  double radius = 0;

  bool operator==(const CapsuleValue&) const = default;
};

/// A tool has at most so many.
inline constexpr std::size_t kMostToolCapsules = 3;

/// A TOOL: where its tip is, seen from the flange, its load, and its SHAPE.
struct ToolValue {
  PoseValue tip;    ///< m
  double mass = 0;  ///< kg
  Vector3 cog;      ///< its centre of gravity, seen from the flange, m
  std::array<CapsuleValue, kMostToolCapsules> shape{};  ///< seen from the flange
};

/// The setting that WITH and IN give: the tool that is moved to targets, and the frame of tuples,
/// of what stands after BY, of poses without a frame of their own, and of force and torque.
struct Setting {
  ToolValue tool;        ///< without WITH the flange itself
  PoseValue frame;       ///< in the world
  bool in_tool = false;  ///< IN TOOL: the tool where the motion begins; `frame` says nothing
  /// ALLOW: bodies and obstacles that may touch anything; null: none.
  std::shared_ptr<const std::vector<std::string>> allowed{};
};

/// PRESS: a force along one axis of the Setting's frame.
struct PressCommand {
  int axis = 0;      ///< 0, 1, 2 for X, Y, Z
  double force = 0;  ///< N, with the sign of `force` in that frame
  double limit = 0;  ///< m/s along the axis; 0: the robot's own
};

/// LOAD: what the robot carries beside its tool.
struct LoadCommand {
  double mass = 0;  ///< kg
  Vector3 cog;      ///< its centre of gravity, seen from the flange, m
};

/// The greatest LOAD, kg. [choice] that of `payload` in a robot file.
inline constexpr double kMostLoad = 1000;

/// The greatest OVERRIDE, 1 = 100 %. [choice] that of `--override`.
inline constexpr double kMostOverride = 2;

/// Help for an OVERRIDE that is refused.
constexpr std::string_view override_help(double share) {
  return share > 0 ? "write OVERRIDE 200%, and a greater AT where that is not enough"
                   : "at 0% the robot would stand for ever, and the program with it: HALT waits for"
                     " the operator, WAIT for a signal or a time; OVERRIDE 1% creeps";
}

}  // namespace rob::lang
