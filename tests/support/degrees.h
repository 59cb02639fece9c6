#pragma once

#include <numbers>

namespace rob::test {

inline constexpr double kDegree = std::numbers::pi / 180;  ///< rad

}  // namespace rob::test
