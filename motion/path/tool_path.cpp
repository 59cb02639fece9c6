#include "motion/path/tool_path.h"

#include "motion/space/rotation.h"

namespace rob::motion {

ToolSpeed speed_at(const ToolPath& path, double s) noexcept {
  constexpr double kShare =
      1e-5;  // [choice] of the path: small beside its bends, far from rounding
  const double d = kShare * (path.end() - path.begin());
  const Pose before = path.at(s - d);
  const Pose behind = path.at(s + d);
  return {(behind.position - before.position).norm() / (2 * d),
          rotation_between(before.orientation, behind.orientation).norm() / (2 * d)};
}

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
  constexpr double kStandsStill = 1e-9;  // m
  return path.way() > kStandsStill ? path.way() : path.turn() * kPerRadian;
}

}  // namespace rob::motion
