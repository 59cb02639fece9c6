#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "lang/values/pose_math.h"

namespace rob::lang {

/// A tool's tip, found from poses of the flange in all of which it is in one place.
struct ToolFit {
  Vector3 tip;      ///< seen from the flange; the unit of the poses
  double miss = 0;  ///< root mean square of how far the tip is from the mean of its places
};

inline constexpr std::size_t kMostToolPoses = 16;

/// By least squares. Nothing where the poses do not tell: the tool is turned by less than 10°
/// between them, or about one axis only. Takes no memory.
std::optional<ToolFit> fit_tool(std::span<const PoseValue> flanges);

}  // namespace rob::lang
