#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "lang/syntax/token.h"
#include "lang/text/diagnostic.h"
#include "lang/text/text_parts.h"

namespace rob::lang {

/// Help for an INT that is too large.
inline constexpr const char* kLargestInt =
    "an INT goes up to 9223372036854775807; with .0 after it, it is a REAL";

/// Cuts a source text into tokens, one at a call. Blanks and comments are skipped.
///
/// Text that cannot be read is reported and returned as a Bad token; an operator of another
/// language whose meaning is plain (`!=`, `&&`, `:=`) is reported and returned as Rob's. The text
/// must have passed check_source() and outlive the lexer. A lexer may be copied to look ahead.
class Lexer {
 public:
  /// For places: `file` is the number of the file that the text is of, `parts` its lines.
  Lexer(std::string_view source, Diagnostics& diagnostics, std::uint32_t file = 0,
        TextParts parts = {});

  /// EndOfFile again and again when all is read; an EndOfLine comes before it
  /// unless there is nothing at all.
  Token next();

  /// Goes on at a place of the text where a token begins.
  void begin_at(std::size_t offset, const Place& place);
  /// Goes on after what has been read otherwise, on the line of the last token.
  void skip_to(std::size_t offset);

  /// Whether nothing is reported from here on.
  void mute(bool muted) { muted_ = muted; }
  /// A copy that goes on from here and reports nothing.
  Lexer quiet_copy() const;

  /// True if only blanks, comments and line ends follow.
  bool only_blanks_left() const;

 private:
  void skip_blanks();
  void skip_foreign_comment();
  bool skip_line_ends();
  Token read();
  Token word();
  Token number();
  Token string();
  Token sign();
  Token unknown_sign();

  void scan_digits();
  void scan_number();
  Token hexadecimal();
  Token plain_number(std::string_view digits, bool whole);
  Token quantity(std::string_view digits);
  Token unknown_unit(std::string_view digits);
  Token stray_point(std::string_view digits, bool whole);
  Token too_large(std::string help);
  bool escape(std::string& text);
  bool unicode_escape(std::string& text);

  char at(std::size_t ahead = 0) const;
  void skip_word();
  Token finish(TokenKind kind);
  Token bad(std::string_view code, std::string message, std::string help = "");
  void report(std::string_view code, std::size_t begin, std::string message, std::string help);
  void begin_token();
  Place place(std::size_t begin, std::size_t end) const;

  std::string_view source_;
  Diagnostics* diagnostics_;  ///< null: nothing is reported
  bool muted_ = false;
  std::size_t offset_ = 0;
  std::size_t begin_ = 0;  ///< of the token that is being read
  LineCount count_;
  std::uint32_t file_ = 0;
  std::uint32_t begin_column_ = 1;  ///< column of begin_, counted on from token to token
  bool at_line_begin_ = true;
};

}  // namespace rob::lang
