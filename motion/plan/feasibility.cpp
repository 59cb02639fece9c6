#include "motion/plan/feasibility.h"

#include <cmath>

namespace rob::motion {

std::optional<Refusal> check_target(const RobotModel& robot, std::uint8_t given,
                                    const std::array<double, kMaxJoints>& target) noexcept {
  for (int i = 0; i < robot.axis_count(); ++i) {
    if ((given >> i & 1) == 0) continue;
    const Axis& axis = robot.axes[static_cast<std::size_t>(i)];
    const double value = target[static_cast<std::size_t>(i)];
    if (!std::isfinite(value)) return Refusal{Refusal::Kind::NotFinite, i, value, 0};
    if (value < axis.min - kLimitTolerance)
      return Refusal{Refusal::Kind::BelowMinimum, i, value, axis.min};
    if (value > axis.max + kLimitTolerance)
      return Refusal{Refusal::Kind::AboveMaximum, i, value, axis.max};
  }
  return std::nullopt;
}

}  // namespace rob::motion
