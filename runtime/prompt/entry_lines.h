#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace rob::runtime {

/// The lines of an entry that is being typed: of a block, or of brackets. To find out whether it is
/// complete it has to be compiled; this class tells which lines surely do not complete it, so that
/// the time that a long entry takes does not grow with the square of its length.
class EntryLines {
 public:
  void add(std::string_view line);
  void clear() { *this = {}; }
  bool empty() const { return text_.empty(); }
  std::size_t size() const { return lines_; }
  const std::string& text() const { return text_; }

  /// Whether brackets are open at the end of a text.
  static bool brackets_open(std::string_view text);
  /// Whether a line opens a block, or its next part, as ELSE does.
  static bool opens(std::string_view line);
  /// Whether a line ends a block, or a part of it.
  static bool ends_part(std::string_view line);
  bool brackets_open() const { return brackets_ > 0; }
  /// After the last line a bracket is open, or the block that it stands in surely is.
  bool surely_goes_on() const;
  /// It has been compiled, and a block is open.
  void note_open_block();

 private:
  std::string text_;
  std::size_t lines_ = 0;
  int brackets_ = 0;          ///< open
  int blocks_ = 0;            ///< open, if all lines are as they should be
  bool closes_ = false;       ///< the last line closes a block
  bool in_block_ = false;     ///< as the compiler has found
  std::size_t compiled_ = 0;  ///< lines that there were then
};

}  // namespace rob::runtime
