#include "runtime/control/units.h"

#include <fmt/format.h>

namespace rob::runtime {

std::string shown(double value, int decimals) {
  std::string text = fmt::format("{:.{}f}", value, decimals);
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  return text == "-0" ? "0" : text;
}

std::string shown(double si, motion::AxisKind kind) {
  constexpr int kDecimals = 6;  // nm or µdeg: finer than any machine, coarse enough for rounding
  return shown(si * shown_per_si(kind), kDecimals) + " " + unit_name(kind);
}

std::vector<double> shown_pose(const motion::Pose& pose) {
  const Eigen::Vector3d mm = pose.position * kMillimetresPerMetre;
  const motion::FixedAngles angles = motion::fixed_angles(pose.orientation);
  std::vector<double> values = {mm.x(), mm.y(), mm.z()};
  for (const double angle : {angles.a, angles.b, angles.c}) {
    values.push_back(angle * kDegreesPerRadian + 0.0);  // adding 0 makes -0 a 0
  }
  return values;
}

}  // namespace rob::runtime
