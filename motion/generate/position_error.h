#pragma once

#include <cstdint>

#include "motion/robots/robot_model.h"
#include "motion/robots/settle_window.h"
#include "motion/space/joint_vector.h"

namespace rob::motion {

/// The reason that keeps a robot outside of its in-position window. Among several it is the first
/// one in the order of Kind.
struct PositionError {
  enum class Kind : std::uint8_t {
    None,   ///< it is in position
    Place,  ///< the tip of its tool is `value` m away
    Turn,   ///< its tool is turned by `value` rad
    Axis    ///< `axis`, a rotary one, is `value` rad away
  };

  Kind kind = Kind::None;
  int axis = -1;
  double value = 0;
  double limit = 0;  ///< that the window sets
};

/// Compares where the axes are with where they should be, m and rad. May be used in the tick.
PositionError position_error(const RobotModel& robot, const SettleWindow& window,
                             const JointVector& measured, const JointVector& reference) noexcept;

}  // namespace rob::motion
