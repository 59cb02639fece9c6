#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "base/motion_clauses.h"
#include "motion/kinematics/kinematics.h"
#include "motion/space/joint_vector.h"

namespace rob::motion {

/// The asker's own number. Motion carries it and does not know what it means.
using Tag = std::uint32_t;

/// A motion as it was asked for, perhaps incomplete. SI.
struct MotionRequest {
  using Pace = rob::Pace;
  using Zone = rob::Zone;
  using Bound = rob::Bound;

  Tag tag = 0;
  bool relative = false;                    ///< the target counts from the last one
  std::uint8_t given = 0;                   ///< bit i: axis i has a target
  std::array<double, kMaxJoints> target{};  ///< m or rad
  Pace pace = Pace::Unspecified;
  double pace_value = 0;          ///< m/s, rad/s, or a share of all maxima (1 = 100 %)
  Pace live = Pace::Unspecified;  ///< what a pace speaks of that is said in every cycle: LivePace
  double at_least = 0;            ///< s, lower bound on the duration (S1: T_user)
  Zone zone = Zone::Unspecified;
  double zone_value = 0;             ///< above 0 where there is a zone
  double zone_angle = 0;             ///< rad; 0: the robot's. Paul's law does not look at it
  Bound accel = Bound::Unspecified;  ///< this and `jerk` under the look-ahead law alone
  double accel_value = 0;
  Bound jerk = Bound::Unspecified;
  double jerk_value = 0;
  Profile profile = Profile::Unspecified;
  bool whole = false;  ///< the target is a whole pose, with what the axes leave to the place
  /// FREE: what of the poses the robot chooses, their own value of it means nothing. None: what
  /// its file says.
  std::optional<FreeTurn> free{};
  /// NEAR: the branch nearest to these joints; none: that nearest to the last target's.
  std::optional<JointVector> near{};
};

}  // namespace rob::motion
