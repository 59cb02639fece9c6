#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <utility>

#include "lang/syntax/lexer.h"
#include "lang/text/ascii.h"

namespace rob::runtime {

/// The common part of the readers of the small files beside a program: points, signal scripts. The
/// files are made of the language's tokens, a statement a line. A line that cannot be read is
/// reported with its place, and reading goes on after it, so that all errors of a file are found.
class LineReader {
 protected:
  /// Thrown by fail(): the rest of the line is skipped.
  struct Wrong {};

  /// `code` and `help` are those of a line that does not look as it should.
  LineReader(std::string_view text, lang::Diagnostics& diagnostics, const char* code,
             std::string help)
      : diagnostics_(diagnostics), lexer_(text, diagnostics), code_(code), help_(std::move(help)) {}

  /// Calls `line` for each line that is not empty, until it returns false.
  template <typename Line>
  void read_lines(Line line) {
    advance();
    for (bool further = true; further && token_.kind != lang::TokenKind::EndOfFile;) {
      if (token_.kind == lang::TokenKind::EndOfLine) {
        advance();
        continue;
      }
      try {
        further = line();
      } catch (const Wrong&) {
        while (!at_line_end()) advance();
      }
    }
  }

  void advance() { token_ = lexer_.next(); }
  bool at_line_end() const {
    return token_.kind == lang::TokenKind::EndOfLine || token_.kind == lang::TokenKind::EndOfFile;
  }
  bool at_word(std::string_view word) const {
    const bool is_word =
        token_.kind == lang::TokenKind::Word || token_.kind == lang::TokenKind::Reserved;
    return is_word && lang::same_word(token_.text, word);
  }
  void take(lang::TokenKind kind, std::string_view what) {
    if (token_.kind != kind) expected(what);
    advance();
  }
  void take_word(std::string_view word) {
    if (!at_word(word)) expected(word);
    advance();
  }
  std::string take_text(std::string_view what) {
    std::string text = token_.string;
    take(lang::TokenKind::String, what);
    return text;
  }
  void end_of_line() {
    if (!at_line_end()) expected("the end of the line");
  }

  [[noreturn]] void fail(const char* code, const lang::Place& place, std::string message,
                         std::string help = "") {
    // A token that could not be read has had its message.
    if (token_.kind != lang::TokenKind::Bad) {
      diagnostics_.error(code, place, std::move(message), std::move(help));
    }
    throw Wrong{};
  }
  [[noreturn]] void expected(std::string_view what) {
    fail(code_, token_.place, fmt::format("{} expected, not {}", what, shown()), help_);
  }
  /// The current token, for messages.
  std::string shown() const {
    if (at_line_end()) return "the end of the line";
    return fmt::format("'{}'", lang::shortened(token_.text));
  }

  lang::Token token_;

 private:
  lang::Diagnostics& diagnostics_;
  lang::Lexer lexer_;
  const char* code_;
  std::string help_;
};

}  // namespace rob::runtime
