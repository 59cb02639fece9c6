#include "lang/syntax/clause_parser.h"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "lang/syntax/clause_words.h"
#include "lang/text/ascii.h"
#include "lang/text/codes.h"
#include "lang/text/suggest.h"

namespace rob::lang {

namespace {

/// By Clause.
constexpr std::array<std::string_view, 5> kValuedClauses{"AT", "OVER", "ACCEL", "JERK", "ZONE"};

/// Whether `word` is NEAR or FREE, and `after` makes a clause of it. In MOVE near NEAR j the first
/// is a name.
bool begins_choice(const Token& word, const Token& after) {
  if (word.kind != TokenKind::Word || after.kind != TokenKind::Word) return false;
  if (same_word(word.text, "FREE")) return find_free_turn(after.text).has_value();
  const bool name = same_word(after.text, "NEAR") || same_word(after.text, "FREE");
  return same_word(word.text, "NEAR") && clause_word(after).empty() && !name;
}

}  // namespace

std::string_view clause_word(const Token& token) {
  if (token.kind == TokenKind::Word) {
    for (const std::string_view word : kMotionClauseWords) {
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

// clause = "AT" [ "LIVE" ] expr | "OVER" expr | "ACCEL" expr | "JERK" expr | "PROFILE" IDENT
//        | "ZONE" expr [ NUMBER | QUANTITY | NAME ] | "FINE" [ NUMBER | QUANTITY | NAME ]
//        | "NEAR" expr | "FREE" ( "c" | "SPIN" ) | "EULER" | "IN" refframe | "WITH" IDENT | "FOR"
//        expr .
void ClauseParser::clauses(Clauses& clauses) {
  while (!tokens_.at_line_end() && !tokens_.at(Keyword::Else) && !tokens_.at(Keyword::Until) &&
         !tokens_.at(Keyword::Do)) {
    const auto* const valued = std::ranges::find_if(
        kValuedClauses, [&](std::string_view word) { return tokens_.at_word(word); });
    if (valued != kValuedClauses.end()) {
      clause(clauses, static_cast<Clause>(valued - kValuedClauses.begin()), *valued);
    } else if (tokens_.at_word("FINE")) {
      if (clauses.fine) report_twice("FINE");
      clauses.fine = true;
      tokens_.advance();
      if (at_further_value()) clauses[Clause::Fine] = expressions_.primary();
    } else if (tokens_.at_word("EULER")) {
      if (clauses.euler) report_twice("EULER");
      clauses.euler = true;
      clauses.euler_place = tokens_.place();
      tokens_.advance();
    } else if (tokens_.at_word("NEAR")) {
      near(clauses);
    } else if (tokens_.at_word("FREE")) {
      free(clauses);
    } else if (tokens_.at_word("PROFILE")) {
      profile(clauses);
    } else if (tokens_.at(Keyword::For)) {
      clause(clauses, Clause::For, "FOR");
    } else if (tokens_.at(Keyword::With)) {
      with_tool(clauses.surroundings);
    } else if (tokens_.at(Keyword::In)) {
      in_frame(clauses.surroundings);
    } else {
      fail_clause();
    }
  }
}

void ClauseParser::clause(Clauses& clauses, Clause which, std::string_view word) {
  ExprPtr& slot = clauses.values[static_cast<std::size_t>(which)];
  if (slot) report_twice(word);
  tokens_.advance();
  if (at_live()) {
    if (which != Clause::At) {
      tokens_.fail(
          code::kLiveMisplaced, tokens_.place(),
          fmt::format("{} is fixed when the motion is commanded; LIVE belongs to AT alone", word),
          "MOVE(140, 40, 0) AT LIVE 20mm/s * share");
    }
    clauses.live = true;
    clauses.live_place = tokens_.place();
    tokens_.advance();
  }
  ExprPtr value = expressions_.expression();
  if (!slot) slot = std::move(value);
  if (which == Clause::Zone && at_further_value())
    clauses[Clause::ZoneAngle] = expressions_.primary();
}

/// LIVE with a value after it; a variable may be called so, too.
bool ClauseParser::at_live() const { return at_clause_word("LIVE"); }

/// The angle of a ZONE, the distance of a FINE. A word that is nearly one of a clause is taken for
/// a slip.
bool ClauseParser::at_further_value() const {
  const bool name = tokens_.at(TokenKind::Word) && clause_word(tokens_.current()).empty() &&
                    !(at_choice_word() && !value_ends_at_next()) &&
                    suggest(tokens_.text(), kMotionClauseWords).empty();
  return name || tokens_.at(TokenKind::Number);
}

void ClauseParser::near(Clauses& clauses) {
  if (clauses.near != nullptr) report_twice("NEAR");
  clauses.near_place = tokens_.place();
  tokens_.advance();
  ExprPtr joints = expressions_.expression();
  if (clauses.near == nullptr) clauses.near = std::move(joints);
}

void ClauseParser::free(Clauses& clauses) {
  if (clauses.free != FreeTurn::None) report_twice("FREE");
  clauses.free_place = tokens_.place();
  tokens_.advance();
  const auto known = tokens_.at(TokenKind::Word) ? find_free_turn(tokens_.text()) : std::nullopt;
  if (!known) {
    tokens_.fail_here(
        code::kNoFreeTurn,
        fmt::format("FREE leaves c or SPIN open, not {}", described(tokens_.current())),
        "FREE c: any turn about z of the target's frame; FREE SPIN: any about the tool's own z");
  }
  clauses.free = *known;
  tokens_.advance();
}

void ClauseParser::profile(Clauses& clauses) {
  if (clauses.profile != Profile::Unspecified) report_twice("PROFILE");
  tokens_.advance();
  const auto known = tokens_.at(TokenKind::Word) ? find_profile(tokens_.text()) : std::nullopt;
  if (!known) {
    const std::string meant = did_you_mean(suggest(tokens_.text(), kProfileWords));
    tokens_.fail_here(
        code::kUnknownProfile, fmt::format("{} is no PROFILE", described(tokens_.current())),
        meant.empty() ? fmt::format("there are {}", fmt::join(kProfileWords, ", ")) : meant);
  }
  clauses.profile = *known;
  tokens_.advance();
}

void ClauseParser::with_header(Clauses& clauses) {
  if (clause_word(tokens_.next()).empty() || tokens_.next_is(Keyword::Do)) {
    with_tool(clauses.surroundings);
  } else {
    tokens_.advance();
  }
  this->clauses(clauses);
}

// "WITH" IDENT
void ClauseParser::with_tool(Surroundings& surroundings) {
  surroundings_ = true;
  if (surroundings.tool != nullptr) report_twice("WITH");
  surroundings.tool = name_behind("WITH", "the name of a TOOL");
}

// "IN" refframe .   refframe = IDENT | "TOOL" .
void ClauseParser::in_frame(Surroundings& surroundings) {
  surroundings_ = true;
  if (surroundings.has_frame()) report_twice("IN");
  const bool in_tool =
      tokens_.next().kind == TokenKind::Word && same_word(tokens_.next().text, "TOOL");
  surroundings.frame_place = tokens_.next().place;
  if (in_tool) tokens_.advance();
  surroundings.frame = in_tool ? nullptr : name_behind("IN", "the name of a FRAME, or TOOL");
  surroundings.in_tool = in_tool;
  if (in_tool) tokens_.advance();
}

ExprPtr ClauseParser::name_behind(std::string_view word, std::string_view example) {
  tokens_.advance();
  if (!tokens_.at(TokenKind::Word)) {
    tokens_.fail_here(
        code::kNameExpected,
        fmt::format("a name expected after {}, not {}", word, described(tokens_.current())),
        std::string(example));
  }
  ExprPtr name = tree_.make(tokens_.place(), Name{.text = std::string(tokens_.text())});
  tokens_.advance();
  return name;
}

/// Whether the current word is a whole value, or the beginning of one that goes on: then it is a
/// name, whatever it means elsewhere. A sign may belong to the value of a clause.
bool ClauseParser::at_name_of_value() const {
  return value_ends_at_next() || begins_choice(tokens_.next(), tokens_.ahead().next()) ||
         (goes_on(tokens_.next()) && tokens_.next().kind != TokenKind::Minus);
}

bool ClauseParser::value_ends_at_next() const {
  return tokens_.next().kind == TokenKind::EndOfLine || tokens_.next().kind == TokenKind::Comma ||
         begins_statement(tokens_.next()) || !clause_word(tokens_.next()).empty();
}

bool ClauseParser::at_choice_word() const {
  return tokens_.at_word("NEAR") || tokens_.at_word("FREE");
}

/// A word after MOVE that is not the name of what stands there.
bool ClauseParser::at_clause_word(std::string_view word) const {
  return tokens_.at_word(word) && !at_name_of_value();
}

bool ClauseParser::at_choice() const { return begins_choice(tokens_.current(), tokens_.next()); }

void ClauseParser::report_twice(std::string_view word) {
  tokens_.report(code::kDuplicateClause, tokens_.place(), fmt::format("{} is given twice", word),
                 "keep one of the two");
}

void ClauseParser::fail_clause() {
  const std::string_view near = suggest(tokens_.text(), kMotionClauseWords);
  const std::string meant =
      did_you_mean(near.empty() ? suggest(tokens_.text(), kChoiceWords) : near);
  const bool word = tokens_.at(TokenKind::Word);
  if (!word || (meant.empty() && !tokens_.remedy().empty())) tokens_.end_of_line();
  tokens_.fail_here(code::kUnknownClause,
                    fmt::format("{} is no clause of a motion", described(tokens_.current())),
                    meant);
}

}  // namespace rob::lang
