#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rob::lang {

/// How many single mistakes lie between two words: a letter left out, added, replaced, or two
/// neighbours exchanged (Damerau 1964, restricted form). Capital letters count as small ones.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The candidates that were probably meant by a misspelt word, all equally near, in their order. At
/// most two mistakes, and fewer than half of the longer word's letters.
std::vector<std::string_view> nearest(std::string_view word,
                                      std::span<const std::string_view> candidates);

/// The first of them, or empty.
std::string_view suggest(std::string_view word, std::span<const std::string_view> candidates);

/// "did you mean MOVE?", or empty where `suggestion` is.
std::string did_you_mean(std::string_view suggestion);

}  // namespace rob::lang
