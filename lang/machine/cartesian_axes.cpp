#include "lang/machine/cartesian_axes.h"

#include "lang/text/ascii.h"

namespace rob::lang {
namespace {

struct Parts {
  Vector3 place;
  FixedAngles angles;

  double* named(std::string_view name) {
    if (same_word(name, "x")) return &place.x;
    if (same_word(name, "y")) return &place.y;
    if (same_word(name, "z")) return &place.z;
    if (same_word(name, "a")) return &angles.a;
    if (same_word(name, "b")) return &angles.b;
    if (same_word(name, "c") || same_word(name, "theta")) return &angles.c;
    return nullptr;
  }
};

}  // namespace

PoseValue tool_of(const std::vector<RobotSignature::Coordinate>& coordinates,
                  std::span<const double> values) {
  Parts parts;
  for (std::size_t i = 0; i < coordinates.size(); ++i) {
    if (double* const part = parts.named(coordinates[i].name)) *part = values[i];
  }
  return {parts.place, pose_math::from_fixed(parts.angles)};
}

PoseValue with_coordinates(const std::vector<RobotSignature::Coordinate>& coordinates,
                           const PoseValue& pose, const MoveCommand& command) {
  Parts parts{pose.position, pose_math::to_fixed(pose.rotation)};
  bool turned = false;
  for (std::size_t i = 0; i < coordinates.size(); ++i) {
    double* const part = parts.named(coordinates[i].name);
    if (part == nullptr || !command.has(static_cast<int>(i))) continue;
    *part = command.target[i] + (command.relative ? *part : 0);
    turned = turned || coordinates[i].dimension == kAngle;
  }
  return {parts.place, turned ? pose_math::from_fixed(parts.angles) : pose.rotation};
}

bool coordinates_of(const std::vector<RobotSignature::Coordinate>& coordinates,
                    const PoseValue& pose, std::span<double> values) {
  constexpr double kThere = 1e-9;  // m, rad; [choice] far above rounding
  Parts parts{pose.position, pose_math::to_fixed(pose.rotation)};
  for (std::size_t i = 0; i < coordinates.size(); ++i) {
    const double* const part = parts.named(coordinates[i].name);
    values[i] = part == nullptr ? 0 : *part;
  }
  const PoseValue reached = tool_of(coordinates, values);
  return pose_math::distance(reached, pose) < kThere && pose_math::turn(reached, pose) < kThere;
}

}  // namespace rob::lang
