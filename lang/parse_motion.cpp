#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "lang/ascii.h"
#include "lang/codes.h"
#include "lang/parser_impl.h"
#include "lang/suggest.h"

/// The parser's rules for motions and their clauses.
namespace rob::lang {

namespace {

constexpr std::array<std::string_view, 7> kClauses{"AT",      "OVER", "ACCEL", "JERK",
                                                   "PROFILE", "ZONE", "FINE"};

/// Whether a value may go on with this sign: then the target is computed.
bool goes_on(TokenKind kind) {
  return kind == TokenKind::Plus || kind == TokenKind::Minus || kind == TokenKind::Star ||
         kind == TokenKind::Slash || kind == TokenKind::Caret || kind == TokenKind::Dot;
}

}  // namespace

std::string_view clause_word(const Token& token) {
  if (token.kind == TokenKind::Word) {
    for (const std::string_view word : kClauses) {
      if (same_word(word, token.text)) return word;
    }
  }
  if (token.kind != TokenKind::Reserved) return {};
  switch (token.keyword) {
    case Keyword::In:
    case Keyword::With:
    case Keyword::For:
    case Keyword::Until:
    case Keyword::Do:
      return spelling(token.keyword);
    default:
      return {};
  }
}

// motion = "MOVE" expr { clause } .
void Parser::move(Block& block) {
  const Place place = current_.place;
  advance();
  try {
    Move move;
    move.target = target();
    clauses(move);
    add(block, place, std::move(move));
  } catch (const SyntaxError&) {
    if (line_ends_with(Keyword::Do)) skip_later_block("MOVE", "ENDMOVE", false);
    throw;
  }
}

ExprPtr Parser::target() {
  const bool named = next_.kind != TokenKind::EndOfLine && next_.kind != TokenKind::Comma;
  if (named && (at_word("JOINT") || at_word("BY"))) {
    fail_not_yet(current_.place, fmt::format("MOVE {}", to_upper(current_.text)));
  }
  if (!at(TokenKind::LeftParen)) fail_target();
  const Place place = current_.place;
  ExprPtr target = tuple(place, elements("the target"));
  if (goes_on(current_.kind)) fail_not_yet(current_.place, "a computed target");
  return target;
}

/// `MOVE 140, 40, 0` and `MOVE` alone: shows how the target is written.
void Parser::fail_target() {
  if (at_line_end()) {
    fail(code::kTargetExpected, behind_previous(), "a target expected after MOVE",
         "MOVE(140, 40, 0)");
  }
  const Token first = current_;
  Lexer ahead = lexer_.quiet_copy();
  std::size_t end = first.offset + first.text.size();
  for (Token token = next_;
       token.kind != TokenKind::EndOfLine && token.kind != TokenKind::EndOfFile;
       token = ahead.next()) {
    if (!clause_word(token).empty() || token.kind == TokenKind::RightParen) break;
    end = token.offset + token.text.size();
  }
  constexpr std::size_t kMostShown = 60;
  const std::string_view written = source_.substr(first.offset, end - first.offset);
  const bool plain = written.size() <= kMostShown &&
                     std::ranges::all_of(written, [](char c) { return c >= ' ' && c <= '~'; });
  const bool list =
      plain && !at(TokenKind::LeftBracket) && written.find(',') != std::string_view::npos;
  const std::string help = list ? fmt::format("MOVE({})", written) : "MOVE(140, 40, 0)";
  fail(code::kTargetExpected, first.place,
       "a target is written in parentheses: '(' expected after MOVE", help);
}

// clause = "AT" expr | "OVER" expr .
void Parser::clauses(Move& move) {
  while (!at_line_end() && !at(Keyword::Else) && !at(Keyword::Until)) {
    if (at_word("AT")) {
      clause(move.at, "AT");
    } else if (at_word("OVER")) {
      clause(move.over, "OVER");
    } else {
      fail_clause();
    }
  }
}

void Parser::clause(ExprPtr& slot, std::string_view word) {
  if (slot) {
    report(code::kDuplicateClause, current_.place, fmt::format("{} is given twice", word),
           "keep one of the two");
  }
  advance();
  const bool live = at_word("LIVE") && !goes_on(next_.kind) && next_.kind != TokenKind::EndOfLine &&
                    clause_word(next_).empty();
  if (live) fail_not_yet(current_.place, fmt::format("{} LIVE", word));
  ExprPtr value = expression();
  if (!slot) slot = std::move(value);
}

void Parser::fail_clause() {
  const std::string_view known = clause_word(current_);
  if (!known.empty()) fail_not_yet(current_.place, fmt::format("{} behind a motion", known));
  const std::string meant = did_you_mean(suggest(current_.text, kClauses));
  if (!at(TokenKind::Word) || (meant.empty() && !remedy().empty())) end_of_line();
  fail_here(code::kUnknownClause, fmt::format("{} is no clause of a motion", described(current_)),
            meant);
}

}  // namespace rob::lang
