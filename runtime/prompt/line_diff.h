#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace rob::runtime {

/// A line of the changes that turn one text into another.
struct DiffLine {
  char sign;  ///< '-' only in the first, '+' only in the second, ' ' in both
  std::string_view text;
};

/// The shortest list of changes, found by the library dtl (Wu and others, "An O(NP) Sequence
/// Comparison Algorithm", 1990). Where lines are replaced, those that go stand before those that
/// come. The views are into `before` and `after`.
std::vector<DiffLine> line_diff(const std::vector<std::string>& before,
                                const std::vector<std::string>& after);

}  // namespace rob::runtime
