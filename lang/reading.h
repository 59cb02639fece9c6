#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace rob::lang {

/// What a program reads of the robot by a name of the language, and how many slots it takes.
enum class Reading : std::uint8_t {
  Clock,   ///< CLOCK: s since the start of the program
  Here,    ///< HERE: the tool in the world, x y z (m) and w i j k; what the axes are told to be
  Joints,  ///< JOINTS(): the same as one value an axis, m or rad
  Target   ///< TARGET: the tool at the last target commanded; known without looking
};

inline constexpr std::array<std::string_view, 4> kReadingNames{"CLOCK", "HERE", "JOINTS", "TARGET"};

constexpr std::string_view name_of(Reading reading) {
  return kReadingNames[static_cast<std::size_t>(reading)];
}

/// Whether it is read from the world, at the decision point of what was commanded before.
constexpr bool is_observation(Reading reading) { return reading != Reading::Target; }

}  // namespace rob::lang
