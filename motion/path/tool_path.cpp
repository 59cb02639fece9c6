#include "motion/path/tool_path.h"

#include <numbers>

namespace rob::motion {

double parameter_of(const ToolPath& path, double share) noexcept {
  double low = path.begin();
  double high = path.end();
  for (int i = 0; i < 60; ++i) {  // halvings: to the last bit
    const double middle = (low + high) / 2;
    (path.share_at(middle) < share ? low : high) = middle;
  }
  return high;
}

double measure_of(const ToolPath& path) noexcept {
  constexpr double kStandsStill = 1e-9;                   // m
  constexpr double kPerRadian = 0.18 / std::numbers::pi;  // 1 mm a degree
  return path.way() > kStandsStill ? path.way() : path.turn() * kPerRadian;
}

}  // namespace rob::motion
