#include "motion/path/tool_path.h"

#include <numbers>

namespace rob::motion {

double measure_of(const ToolPath& path) noexcept {
  constexpr double kStandsStill = 1e-9;               // m
  constexpr double kPerRadian = 0.18 / std::numbers::pi;  // 1 mm a degree
  return path.way() > kStandsStill ? path.way() : path.turn() * kPerRadian;
}

}  // namespace rob::motion
