#include "lang/check/plain_targets.h"

#include "lang/check/target.h"

namespace rob::lang {

std::optional<PlainTargets::Target> PlainTargets::of(const PlainMotion& motion,
                                                     std::uint32_t file) {
  if (units_.empty() || file_ != file) {
    units_.clear();
    file_ = file;
    for (const RobotSignature::Coordinate& coordinate : robot_.coordinates) {
      units_.push_back(default_unit(coordinate.dimension, robot_, file));
    }
  }
  // Six axes: (x, y, z) keeps the orientation.
  const auto count = static_cast<int>(units_.size());
  if (motion.count != count && (count != 6 || motion.count != 3)) return std::nullopt;
  Target target;
  for (std::size_t i = 0; i < static_cast<std::size_t>(motion.count); ++i) {
    const PlainMotion::Component& component = motion.components[i];
    if (component.number.empty()) continue;
    const Unit unit = component.unit.value_or(units_[i]);
    if (unit.dimension != units_[i].dimension) return std::nullopt;
    const auto value = to_si(component.number, unit);
    if (!value) return std::nullopt;
    target.values[i] = component.negative ? 0 - *value : *value;
    target.given = static_cast<std::uint8_t>(target.given | 1U << i);
  }
  return target;
}

}  // namespace rob::lang
