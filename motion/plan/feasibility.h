#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "motion/kinematics/kinematics.h"
#include "motion/robots/robot_model.h"

namespace rob::motion {

/// Why a motion cannot be. Nothing has moved, nothing has been queued. SI.
struct Refusal {
  enum class Kind : std::uint8_t {
    NotFinite,     ///< axis; the target is no number
    BelowMinimum,  ///< axis, value = target, limit = the axis' minimum
    AboveMaximum,  ///< axis, value = target, limit = the axis' maximum
    BadPace,       ///< value = the pace, which must be a number above limit = 0
    BadDuration,   ///< value = the duration asked for, which must be a number of at least limit = 0
    BadZone,       ///< value = the zone, which must be a number above limit = 0
    BadBound,      ///< value = the acceleration or jerk, which must be a number above limit = 0
    TooLong,       ///< value = the duration needed, limit = the longest, s
    TooHeavy,      ///< axis, value = weight at `at` of `way`, limit = what is borne, N or Nm
    // On the way of the tool, at `at` of `way`:
    PathOutOfReach,    ///< the tool cannot be there: `shortfall`
    PathBelowMinimum,  ///< axis, limit = the axis' minimum; `other` says whether the target itself
    PathAboveMaximum,  ///< can be reached in another posture; limit = the axis' maximum
    PathSingular,      ///< axis; it would have to turn too fast there
    PathTooLong,       ///< it takes more nodes than a path may have
    OtherBranch        ///< NEAR is nearest to other axis values than those at the end, `q`
  };

  Kind kind = Kind::NotFinite;
  int axis = -1;  ///< −1 where no axis is to blame
  double value = 0;
  double limit = 0;
  double at = 0;         ///< m, or rad where only the orientation changes
  double way = 0;        ///< the same of the whole
  bool turning = false;  ///< only the orientation changes
  bool other = false;
  Shortfall shortfall{};
  JointVector q{};                ///< m, rad, at the place; empty where it is not known
  std::optional<Pose> nearest{};  ///< of PathOutOfReach: where the tip could be instead, if known
};

/// A target may lie this much (m, rad) outside a limit: what rounding in units and arithmetic
/// can do; the planner puts it back onto the limit. [choice: 1 nm, far below any encoder]
inline constexpr double kLimitTolerance = 1e-9;

/// Checks the components of a target that are given (bit i: axis i), and those alone, so that a
/// constant target can be judged before the program runs. The lowest axis at fault is reported.
std::optional<Refusal> check_target(const RobotModel& robot, std::uint8_t given,
                                    const std::array<double, kMaxJoints>& target) noexcept;

}  // namespace rob::motion
