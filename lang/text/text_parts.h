#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace rob::lang {

/// Lines that were taken out of a longer text: from this byte on they count from this line on.
struct TextPart {
  std::size_t begin = 0;
  std::uint32_t line = 1;
};
/// In order; the first begins at byte 0. None: the text is whole, its lines count from 1.
using TextParts = std::span<const TextPart>;

/// Numbers the lines of a text while somebody goes through it.
class LineCount {
 public:
  explicit LineCount(TextParts parts = {}) : parts_(parts) { take_part(0); }

  /// From the middle of a text on.
  static LineCount at(std::uint32_t line) {
    LineCount count;
    count.line_ = line;
    return count;
  }

  std::uint32_t line() const { return line_; }
  /// The next line begins at this byte.
  void next(std::size_t begin) {
    ++line_;
    take_part(begin);
  }

 private:
  void take_part(std::size_t begin) {
    if (parts_.empty() || parts_.front().begin != begin) return;
    line_ = parts_.front().line;
    parts_ = parts_.subspan(1);
  }

  TextParts parts_;  ///< that come later
  std::uint32_t line_ = 1;
};

}  // namespace rob::lang
