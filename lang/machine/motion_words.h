#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "base/motion_clauses.h"
#include "lang/text/ascii.h"

/// The words of motions that syntax tree, code and Machine share.
namespace rob::lang {

using rob::Profile;

/// Along what a motion runs.
enum class MotionKind : std::uint8_t {
  Joint,   ///< MOVE: every axis straight to its target, all arriving together
  Line,    ///< MOVEL: the tool on a straight line
  Arc,     ///< MOVEC: the tool on the arc of a circle through one point
  Spline,  ///< MOVES: the tool on a smooth curve exactly through any number of points
  Spiral,  ///< SPIRAL: the tool on an Archimedean spiral towards a centre
  Jog      ///< JOG: at given rates, without a target
};

inline constexpr std::array<std::string_view, 6> kMotionWords{"MOVE",  "MOVEL",  "MOVEC",
                                                              "MOVES", "SPIRAL", "JOG"};

/// "MOVE", "MOVEL": as it is written.
constexpr std::string_view word_of(MotionKind kind) {
  return kMotionWords[static_cast<std::size_t>(kind)];
}

/// The motion that the rates of a JOG describe.
enum class JogFrame : std::uint8_t {
  Joint,  ///< of the axes
  World,  ///< of the coordinates in the world: of the place and of the angles a, b, c
  Tool    ///< of the tool's motion, seen from the tool
};

inline constexpr std::array<std::string_view, 3> kJogWords{"JOINT", "WORLD", "TOOL"};

inline constexpr std::array<std::string_view, 4> kProfileWords{"RECTANGULAR", "TRAPEZOIDAL",
                                                               "PARABOLIC", "COSINE"};

/// The profile of that name, in any case.
inline std::optional<Profile> find_profile(std::string_view word) {
  for (std::size_t i = 0; i < kProfileWords.size(); ++i) {
    if (same_word(kProfileWords[i], word)) return static_cast<Profile>(i + 1);
  }
  return std::nullopt;
}

/// FREE: the turn through the tip that a motion leaves to the robot.
enum class FreeTurn : std::uint8_t {
  None,
  C,    ///< about z of the frame that the target is in
  Spin  ///< about the tool's own z
};

inline constexpr std::array<std::string_view, 2> kFreeWords{"c", "SPIN"};

/// The turn of that name, in any case.
inline std::optional<FreeTurn> find_free_turn(std::string_view word) {
  for (std::size_t i = 0; i < kFreeWords.size(); ++i) {
    if (same_word(kFreeWords[i], word)) return static_cast<FreeTurn>(i + 1);
  }
  return std::nullopt;
}

/// Abilities that not every robot has, so that each must say whether it has them.
enum class MotionFeature : std::uint8_t { Accel, Jerk, Path, Press, Lead, FreeC, FreeSpin };

/// LAW: how motions are joined.
enum class TransitionLaw : std::uint8_t { Paul, LookAhead };

}  // namespace rob::lang
