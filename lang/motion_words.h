#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "lang/ascii.h"

/// The words of motions that syntax tree, code and Machine share.
namespace rob::lang {

/// Along what a motion runs.
enum class MotionKind : std::uint8_t {
  Joint,  ///< MOVE: every axis straight to its target, all arriving together
  Line    ///< MOVEL: the tool on a straight line
};

/// "MOVE", "MOVEL": as it is written.
constexpr std::string_view word_of(MotionKind kind) {
  return kind == MotionKind::Joint ? "MOVE" : "MOVEL";
}

/// PROFILE: how the speed of a motion from rest to rest rises and falls.
enum class Profile : std::uint8_t { Unspecified, Rectangular, Trapezoidal, Parabolic, Cosine };

inline constexpr std::array<std::string_view, 4> kProfileWords{"RECTANGULAR", "TRAPEZOIDAL",
                                                               "PARABOLIC", "COSINE"};

/// The profile of that name, in any case.
inline std::optional<Profile> find_profile(std::string_view word) {
  for (std::size_t i = 0; i < kProfileWords.size(); ++i) {
    if (same_word(kProfileWords[i], word)) return static_cast<Profile>(i + 1);
  }
  return std::nullopt;
}

/// What not every robot can do, so that each has to say whether it can.
enum class MotionFeature : std::uint8_t { Accel, Jerk, Profile, LookAhead, LivePace };

}  // namespace rob::lang
