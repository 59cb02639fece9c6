#pragma once

#include <string>

#include <fmt/format.h>

namespace rob::lang {

/// A share as people write it: "201%" for 2.01, whose product with 100 is 200.99999999999997.
/// 15 digits are what every decimal of a double survives.
inline std::string percent_text(double share) { return fmt::format("{:.15g}%", share * 100); }

}  // namespace rob::lang
