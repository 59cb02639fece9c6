#pragma once

#include <array>
#include <string_view>

namespace rob::lang {

/// Words that may stand after the target of a motion, beside reserved words.
inline constexpr std::array<std::string_view, 8> kMotionClauseWords{
    "AT", "OVER", "ACCEL", "JERK", "ZONE", "FINE", "PROFILE", "EULER"};

/// The same, known by what stands after them: elsewhere they are names.
inline constexpr std::array<std::string_view, 2> kChoiceWords{"NEAR", "FREE"};

/// Words that begin a statement by their place at the beginning of a line. They are not reserved.
inline constexpr std::array<std::string_view, 13> kPlacedWords{
    "DEFAULT", "ENUM",  "FRAME", "LAW",  "LOAD",  "OVERRIDE", "PATH",
    "PRESS",   "ROBOT", "START", "TOOL", "UNITS", "ZERO"};

/// The same of what outlives a run: names before any sign that makes something of a name.
inline constexpr auto kFileWords = std::to_array<std::string_view>({
    "DEVICE",
    "PERSIST",
    "READ",
    "RECEIVE",
    "SEND",
    "WRITE",
});

/// The same before a name alone, and the end of the block of one.
inline constexpr std::array<std::string_view, 3> kNamingWords{"ALLOW", "ENDALLOW", "OBSTACLE"};

}  // namespace rob::lang
