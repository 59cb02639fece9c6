#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace rob::lang {

/// A value that a program reads of the robot by a name of the language, and how many slots it
/// takes.
enum class Reading : std::uint8_t {
  Clock,   ///< CLOCK: s since the start of the program
  Unix,    ///< UNIX(): s since 1970 began: by the computer's clock at the start, then by CLOCK
  Now,     ///< NOW(): the same, then how far the local time is ahead of UTC, s
  Here,    ///< HERE: the tool in the world, x y z (m) and w i j k; from the commanded axes
  Joints,  ///< JOINTS(): the same as one value an axis, m or rad
  Target,  ///< TARGET: the tool at the last target commanded; known without looking
  /// HITPOSE: the tool in the world where the condition of the last guarded motion came true, or
  /// where that motion ended; known without looking
  HitPose,
  Force,   ///< force: N, the reaction on the tool. A Machine gives it along x y z of the world; the
           ///< program sees it along those of the active frame (seen_from.h)
  Torque,  ///< torque: Nm, in the same way
  Wrench   ///< WRENCH(): force, then torque
};

inline constexpr std::array<std::string_view, 10> kReadingNames{
    "CLOCK", "UNIX", "NOW", "HERE", "JOINTS", "TARGET", "HITPOSE", "force", "torque", "WRENCH"};

constexpr std::string_view name_of(Reading reading) {
  return kReadingNames[static_cast<std::size_t>(reading)];
}

/// Whether it is read from the world, at the decision point of what was commanded before.
constexpr bool is_observation(Reading reading) {
  return reading != Reading::Target && reading != Reading::HitPose;
}

/// s since 1970, of 2000-01-01T00:00:00Z: where the virtual clock begins.
inline constexpr double kVirtualStart = 946684800;

/// Whether only a robot with a force sensor has it.
constexpr bool needs_sensor(Reading reading) { return reading >= Reading::Force; }

/// How many slots it takes on a robot of so many axes.
constexpr int slots_of(Reading reading, int axes) {
  switch (reading) {
    case Reading::Clock:
    case Reading::Unix:
      return 1;
    case Reading::Now:
      return 2;
    case Reading::Joints:
      return axes;
    case Reading::Force:
    case Reading::Torque:
      return 3;
    case Reading::Wrench:
      return 6;
    default:
      return 7;
  }
}

}  // namespace rob::lang
