#pragma once

#include <array>
#include <string_view>

namespace rob::lang {

/// What may stand behind the target of a motion, beside reserved words.
inline constexpr std::array<std::string_view, 7> kMotionClauseWords{
    "AT", "OVER", "ACCEL", "JERK", "ZONE", "FINE", "PROFILE"};

}  // namespace rob::lang
