#include "runtime/prompt/line_diff.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace rob::runtime {

namespace {

using Lines = std::vector<std::string>;

/// [choice] 100 MB: 5000 lines that have all changed.
constexpr std::size_t kMostPairs = 25'000'000;

/// Lengths of the longest common subsequences of all pairs of ends of two texts' middles.
class CommonEnds {
 public:
  CommonEnds(const Lines& before, const Lines& after, std::size_t first, std::size_t rows,
             std::size_t columns)
      : columns_(columns + 1), lengths_((rows + 1) * columns_) {
    for (std::size_t i = rows; i-- > 0;) {
      for (std::size_t j = columns; j-- > 0;) {
        lengths_[i * columns_ + j] = before[first + i] == after[first + j]
                                         ? at(i + 1, j + 1) + 1
                                         : std::max(at(i + 1, j), at(i, j + 1));
      }
    }
  }
  std::uint32_t at(std::size_t i, std::size_t j) const { return lengths_[i * columns_ + j]; }

 private:
  std::size_t columns_;
  std::vector<std::uint32_t> lengths_;
};

std::vector<DiffLine> replaced(const Lines& before, const Lines& after) {
  std::vector<DiffLine> diff;
  for (const std::string& line : before) diff.push_back({'-', line});
  for (const std::string& line : after) diff.push_back({'+', line});
  return diff;
}

}  // namespace

std::vector<DiffLine> line_diff(const Lines& before, const Lines& after) {
  const std::size_t most = std::min(before.size(), after.size());
  std::size_t head = 0;
  while (head < most && before[head] == after[head]) ++head;
  std::size_t tail = 0;
  while (tail < most - head && before[before.size() - 1 - tail] == after[after.size() - 1 - tail])
    ++tail;
  const std::size_t rows = before.size() - head - tail;
  const std::size_t columns = after.size() - head - tail;
  if (columns != 0 && rows > kMostPairs / columns) return replaced(before, after);
  const CommonEnds common(before, after, head, rows, columns);
  std::vector<DiffLine> diff;
  for (std::size_t i = 0; i < head; ++i) diff.push_back({' ', before[i]});
  std::size_t i = 0;
  std::size_t j = 0;
  while (i < rows || j < columns) {
    if (i < rows && j < columns && before[head + i] == after[head + j]) {
      diff.push_back({' ', before[head + i]});
      ++i, ++j;
    } else if (j == columns || (i < rows && common.at(i + 1, j) >= common.at(i, j + 1))) {
      diff.push_back({'-', before[head + i++]});
    } else {
      diff.push_back({'+', after[head + j++]});
    }
  }
  for (std::size_t k = 0; k < tail; ++k) diff.push_back({' ', before[head + rows + k]});
  return diff;
}

}  // namespace rob::runtime
