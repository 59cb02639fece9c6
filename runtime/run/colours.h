#pragma once

#include <string>
#include <string_view>

namespace rob::runtime {

enum class Colour : unsigned char { Red, Green, Yellow };

/// With the codes around it that a terminal understands (ECMA-48, SGR). `before` and `after`
/// enclose each code.
std::string in_colour(std::string_view text, Colour colour, std::string_view before = "",
                      std::string_view after = "");

/// Lines of messages: "error[E401]:" and "fault[F012]:" in red, "warning[W003]:" in yellow, where
/// they begin a line or stand after its place, "job.rob:3:5: ".
std::string coloured(std::string_view lines);

}  // namespace rob::runtime
