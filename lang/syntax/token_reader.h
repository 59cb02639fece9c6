#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "lang/syntax/lexer.h"
#include "lang/syntax/token.h"
#include "lang/text/ascii.h"
#include "lang/text/diagnostic.h"
#include "lang/text/text_parts.h"

namespace rob::lang {

/// Thrown where a rule cannot go on, once the mistake is reported. The loop over the statements
/// catches it and goes on after the statement; rules whose block must be read all the same catch it
/// earlier.
struct SyntaxError {};
/// Thrown where a text is hopeless: the rest of it is not read.
struct GiveUp {};

/// Whether a line can go on with this token inside brackets: a reserved word that is neither
/// operator nor value ends the statement, so that a bracket left open costs one line.
bool begins_statement(const Token& token);

/// A token for messages: 'MOVE', "the end of the line".
std::string described(const Token& token);

/// The tokens of a text, for the rules of the grammar: the one that a rule stands at, the one
/// before and the one after. Inside brackets line ends do not count. Reports what is wrong with
/// them, and finds the way on.
class TokenReader {
 public:
  /// For places: `file` is the number of the file that the text is of, `parts` its lines.
  TokenReader(std::string_view source, Diagnostics& diagnostics, std::uint32_t file,
              TextParts parts);

  /// Reads the first tokens.
  void begin();
  /// The same in the middle of the text, where a token begins.
  void begin_at(std::size_t offset, const Place& place);

  const Token& previous() const { return previous_; }
  const Token& current() const { return current_; }
  const Token& next() const { return next_; }
  /// The place of the current token.
  const Place& place() const { return current_.place; }
  std::string_view text() const { return current_.text; }
  bool at(TokenKind kind) const { return current_.kind == kind; }
  bool at(Keyword keyword) const {
    return current_.kind == TokenKind::Reserved && current_.keyword == keyword;
  }
  bool at_word(std::string_view word) const {
    return current_.kind == TokenKind::Word && same_word(current_.text, word);
  }
  bool next_is(Keyword keyword) const {
    return next_.kind == TokenKind::Reserved && next_.keyword == keyword;
  }
  bool at_line_end() const { return at(TokenKind::EndOfLine) || at(TokenKind::EndOfFile); }
  bool at_new_statement() const;
  bool line_ends_with(Keyword keyword) const;
  /// The place directly after the previous token.
  Place behind_previous() const;

  /// All of the text.
  std::string_view source() const { return source_; }
  /// Reads what comes after next(), and reports nothing.
  Lexer ahead() const { return lexer_.quiet_copy(); }
  /// Reads the text from its beginning, and reports nothing.
  Lexer from_beginning() const;
  bool only_blanks_ahead() const { return lexer_.only_blanks_left(); }

  void advance();
  bool accept(TokenKind kind);
  void end_of_line();
  void skip_line_ends();
  /// Goes on from here in the text: what stands before it has been read otherwise.
  void skip_to(std::size_t offset);
  /// Takes the current token for another, once a mistake is reported.
  void take_for(TokenKind kind) { current_.kind = kind; }
  void take_for(Keyword keyword);

  void report(std::string_view code, const Place& place, std::string message,
              std::string help = "");
  [[noreturn]] void fail(std::string_view code, const Place& place, std::string message,
                         std::string help = "");
  /// The same about the current token.
  [[noreturn]] void fail_here(std::string_view code, std::string message, std::string help = "");
  /// The same about the place directly after the previous token.
  [[noreturn]] void fail_behind(std::string_view code, std::string message, std::string help = "");
  /// A reserved word stands where a name should.
  [[noreturn]] void fail_reserved();
  /// The reserved word here was meant for a name, if it is one: where it stands again as one,
  /// nothing is reported.
  void misname() {
    if (at(TokenKind::Reserved)) misnamed_.push_back(current_.keyword);
  }
  /// Nothing more is reported about the current line.
  void mute_line() { muted_line_ = current_.place.line; }
  bool line_muted() const { return current_.place.line == muted_line_; }
  bool has_error_between(const Place& first, const Place& last) const;
  std::string remedy() const;

  void recover();
  void recover_until(Keyword keyword);
  void skip_line();
  /// To the end of the line that the byte `end` lies on. Nothing there is looked at.
  void skip_over(std::size_t end);
  void skip_block(std::string_view opener, std::string_view closer);

 private:
  void shift();
  bool skip_line_of_block();

  std::string_view source_;
  Diagnostics& diagnostics_;
  Lexer lexer_;
  Token previous_;
  Token current_;
  Token next_;
  std::vector<Keyword> misnamed_;  ///< reserved words that stood where a parameter's name should
  int brackets_ = 0;               ///< that are open
  std::uint32_t muted_line_ = 0;   ///< has had its message
};

}  // namespace rob::lang
