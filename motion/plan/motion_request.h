#pragma once

#include <array>
#include <cstdint>

#include "motion/plan/profile.h"
#include "motion/space/joint_vector.h"

namespace rob::motion {

/// The asker's own number. Motion carries it and does not know what it means.
using Tag = std::uint32_t;

/// A motion as it was asked for, perhaps incomplete. SI.
struct MotionRequest {
  enum class Pace : std::uint8_t { Unspecified, ToolSpeed, AngularSpeed, Share };

  /// How the corner at the target is bounded: under Paul's law, under the look-ahead law.
  enum class Zone : std::uint8_t {
    Robots,  ///< the robot's own t_acc; its own zone
    Length,  ///< m by which the tool may miss the target, under both
    Time,    ///< s: t_acc; it begins so long before the target would be reached
    Share    ///< 1 = 100 %: of the robot's own t_acc; of half of each leg
  };

  /// The subject of an acceleration or a jerk.
  enum class Bound : std::uint8_t {
    None,
    Tool,    ///< the tip, m/s², m/s³
    Rotary,  ///< every rotary axis, or on a path of the tool its turning, rad/s², rad/s³
    Share    ///< 1 = 100 %: of the robot's own of every axis
  };

  Tag tag = 0;
  bool relative = false;                    ///< the target counts from the last one
  std::uint8_t given = 0;                   ///< bit i: axis i has a target
  std::array<double, kMaxJoints> target{};  ///< m or rad
  Pace pace = Pace::Unspecified;
  double pace_value = 0;          ///< m/s, rad/s, or a share of all maxima (1 = 100 %)
  Pace live = Pace::Unspecified;  ///< what a pace speaks of that is said in every cycle: LivePace
  double at_least = 0;            ///< s, lower bound on the duration (S1: T_user)
  Zone zone = Zone::Robots;
  double zone_value = 0;      ///< above 0 where there is a zone
  double zone_angle = 0;      ///< rad; 0: the robot's. Paul's law does not look at it
  Bound accel = Bound::None;  ///< this and `jerk` under the look-ahead law alone
  double accel_value = 0;
  Bound jerk = Bound::None;
  double jerk_value = 0;
  ProfileShape profile = ProfileShape::None;
};

}  // namespace rob::motion
