#pragma once

#include <array>
#include <string_view>

namespace rob::lang {

/// What may stand behind the target of a motion, beside reserved words.
inline constexpr std::array<std::string_view, 8> kMotionClauseWords{
    "AT", "OVER", "ACCEL", "JERK", "ZONE", "FINE", "PROFILE", "EULER"};

}  // namespace rob::lang
