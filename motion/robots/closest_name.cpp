#include "motion/robots/closest_name.h"

#include <algorithm>
#include <cstddef>

namespace rob::motion {

namespace {

/// Damerau-Levenshtein distance (optimal string alignment): rows are prefixes of a.
std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before_last(b.size() + 1);
  std::vector<std::size_t> last(b.size() + 1);
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t changed = a[i - 1] == b[j - 1] ? 0 : 1;
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + changed});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        row[j] = std::min(row[j], before_last[j - 2] + 1);
    }
    std::swap(before_last, last);
    std::swap(last, row);
  }
  return last[b.size()];
}

}  // namespace

std::string_view closest_name(std::string_view word,
                              const std::vector<std::string_view>& candidates) {
  // Longer than any name of ours: nobody's slip, and not worth the square of its length.
  constexpr std::size_t kLongest = 64;
  std::string_view best;
  std::size_t least = std::min<std::size_t>(3, (word.size() + 1) / 2);
  if (word.size() > kLongest) return best;
  for (const std::string_view candidate : candidates) {
    const std::size_t d = distance(word, candidate);
    if (d >= least) continue;
    least = d;
    best = candidate;
  }
  return best;
}

}  // namespace rob::motion
