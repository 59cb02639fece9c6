#pragma once

#include <string_view>
#include <vector>

namespace rob::motion {

/// The candidate that `word` is most likely a slip of: at most two letters wrong, missing, too many
/// or swapped, and fewer than half of the word. Empty if there is none; of equals the first.
std::string_view closest_name(std::string_view word,
                              const std::vector<std::string_view>& candidates);

}  // namespace rob::motion
