#include "lang/syntax/token_reader.h"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "lang/syntax/syntax_limits.h"
#include "lang/text/codes.h"
#include "lang/text/suggest.h"
#include "lang/values/units.h"

namespace rob::lang {

namespace {

/// Operators that are words: what a word after a value may have been meant for.
constexpr std::array<std::string_view, 5> kOperatorWords{"AND", "OR", "XOR", "DIV", "MOD"};

}  // namespace

bool begins_statement(const Token& token) {
  if (token.kind == TokenKind::EndOfFile) return true;
  return token.kind == TokenKind::Reserved && role(token.keyword) != KeywordRole::Value;
}

std::string described(const Token& token) {
  if (token.kind == TokenKind::EndOfFile) return "the end of the file";
  if (token.kind == TokenKind::EndOfLine) return "the end of the line";
  if (token.kind == TokenKind::String) return "a text";
  return fmt::format("'{}'", shortened(token.text));
}

TokenReader::TokenReader(std::string_view source, Diagnostics& diagnostics, std::uint32_t file,
                         TextParts parts)
    : source_(source), diagnostics_(diagnostics), lexer_(source, diagnostics, file, parts) {}

// --------------------------------------------------------------------- tokens

void TokenReader::begin() {
  shift();
  shift();
}

void TokenReader::begin_at(std::size_t offset, const Place& place) {
  lexer_.begin_at(offset, place);
  begin();
}

void TokenReader::shift() {
  if (diagnostics_.error_count() >= kMaxSyntaxErrors) throw GiveUp{};
  current_ = std::move(next_);
  next_ = lexer_.next();
}

void TokenReader::advance() {
  if (at(TokenKind::LeftParen) || at(TokenKind::LeftBracket)) ++brackets_;
  if (at(TokenKind::RightParen) || at(TokenKind::RightBracket)) brackets_ -= brackets_ > 0 ? 1 : 0;
  previous_ = current_;
  shift();
  while (brackets_ > 0 && at(TokenKind::EndOfLine) && !begins_statement(next_)) shift();
}

bool TokenReader::accept(TokenKind kind) {
  if (!at(kind)) return false;
  advance();
  return true;
}

// eol = NL { NL } .
void TokenReader::end_of_line() {
  if (at_line_end()) return;
  fail_here(code::kLineEndExpected,
            fmt::format("the end of the line expected, not {}", described(current_)), remedy());
}

void TokenReader::skip_line_ends() {
  while (accept(TokenKind::EndOfLine)) {
  }
}

void TokenReader::skip_to(std::size_t offset) {
  previous_ = current_;
  lexer_.skip_to(offset);
  begin();
}

void TokenReader::take_for(Keyword keyword) {
  current_.kind = TokenKind::Reserved;
  current_.keyword = keyword;
}

/// Inside brackets that were not closed: does a new statement stand here?
bool TokenReader::at_new_statement() const {
  if (!current_.first_on_line) return false;
  if (begins_statement(current_)) return true;
  return at(TokenKind::Word) && next_.kind != TokenKind::Comma &&
         next_.kind != TokenKind::RightParen && next_.kind != TokenKind::RightBracket &&
         next_.kind != TokenKind::EndOfLine;
}

bool TokenReader::line_ends_with(Keyword keyword) const {
  if (at_line_end()) return false;
  Lexer lexer = ahead();
  bool last = at(keyword);
  for (Token token = next_;
       token.kind != TokenKind::EndOfLine && token.kind != TokenKind::EndOfFile;
       token = lexer.next()) {
    last = token.kind == TokenKind::Reserved && token.keyword == keyword;
  }
  return last;
}

Place TokenReader::behind_previous() const {
  const Place& place = previous_.place;
  if (place.line == 0) return current_.place;
  return {place.line, place.column + place.length, 1, place.file};
}

Lexer TokenReader::from_beginning() const { return Lexer(source_, diagnostics_).quiet_copy(); }

// --------------------------------------------------------------------- errors

void TokenReader::report(std::string_view code, const Place& place, std::string message,
                         std::string help) {
  const bool misnamed = at(TokenKind::Reserved) && place == current_.place &&
                        std::ranges::find(misnamed_, current_.keyword) != misnamed_.end();
  if (place.line == muted_line_ || misnamed) return;
  diagnostics_.error(code, place, std::move(message), std::move(help));
}

void TokenReader::fail(std::string_view code, const Place& place, std::string message,
                       std::string help) {
  const bool reported = at(TokenKind::Bad);
  if (!reported) report(code, place, std::move(message), std::move(help));
  throw SyntaxError{};
}

void TokenReader::fail_here(std::string_view code, std::string message, std::string help) {
  fail(code, current_.place, std::move(message), std::move(help));
}

void TokenReader::fail_behind(std::string_view code, std::string message, std::string help) {
  fail(code, behind_previous(), std::move(message), std::move(help));
}

void TokenReader::fail_reserved() {
  fail_here(code::kReservedName,
            fmt::format("{} is a reserved word and cannot be a name", described(current_)),
            "choose another name");
}

bool TokenReader::has_error_between(const Place& first, const Place& last) const {
  return diagnostics_.has_error_between(first, last);
}

/// Help against frequent mistakes that show as an unexpected token.
std::string TokenReader::remedy() const {
  const bool behind_number = previous_.kind == TokenKind::Number && !previous_.has_unit;
  const bool value_follows = next_.kind == TokenKind::Number || next_.kind == TokenKind::Word ||
                             next_.kind == TokenKind::LeftParen;
  if (at(TokenKind::Percent) && value_follows) return "the remainder is written x MOD y";
  const auto unit = match_unit(source_.substr(current_.offset));
  if (behind_number && unit) {
    return fmt::format("a unit follows its number without a blank: {}{}", shortened(previous_.text),
                       source_.substr(current_.offset, unit->length));
  }
  if (behind_number && at(TokenKind::Comma) && next_.kind == TokenKind::Number) {
    return fmt::format("the decimal sign is a point: {}.{}", shortened(previous_.text),
                       shortened(next_.text));
  }
  if (at(TokenKind::RightParen) || at(TokenKind::RightBracket)) return "no bracket is open here";
  if (at(TokenKind::Word)) return did_you_mean(suggest(current_.text, kOperatorWords));
  return "";
}

// ------------------------------------------------------------------- recovery

/// Goes on after the statement in which an error was met: at the end of its line or, where
/// brackets were open, of the line that closes them, but before a line that is a new statement.
void TokenReader::recover() {
  int open = std::exchange(brackets_, 0);
  while (!at(TokenKind::EndOfFile)) {
    if (open > 0 && at_new_statement()) return;
    if (at(TokenKind::EndOfLine) && (open <= 0 || begins_statement(next_))) return;
    if (at(TokenKind::LeftParen) || at(TokenKind::LeftBracket)) ++open;
    if (at(TokenKind::RightParen) || at(TokenKind::RightBracket)) --open;
    shift();
  }
}

/// The same within a header: goes on after `keyword`, or at the end of the line.
void TokenReader::recover_until(Keyword keyword) {
  brackets_ = 0;
  while (!at_line_end() && !at(keyword)) shift();
  if (at(keyword)) advance();
}

/// The rest of a header that could not be read.
void TokenReader::skip_line() {
  brackets_ = 0;
  while (!at_line_end()) shift();
}

void TokenReader::skip_over(std::size_t end) {
  brackets_ = 0;
  lexer_.mute(true);
  while (!at(TokenKind::EndOfFile) && (current_.offset < end || !at(TokenKind::EndOfLine))) shift();
  lexer_.mute(false);
}

/// Skips the rest of the line, which opens a block, and all lines to the one that closes it.
/// Blocks of the same kind inside it, which a line that ends in DO opens, are counted.
void TokenReader::skip_block(std::string_view opener, std::string_view closer) {
  brackets_ = 0;
  int open = 1;
  skip_line_of_block();
  while (open > 0 && !at(TokenKind::EndOfFile)) {
    skip_line_ends();
    const bool opens = same_word(current_.text, opener);
    const bool closes = same_word(current_.text, closer);
    const bool ends_in_do = skip_line_of_block();
    if (opens && ends_in_do) ++open;
    if (closes) --open;
  }
}

/// To the end of the line; whether its last word is DO.
bool TokenReader::skip_line_of_block() {
  bool last = false;
  while (!at_line_end()) {
    last = at(Keyword::Do);
    shift();
  }
  return last;
}

}  // namespace rob::lang
