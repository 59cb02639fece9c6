#include "lang/format/statement_words.h"

#include <algorithm>
#include <array>
#include <string>

#include "lang/syntax/clause_words.h"
#include "lang/text/ascii.h"
#include "lang/values/units.h"

namespace rob::lang {

namespace {

/// Words of path events, which are statements in a PATH.
constexpr std::array<std::string_view, 2> kEventWords{"AFTER", "BEFORE"};

/// Clauses without a value.
constexpr std::array<std::string_view, 3> kWholeClauses{"FINE", "EULER", "SPIN"};

/// Words that stand after a value: no expression goes on with a name there.
constexpr auto kClauseWords = std::to_array<std::string_view>(
    {"AT",  "OVER", "ACCEL", "JERK",  "PROFILE", "ZONE",    "FINE",  "BY",     "VIA",
     "TO",  "FROM", "OF",    "TURNS", "STEP",    "TIMEOUT", "INTO",  "LIMIT",  "LEAD",
     "LAG", "MASS", "COG",   "SCALE", "SAFE",    "AFTER",   "EULER", "ENDING", "SHAPE"});

bool is_among(std::span<const std::string_view> words, std::string_view word) {
  return std::ranges::any_of(words, [&](std::string_view each) { return same_word(each, word); });
}

bool opens(TokenKind kind) {
  return kind == TokenKind::LeftParen || kind == TokenKind::LeftBracket;
}
bool closes(TokenKind kind) {
  return kind == TokenKind::RightParen || kind == TokenKind::RightBracket;
}

/// Whether a word with this sign after it is a value: something is computed from it.
bool goes_on(TokenKind kind) {
  return kind == TokenKind::Plus || kind == TokenKind::Minus || kind == TokenKind::Star ||
         kind == TokenKind::Slash || kind == TokenKind::Caret || kind == TokenKind::Dot;
}

bool assigns(TokenKind kind) { return kind >= TokenKind::Assign && kind <= TokenKind::SlashAssign; }

bool is_literal(const Token& token) {
  if (token.kind != TokenKind::Reserved) return false;
  return token.keyword == Keyword::True || token.keyword == Keyword::False ||
         token.keyword == Keyword::On || token.keyword == Keyword::Off;
}

/// The number of tokens between brackets that open `rest`, if they spell a unit; otherwise 0.
std::size_t unit_between(std::span<const Token> rest) {
  std::string text;
  for (std::size_t i = 1; i < rest.size(); ++i) {
    if (rest[i].kind == TokenKind::RightBracket) return find_unit(text) ? i - 1 : 0;
    text += rest[i].text;
  }
  return 0;
}

}  // namespace

void StatementWords::begin(bool fields) {
  *this = {};
  fields_ = fields;
}

WrittenWord StatementWords::next(std::span<const Token> rest) {
  WrittenWord written;
  written.use = use_of(rest);
  written.blank_before = blank_before(rest.front(), written.use);
  go_on(rest.front(), written.use);
  return written;
}

bool StatementWords::follows(Keyword keyword) const {
  return previous_.kind == TokenKind::Reserved && previous_.keyword == keyword;
}

bool StatementWords::follows_clause(std::string_view word) const {
  return previous_use_ == WordUse::Clause && same_word(previous_.text, word);
}

WordUse StatementWords::use_of(std::span<const Token> rest) {
  const Token& token = rest.front();
  const TokenKind behind = rest.size() > 1 ? rest[1].kind : TokenKind::EndOfLine;
  if (unit_words_ > 0) {
    --unit_words_;
    return WordUse::Unit;
  }
  if (all_units_) return token.kind == TokenKind::Comma ? WordUse::Other : WordUse::Unit;
  const bool type_follows = (previous_.kind == TokenKind::Colon && !file_) || follows_clause("OF");
  if (token.kind == TokenKind::LeftBracket && type_follows) unit_words_ = unit_between(rest);
  const bool reserved = token.kind == TokenKind::Reserved;
  if (enum_ && (reserved || token.kind == TokenKind::Word)) return WordUse::Kept;
  if (reserved && previous_.kind == TokenKind::Dot) return WordUse::Member;
  if (token.kind == TokenKind::Word) return use_of_word(token, behind);
  return is_unary(token) ? WordUse::UnarySign : WordUse::Other;
}

WordUse StatementWords::use_of_word(const Token& word, TokenKind behind) {
  if (previous_.kind == TokenKind::Dot) return WordUse::Member;
  if (follows(Keyword::Use) || follows(Keyword::Record)) return WordUse::Kept;
  if (fields_ && (at_begin_ || previous_.kind == TokenKind::Comma)) return WordUse::Kept;
  const bool shape_follows = (obstacle_ && previous_.kind == TokenKind::Assign) ||
                             (shape_ && depth_ == 0 && behind == TokenKind::LeftParen);
  if (shape_follows) return WordUse::Shape;
  if (begins_as_keyword(word, behind) || is_clause(word, behind)) return WordUse::Clause;
  if (depth_ > 0 && behind == TokenKind::Colon) return WordUse::Label;
  const bool type = (previous_.kind == TokenKind::Colon && !file_) || follows_clause("OF");
  return type && !at_begin_ ? WordUse::TypeName : WordUse::Name;
}

/// A statement that is known by its place only, at the beginning of a line.
bool StatementWords::begins_as_keyword(const Token& word, TokenKind behind) const {
  if (!at_begin_) return false;
  if (!is_among(kPlacedWords, word.text) && !is_among(kEventWords, word.text) &&
      !is_among(kFileWords, word.text) && !is_among(kNamingWords, word.text))
    return false;
  return !assigns(behind) && !goes_on(behind) && behind != TokenKind::LeftBracket &&
         behind != TokenKind::LeftParen;
}

/// NEAR and FREE after a value, and what FREE names: `c` stays as it is written.
bool StatementWords::is_choice(const Token& word, TokenKind behind) const {
  if (follows_clause("FREE")) return same_word(word.text, "SPIN");
  const bool near = same_word(word.text, "NEAR") && behind != TokenKind::EndOfLine;
  return behind_value_ && (near || (same_word(word.text, "FREE") && behind == TokenKind::Word));
}

bool StatementWords::is_clause(const Token& word, TokenKind behind) const {
  if (is_choice(word, behind)) return true;
  const bool header = follows_clause("PATH") || follows_clause("DEFAULT") ||
                      (with_block_ && follows(Keyword::With));
  if (behind_value_ || header) return is_among(kClauseWords, word.text);
  const auto is = [&](std::string_view text) { return same_word(word.text, text); };
  if (follows(Keyword::Jog)) return is("JOINT") || is("WORLD") || is("TOOL");
  if (follows(Keyword::Move) || follows(Keyword::Movel)) {
    const bool value = behind == TokenKind::EndOfLine || goes_on(behind);
    return (is("BY") || is("JOINT")) && (!value || behind == TokenKind::Minus);
  }
  if (follows(Keyword::Movec) || follows(Keyword::Moves)) return is("VIA");
  if (follows(Keyword::Spiral)) return is("FROM");
  if (follows_clause("PRESS")) return is("X") || is("Y") || is("Z");
  if (follows(Keyword::In)) return is("TOOL");
  if (follows_clause("AT")) {
    return is("LIVE") && !goes_on(behind) && behind != TokenKind::EndOfLine;
  }
  const bool in_list = previous_.kind == TokenKind::LeftParen || previous_.kind == TokenKind::Comma;
  return in_list && is("REF") && behind == TokenKind::Word;
}

bool StatementWords::is_unary(const Token& token) const {
  return (token.kind == TokenKind::Plus || token.kind == TokenKind::Minus) && !behind_value_;
}

bool StatementWords::blank_before(const Token& token, WordUse use) const {
  const TokenKind before = previous_.kind;
  if (before == TokenKind::EndOfFile) return false;
  if (before == TokenKind::Comma) return true;
  if (opens(before) || before == TokenKind::Dot) return false;
  if (previous_use_ == WordUse::UnarySign) return false;
  if (use == WordUse::Unit) return previous_use_ != WordUse::Unit;
  if (closes(token.kind) || token.kind == TokenKind::Comma || token.kind == TokenKind::Dot) {
    return false;
  }
  if (token.kind == TokenKind::Colon) return trigger_ && depth_ == 0;
  const bool called = behind_value_ && previous_use_ != WordUse::Clause;
  if (token.kind == TokenKind::LeftParen) {
    return !called && !follows(Keyword::Move) && !follows(Keyword::Movel);
  }
  if (token.kind == TokenKind::LeftBracket) return !called && !follows(Keyword::Array);
  return true;
}

void StatementWords::go_on(const Token& token, WordUse use) {
  if (opens(token.kind)) ++depth_;
  if (closes(token.kind) && depth_ > 0) --depth_;
  const bool clause = use == WordUse::Clause;
  if (clause && at_begin_) {
    trigger_ = is_among(kEventWords, token.text);
    all_units_ = same_word(token.text, "UNITS");
    enum_ = same_word(token.text, "ENUM");
    obstacle_ = same_word(token.text, "OBSTACLE");
    file_ = same_word(token.text, "WRITE") || same_word(token.text, "SEND");
  }
  if (clause && same_word(token.text, "SHAPE")) shape_ = true;
  if (at_begin_ && token.kind == TokenKind::Reserved && token.keyword == Keyword::When) {
    trigger_ = true;
  }
  if (token.kind == TokenKind::Reserved && token.keyword == Keyword::With) with_block_ = at_begin_;
  behind_value_ = closes(token.kind) || token.kind == TokenKind::Number ||
                  token.kind == TokenKind::String || is_literal(token) ||
                  (token.kind == TokenKind::Word && !clause) ||
                  (clause && is_among(kWholeClauses, token.text));
  const bool action_follows = token.kind == TokenKind::Reserved &&
                              (token.keyword == Keyword::Then || token.keyword == Keyword::Else);
  at_begin_ = action_follows || (trigger_ && depth_ == 0 && token.kind == TokenKind::Colon);
  previous_ = token;
  previous_use_ = use;
}

}  // namespace rob::lang
