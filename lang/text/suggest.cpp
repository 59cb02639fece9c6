#include "lang/text/suggest.h"

#include <algorithm>
#include <vector>

#include "lang/text/ascii.h"

namespace rob::lang {

namespace {

/// Words longer than this are no misspelt words of the language.
constexpr std::size_t kLongestWord = 64;

constexpr std::size_t kMostMistakes = 2;

}  // namespace

std::size_t edit_distance(std::string_view a, std::string_view b) {
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
      const bool same = to_upper(a[i - 1]) == to_upper(b[j - 1]);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (same ? 0U : 1U)});
      if (i > 1 && j > 1 && to_upper(a[i - 1]) == to_upper(b[j - 2]) &&
          to_upper(a[i - 2]) == to_upper(b[j - 1])) {
        row[j] = std::min(row[j], before_last[j - 2] + 1);
      }
    }
  }
  return row[b.size()];
}

std::vector<std::string_view> nearest(std::string_view word,
                                      std::span<const std::string_view> candidates) {
  if (word.size() > kLongestWord) return {};
  std::vector<std::string_view> best;
  std::size_t best_distance = kMostMistakes;
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

std::string_view suggest(std::string_view word, std::span<const std::string_view> candidates) {
  const std::vector<std::string_view> best = nearest(word, candidates);
  return best.empty() ? std::string_view{} : best.front();
}

std::string did_you_mean(std::string_view suggestion) {
  if (suggestion.empty()) return "";
  return "did you mean " + std::string(suggestion) + "?";
}

}  // namespace rob::lang
