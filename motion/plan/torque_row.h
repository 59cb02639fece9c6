#pragma once

#include <limits>
#include <optional>

#include "motion/dynamics/arm_mechanics.h"
#include "motion/robots/robot_model.h"
#include "motion/space/path_point.h"

namespace rob::motion {

/// The bound that gears and drives set at a place of an arm's path. Along q(σ) with σ' and σ'' no
/// gear and no drive exceeds its limit (TorqueShare::kMost of its torque, or half of the torque
/// that weight leaves, if that is more) where
///
///     slope·|σ''| + bend·σ'² <= 1        σ' <= fastest
///
/// Each is the greatest of all axes, so that rows of several places can be put together by their
/// greatest values. σ in m.
struct TorqueRow {
  double slope = 0;                                          ///< s²/m
  double bend = 0;                                           ///< s²/m²
  double fastest = std::numeric_limits<double>::infinity();  ///< m/s: friction leaves half there
  int axis = -1;  ///< with the greatest slope; of it the path is said to be limited

  void take(const TorqueRow& other) noexcept;
};

/// `place`: derivatives with respect to σ. `rate`: σ' at most there, m/s; friction is counted for
/// it. Weight that is more than there is leaves next to nothing (overload()).
TorqueRow torque_row(const RobotModel& robot, const ArmMechanics& arm, const PathPoint& place,
                     double rate) noexcept;

/// An axis whose gear or drive does not bear what stands still at q.
struct Overload {
  int axis = 0;
  double weight = 0;  ///< N or Nm
  double limit = 0;   ///< the same
};
std::optional<Overload> overload(const RobotModel& robot, const ArmMechanics& arm,
                                 const JointVector& q) noexcept;

}  // namespace rob::motion
