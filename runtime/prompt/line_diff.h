#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace rob::runtime {

/// What has to be done to make one text of another.
struct DiffLine {
  char sign;  ///< '-' only in the first, '+' only in the second, ' ' in both
  std::string_view text;
};

/// By a longest common subsequence of lines; where there are several, what goes stands before what
/// comes. Time and memory grow with the product of the lines that differ: what is the same at both
/// ends costs nothing; beyond 25 million pairs all lines are told as replaced. The views are into
/// `before` and `after`.
std::vector<DiffLine> line_diff(const std::vector<std::string>& before,
                                const std::vector<std::string>& after);

}  // namespace rob::runtime
