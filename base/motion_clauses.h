#pragma once

#include <cstdint>

/// The subjects of the clauses of a motion: the same in the program and in its plan.
namespace rob {

/// AT: how fast.
enum class Pace : std::uint8_t {
  Unspecified,   ///< no AT
  ToolSpeed,     ///< AT 20mm/s: m/s of the tool point
  AngularSpeed,  ///< AT 10deg/s: rad/s of every rotary axis
  Share          ///< AT 50%: of all maxima, 1 = 100 %
};

/// ZONE: how the corner at the target is bounded.
enum class Zone : std::uint8_t {
  Unspecified,  ///< no ZONE: the robot's own
  Length,       ///< ZONE 5mm: m by which the tool may miss the target
  Time,         ///< ZONE 0.5s: half the time that the corner takes (Paul's law), or how long before
                ///< the target would be reached it begins (look-ahead law)
  Share         ///< ZONE 50%: of the robot's own, or of half of each leg; 1 = 100 %
};

/// ACCEL and JERK: what they bound.
enum class Bound : std::uint8_t {
  Unspecified,  ///< no clause: the robot's own
  Tool,         ///< the tool point, m/s², m/s³
  Rotary,       ///< every rotary axis, or on a path of the tool its turning, rad/s², rad/s³
  Share         ///< the robot's own of every axis, 1 = 100 %
};

/// PROFILE: how the speed of a motion from rest to rest rises and falls (S2).
enum class Profile : std::uint8_t { Unspecified, Rectangular, Trapezoidal, Parabolic, Cosine };

}  // namespace rob
