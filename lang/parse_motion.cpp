#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "lang/ascii.h"
#include "lang/codes.h"
#include "lang/parser_impl.h"
#include "lang/suggest.h"

/// The parser's rules for motions and their clauses.
namespace rob::lang {

namespace {

/// By Clause.
constexpr std::array<std::string_view, kClauses> kValuedClauses{"AT", "OVER", "ACCEL", "JERK",
                                                                "ZONE"};
constexpr std::array<std::string_view, 7> kClauseWords{"AT",   "OVER", "ACCEL",  "JERK",
                                                       "ZONE", "FINE", "PROFILE"};

/// Whether a value may go on with this sign: then the target is computed.
bool goes_on(const Token& token) {
  if (token.kind == TokenKind::Reserved) {
    return token.keyword == Keyword::And || token.keyword == Keyword::Or ||
           token.keyword == Keyword::Xor || token.keyword == Keyword::Div ||
           token.keyword == Keyword::Mod;
  }
  const bool compares = token.kind >= TokenKind::Equal && token.kind <= TokenKind::GreaterEqual;
  return compares || token.kind == TokenKind::Plus || token.kind == TokenKind::Minus ||
         token.kind == TokenKind::Star || token.kind == TokenKind::Slash ||
         token.kind == TokenKind::Caret || token.kind == TokenKind::Dot ||
         token.kind == TokenKind::LeftBracket;
}

}  // namespace

std::string_view clause_word(const Token& token) {
  if (token.kind == TokenKind::Word) {
    for (const std::string_view word : kClauseWords) {
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

// motion = ( "MOVE" | "MOVEL" ) ( expr | "BY" expr ) { clause }
//        | "MOVE" "JOINT" expr ( "TO" | "BY" ) expr { clause } .
void Parser::move(Block& block) {
  const Place place = current_.place;
  Move move;
  move.kind = at(Keyword::Movel) ? MotionKind::Line : MotionKind::Joint;
  advance();
  try {
    if (move.kind == MotionKind::Joint && at_clause_word("JOINT")) {
      joint_target(move);
    } else {
      move.by = at_clause_word("BY");
      if (move.by) advance();
      move.target = target(word_of(move.kind));
    }
    clauses(move.clauses);
    add(block, place, std::move(move));
  } catch (const SyntaxError&) {
    if (line_ends_with(Keyword::Do)) skip_later_block("MOVE", "ENDMOVE", false);
    throw;
  }
}

/// A word behind MOVE that is not the name of what stands there.
bool Parser::at_clause_word(std::string_view word) const {
  const bool value = goes_on(next_) && next_.kind != TokenKind::Minus;
  return at_word(word) && !value && next_.kind != TokenKind::EndOfLine &&
         next_.kind != TokenKind::Comma;
}

void Parser::joint_target(Move& move) {
  advance();
  move.axis = expression();
  move.by = at_word("BY");
  if (!move.by && !at_word("TO")) {
    fail(code::kWordExpected, behind_previous(), "TO or BY expected after the axis of MOVE JOINT",
         "MOVE JOINT 3 TO 90deg");
  }
  advance();
  move.target = expression();
}

// target = "(" element { "," element } ")" | expr .
ExprPtr Parser::target(std::string_view motion) {
  if (at(TokenKind::LeftParen) && !group_goes_on()) {
    const Place place = current_.place;
    return tuple(place, elements("the target"));
  }
  if (!at(TokenKind::LeftParen) && (!at_value() || at_list())) fail_target(motion);
  return expression();
}

/// A token that an expression may begin with, and no clause.
bool Parser::at_value() const {
  if (at(TokenKind::Word)) return clause_word(current_).empty();
  if (at(TokenKind::Reserved)) return role(current_.keyword) == KeywordRole::Value;
  return at(TokenKind::Number) || at(TokenKind::String) || at(TokenKind::Plus) ||
         at(TokenKind::Minus) || at(TokenKind::LeftBracket);
}

/// `140, 40, 0` without its parentheses.
bool Parser::at_list() const {
  Lexer ahead = lexer_.quiet_copy();
  int open = 0;
  for (Token token = next_;
       token.kind != TokenKind::EndOfLine && token.kind != TokenKind::EndOfFile;
       token = ahead.next()) {
    if (token.kind == TokenKind::LeftParen || token.kind == TokenKind::LeftBracket) ++open;
    if (token.kind == TokenKind::RightParen || token.kind == TokenKind::RightBracket) --open;
    if (open == 0 && (begins_statement(token) || !clause_word(token).empty())) return false;
    if (open == 0 && token.kind == TokenKind::Comma) return true;
  }
  return false;
}

/// Whether the parentheses that begin here are only the beginning of a computed target.
bool Parser::group_goes_on() const {
  Lexer ahead = lexer_.quiet_copy();
  int open = 1;
  Token token = next_;
  for (; open > 0; token = ahead.next()) {
    if (token.kind == TokenKind::EndOfLine || token.kind == TokenKind::EndOfFile) return false;
    if (token.kind == TokenKind::LeftParen) ++open;
    if (token.kind == TokenKind::RightParen) --open;
  }
  return goes_on(token);
}

/// `MOVE 140, 40, 0` and `MOVE` alone: shows how the target is written.
void Parser::fail_target(std::string_view motion) {
  if (at_line_end()) {
    fail(code::kTargetExpected, behind_previous(),
         fmt::format("a target expected after {}", motion), fmt::format("{}(140, 40, 0)", motion));
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
  fail(code::kTargetExpected, first.place,
       fmt::format("a target is written in parentheses: '(' expected after {}", motion),
       fmt::format("{}({})", motion, list ? written : "140, 40, 0"));
}

// clause = "AT" expr | "OVER" expr | "ACCEL" expr | "JERK" expr | "PROFILE" IDENT | "ZONE" expr
//        | "FINE" .
void Parser::clauses(Clauses& clauses) {
  while (!at_line_end() && !at(Keyword::Else) && !at(Keyword::Until) && !at(Keyword::Do)) {
    const auto* const valued =
        std::ranges::find_if(kValuedClauses, [&](std::string_view word) { return at_word(word); });
    if (valued != kValuedClauses.end()) {
      const auto index = static_cast<std::size_t>(valued - kValuedClauses.begin());
      clause(clauses.values[index], *valued);
    } else if (at_word("FINE")) {
      if (clauses.fine) report_twice("FINE");
      clauses.fine = true;
      advance();
    } else if (at_word("PROFILE")) {
      profile(clauses);
    } else {
      fail_clause();
    }
  }
}

void Parser::report_twice(std::string_view word) {
  report(code::kDuplicateClause, current_.place, fmt::format("{} is given twice", word),
         "keep one of the two");
}

void Parser::clause(ExprPtr& slot, std::string_view word) {
  if (slot) report_twice(word);
  advance();
  const bool live = at_word("LIVE") && !goes_on(next_) && next_.kind != TokenKind::EndOfLine &&
                    clause_word(next_).empty();
  if (live) fail_not_yet(current_.place, fmt::format("{} LIVE", word));
  ExprPtr value = expression();
  if (!slot) slot = std::move(value);
}

void Parser::profile(Clauses& clauses) {
  if (clauses.profile != Profile::Unspecified) report_twice("PROFILE");
  advance();
  const auto known = at(TokenKind::Word) ? find_profile(current_.text) : std::nullopt;
  if (!known) {
    const std::string meant = did_you_mean(suggest(current_.text, kProfileWords));
    fail_here(code::kUnknownProfile, fmt::format("{} is no PROFILE", described(current_)),
              meant.empty() ? fmt::format("there are {}", fmt::join(kProfileWords, ", ")) : meant);
  }
  clauses.profile = *known;
  advance();
}

void Parser::fail_clause() {
  const std::string_view known = clause_word(current_);
  if (!known.empty()) fail_not_yet(current_.place, fmt::format("{} behind a motion", known));
  const std::string meant = did_you_mean(suggest(current_.text, kClauseWords));
  if (!at(TokenKind::Word) || (meant.empty() && !remedy().empty())) end_of_line();
  fail_here(code::kUnknownClause, fmt::format("{} is no clause of a motion", described(current_)),
            meant);
}

}  // namespace rob::lang
