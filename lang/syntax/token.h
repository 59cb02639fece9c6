#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "lang/syntax/ast.h"
#include "lang/syntax/keywords.h"

namespace rob::lang {

enum class TokenKind : std::uint8_t {
  EndOfFile,
  EndOfLine,  ///< one for any number of empty lines
  Bad,        ///< could not be read, and has been reported
  Word,       ///< a name, or a word that is not reserved
  Reserved,
  Number,  ///< without or with a unit
  String,
  LeftParen,
  RightParen,
  LeftBracket,
  RightBracket,
  Comma,
  Colon,
  Dot,
  Range,  ///< ..
  Assign,
  PlusAssign,
  MinusAssign,
  StarAssign,
  SlashAssign,
  Equal,
  NotEqual,
  Less,
  LessEqual,
  Greater,
  GreaterEqual,
  Plus,
  Minus,
  Star,
  Slash,
  Caret,
  Percent  ///< alone; after a number it is part of the quantity
};

/// One word or sign of a program. `text` points into the source.
struct Token {
  TokenKind kind = TokenKind::EndOfFile;
  Keyword keyword{};           ///< of Reserved only
  bool first_on_line = false;  ///< nothing but blanks stands before it
  bool has_unit = false;       ///< of Number only
  Place place;
  std::size_t offset = 0;  ///< in bytes, of its beginning
  std::string_view text;
  NumberLiteral number;  ///< of Number only
  std::string string;    ///< of String only: what the quotes hold, escapes resolved
};

}  // namespace rob::lang
