#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "lang/syntax/lexer.h"
#include "lang/syntax/token.h"
#include "lang/text/diagnostic.h"

namespace rob::lang {

/// One line of a source text: its tokens without EndOfLine, and the comment after them.
struct SourceLine {
  std::vector<Token> tokens;
  std::string_view comment;          ///< from its // on, without trailing blanks; empty if none
  std::uint32_t comment_column = 0;  ///< in characters, from 1

  bool empty() const { return tokens.empty() && comment.empty(); }
};

/// Reads a text line by line, comments included, which the Lexer alone would skip. Text that the
/// lexer cannot read goes to `diagnostics`. The text must have passed check_source() and outlive
/// this.
class SourceLines {
 public:
  SourceLines(std::string_view source, Diagnostics& diagnostics);

  /// False when all is read. `line` may be used again, which saves its memory.
  bool next(SourceLine& line);

 private:
  void find_comment(SourceLine& line, std::size_t end) const;

  std::string_view source_;
  Lexer lexer_;
  Token pending_;
  std::size_t begin_ = 0;  ///< of the line that comes next, in bytes
  std::uint32_t number_ = 0;
};

}  // namespace rob::lang
