#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

/// Words that were probably meant by a misspelt one.
namespace rob {

/// How many single mistakes lie between two words: a letter left out, added, replaced, or two
/// neighbours exchanged (Damerau 1964, restricted form). Capital letters of ASCII count as small
/// ones.
inline std::size_t edit_distance(std::string_view a, std::string_view b) {
  const auto same = [](char x, char y) {
    const auto small = [](char c) { return c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c; };
    return small(x) == small(y);
  };
  // Three rows of the usual table: row i holds the distances of a's first i letters to all
  // beginnings of b.
  std::vector<std::size_t> before_last(b.size() + 1);
  std::vector<std::size_t> last(b.size() + 1);
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before_last.swap(last);
    last.swap(row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = last[j - 1] + (same(a[i - 1], b[j - 1]) ? 0U : 1U);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, replaced});
      const bool exchanged = i > 1 && j > 1 && same(a[i - 1], b[j - 2]) && same(a[i - 2], b[j - 1]);
      if (exchanged) row[j] = std::min(row[j], before_last[j - 2] + 1);
    }
  }
  return row[b.size()];
}

/// The candidates that were probably meant by `word`, all equally near, in their order. At most two
/// mistakes, and fewer than half of the longer word's letters.
inline std::vector<std::string_view> nearest(std::string_view word,
                                             std::span<const std::string_view> candidates) {
  constexpr std::size_t kLongestWord = 64;  // [choice] longer ones are no misspelt names
  if (word.size() > kLongestWord) return {};
  std::vector<std::string_view> best;
  std::size_t best_distance = 2;
  for (const std::string_view candidate : candidates) {
    const std::size_t distance = edit_distance(word, candidate);
    const std::size_t longer = std::max(word.size(), candidate.size());
    if (distance > best_distance || 2 * distance >= longer) continue;
    if (distance < best_distance) best.clear();
    best_distance = distance;
    best.push_back(candidate);
  }
  return best;
}

/// The first of them, or empty.
inline std::string_view suggest(std::string_view word,
                                std::span<const std::string_view> candidates) {
  const std::vector<std::string_view> best = nearest(word, candidates);
  return best.empty() ? std::string_view{} : best.front();
}

}  // namespace rob
