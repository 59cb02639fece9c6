#include "lang/syntax/parser.h"

#include <array>
#include <utility>

#include <fmt/format.h>

#include "lang/syntax/parser_impl.h"
#include "lang/text/ascii.h"
#include "lang/text/codes.h"
#include "lang/text/source_text.h"
#include "lang/text/suggest.h"
#include "lang/values/units.h"

namespace rob::lang {

namespace {

/// Operators that are words: what a word behind a value may have been meant for.
constexpr std::array<std::string_view, 5> kOperatorWords{"AND", "OR", "XOR", "DIV", "MOD"};

}  // namespace

Program parse(std::string_view source, Diagnostics& diagnostics) {
  if (!check_source(source, diagnostics)) return {};
  const Outline outline = outline_of(source);
  return Parser(source, diagnostics, {.outline = &outline}).program();
}

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

Parser::Parser(std::string_view source, Diagnostics& diagnostics, SourceContext context)
    : source_(source),
      diagnostics_(diagnostics),
      lexer_(source, diagnostics, context.file, context.parts),
      outline_(*context.outline),
      imports_(std::move(context.imports)),
      nodes_(context.nodes),
      names_(context.names),
      file_(context.file),
      first_array_length_(context.array_lengths),
      types_(std::move(context.types)) {}

// program = { NL } { item } [ "END" { NL } ] .
Program Parser::program() {
  Program program;
  try {
    shift();
    shift();
    while (accept(TokenKind::EndOfLine)) {
    }
    while (!at(TokenKind::EndOfFile) && !at(Keyword::End)) {
      statement(program.statements);
      while (accept(TokenKind::EndOfLine)) {
      }
    }
    program.end = current_.place;
    // A file without END ends as if END stood on the line behind its last one.
    if (at(TokenKind::EndOfFile) && current_.place.column > 1) {
      program.end = Place{current_.place.line + 1, 1, 1, current_.place.file};
    }
    if (at(Keyword::End)) advance();
    while (accept(TokenKind::EndOfLine)) {
    }
    if (!at(TokenKind::EndOfFile)) {
      fail_here(code::kTextBehindEnd, "nothing may stand behind END",
                "END ends the whole program; blocks end with ENDIF, ENDWHILE, ENDFOR");
    }
  } catch (const SyntaxError&) {
    // Reported; what stands behind END is not read.
  } catch (const GiveUp&) {
    program.end = current_.place;
    program.whole = false;
  }
  program.header = std::move(header_);
  program.types = types_;
  program.array_lengths = std::move(array_lengths_);
  program.frame_uses = std::move(frame_uses_);
  program.taught = std::move(taught_);
  program.surroundings = surroundings_;
  program.routines = std::move(routines_);
  program.nodes = nodes_;
  if (program.end.file == 0 && program.statements.empty() && program.routines.empty() &&
      !diagnostics_.has_errors()) {
    diagnostics_.warning(code::kEmptyProgram, Place{0, 0, 1}, "the program has no statement");
  }
  return program;
}

Block parse_line(std::string_view source, std::size_t offset, const Place& place,
                 Diagnostics& diagnostics) {
  const Outline nothing;
  return Parser(source, diagnostics, {.file = place.file, .outline = &nothing})
      .line_at(offset, place);
}

Block Parser::line_at(std::size_t offset, const Place& place) {
  Block block;
  rereading_ = true;
  lexer_.begin_at(offset, place);
  shift();
  shift();
  statement(block);
  return block;
}

// --------------------------------------------------------------------- tokens

void Parser::shift() {
  if (diagnostics_.error_count() >= kMaxSyntaxErrors) throw GiveUp{};
  current_ = std::move(next_);
  next_ = lexer_.next();
}

void Parser::advance() {
  if (at(TokenKind::LeftParen) || at(TokenKind::LeftBracket)) ++brackets_;
  if (at(TokenKind::RightParen) || at(TokenKind::RightBracket)) brackets_ -= brackets_ > 0 ? 1 : 0;
  previous_ = current_;
  shift();
  while (brackets_ > 0 && at(TokenKind::EndOfLine) && !begins_statement(next_)) shift();
}

bool Parser::at(Keyword keyword) const {
  return at(TokenKind::Reserved) && current_.keyword == keyword;
}

bool Parser::at_word(std::string_view word) const {
  return at(TokenKind::Word) && same_word(current_.text, word);
}

bool Parser::accept(TokenKind kind) {
  if (!at(kind)) return false;
  advance();
  return true;
}

bool Parser::at_line_end() const { return at(TokenKind::EndOfLine) || at(TokenKind::EndOfFile); }

/// Inside brackets that were not closed: does a new statement stand here?
bool Parser::at_new_statement() const {
  if (!current_.first_on_line) return false;
  if (begins_statement(current_)) return true;
  return at(TokenKind::Word) && next_.kind != TokenKind::Comma &&
         next_.kind != TokenKind::RightParen && next_.kind != TokenKind::RightBracket &&
         next_.kind != TokenKind::EndOfLine;
}

bool Parser::line_ends_with(Keyword keyword) const {
  if (at_line_end()) return false;
  Lexer ahead = lexer_.quiet_copy();
  bool last = at(keyword);
  for (Token token = next_;
       token.kind != TokenKind::EndOfLine && token.kind != TokenKind::EndOfFile;
       token = ahead.next()) {
    last = token.kind == TokenKind::Reserved && token.keyword == keyword;
  }
  return last;
}

Place Parser::behind_previous() const {
  const Place& place = previous_.place;
  if (place.line == 0) return current_.place;
  return {place.line, place.column + place.length, 1, place.file};
}

// --------------------------------------------------------------------- errors

void Parser::report(std::string_view code, const Place& place, std::string message,
                    std::string help) {
  if (place.line == muted_line_) return;
  diagnostics_.error(code, place, std::move(message), std::move(help));
}

void Parser::fail(std::string_view code, const Place& place, std::string message,
                  std::string help) {
  const bool reported = at(TokenKind::Bad);
  if (!reported) report(code, place, std::move(message), std::move(help));
  throw SyntaxError{};
}

void Parser::fail_here(std::string_view code, std::string message, std::string help) {
  fail(code, current_.place, std::move(message), std::move(help));
}

/// Goes on behind the statement in which an error was met: at the end of its line or, where
/// brackets were open, of the line that closes them, but before a line that is a new statement.
void Parser::recover() {
  int open = std::exchange(brackets_, 0);
  while (!at(TokenKind::EndOfFile)) {
    if (open > 0 && at_new_statement()) return;
    if (at(TokenKind::EndOfLine) && (open <= 0 || begins_statement(next_))) return;
    if (at(TokenKind::LeftParen) || at(TokenKind::LeftBracket)) ++open;
    if (at(TokenKind::RightParen) || at(TokenKind::RightBracket)) --open;
    shift();
  }
}

/// The same within a header: goes on behind `keyword`, or at the end of the line.
void Parser::recover_until(Keyword keyword) {
  brackets_ = 0;
  while (!at_line_end() && !at(keyword)) shift();
  if (at(keyword)) advance();
}

/// What helps against frequent mistakes that show as an unexpected token.
std::string Parser::remedy() const {
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

}  // namespace rob::lang
