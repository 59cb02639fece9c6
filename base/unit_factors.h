#pragma once

#include <numbers>

namespace rob {

inline constexpr double kMillimetre = 1e-3;                ///< m
inline constexpr double kDegree = std::numbers::pi / 180;  ///< rad
inline constexpr double kFullTurn = 2 * std::numbers::pi;  ///< rad

}  // namespace rob
