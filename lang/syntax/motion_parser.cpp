#include "lang/syntax/motion_parser.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include <fmt/format.h>

#include "lang/syntax/keywords.h"
#include "lang/syntax/plain_motion.h"
#include "lang/text/codes.h"

namespace rob::lang {

namespace {

/// `keyword`: of a motion.
MotionKind motion_kind(Keyword keyword) {
  const auto* const word = std::ranges::find(kMotionWords, spelling(keyword));
  return static_cast<MotionKind>(word - kMotionWords.begin());
}

}  // namespace

bool MotionParser::at_motion() const {
  return tokens_.at(TokenKind::Reserved) &&
         std::ranges::find(kMotionWords, spelling(tokens_.current().keyword)) != kMotionWords.end();
}

// motion = ( "MOVE" | "MOVEL" ) ( expr | "BY" expr ) { clause }
//        | "MOVE" "JOINT" expr ( "TO" | "BY" ) expr { clause }
//        | ( "MOVEC" | "MOVES" ) "VIA" expr { "," expr } "TO" expr { clause }
//        | "SPIRAL" "FROM" expr "TURNS" expr { clause }
//        | "JOG" ( "JOINT" | "WORLD" | "TOOL" ) expr { clause } .
void MotionParser::move(Block& block) {
  const Place place = tokens_.place();
  Move move;
  move.kind = motion_kind(tokens_.current().keyword);
  tokens_.advance();
  try {
    target_of(move);
    clauses_.clauses(move.clauses);
    tree_.add(block, place, std::move(move));
  } catch (const SyntaxError&) {
    if (tokens_.line_ends_with(Keyword::Do)) tokens_.skip_block("MOVE", "ENDMOVE");
    throw;
  }
}

/// A motion in numbers alone goes with those on the lines before it. False where it is none, or
/// where its word is a guess.
bool MotionParser::plain_motion(Block& block) {
  if (tokens_.line_muted()) return false;
  const auto motion =
      read_plain_motion(tokens_.source().substr(tokens_.current().offset), tokens_.text().size());
  if (!motion) return false;
  if (block.empty() || !std::holds_alternative<PlainMotions>(block.back().node)) {
    tree_.add(
        block, tokens_.place(),
        PlainMotions{.source = tokens_.source(), .file = tokens_.place().file, .motions = {}});
  }
  auto& plain = std::get<PlainMotions>(block.back().node);
  if (motion->pace != MoveCommand::Pace::Unspecified)
    plain.paces_and_zones.push_back(motion->pace_value);
  if (motion->zone != MoveCommand::Zone::Unspecified)
    plain.paces_and_zones.push_back(motion->zone_value);
  plain.motions.push_back({.offset = static_cast<std::uint32_t>(tokens_.current().offset),
                           .line = tokens_.place().line,
                           .column = tokens_.place().column,
                           .kind = motion_kind(tokens_.current().keyword),
                           .pace = motion->pace,
                           .zone = motion->zone});
  tokens_.skip_to(tokens_.current().offset + motion->length);
  return true;
}

void MotionParser::target_of(Move& move) {
  switch (move.kind) {
    case MotionKind::Arc:
    case MotionKind::Spline:
      return curve(move);
    case MotionKind::Spiral:
      return spiral(move);
    case MotionKind::Jog:
      return jog(move);
    case MotionKind::Joint:
      if (clauses_.at_clause_word("JOINT")) return joint_target(move);
      break;
    case MotionKind::Line:
      break;
  }
  move.by = clauses_.at_clause_word("BY");
  if (move.by) tokens_.advance();
  move.target = target(word_of(move.kind));
}

/// A word that must stand here.
void MotionParser::expect_word(std::string_view word, std::string_view behind,
                               std::string_view example) {
  if (tokens_.at_word(word)) return tokens_.advance();
  tokens_.fail_behind(code::kWordExpected, fmt::format("{} expected after {}", word, behind),
                      std::string(example));
}

void MotionParser::curve(Move& move) {
  const bool arc = move.kind == MotionKind::Arc;
  const std::string_view example = arc ? "MOVEC VIA p TO q" : "MOVES VIA p, q TO r";
  const Place place = tokens_.previous().place;
  expect_word("VIA", word_of(move.kind), example);
  do {
    // After a comma too many, or where a point is missing.
    if (clauses_.at_clause_word("TO")) break;
    move.via.push_back(target("VIA", true));
  } while (tokens_.accept(TokenKind::Comma));
  expect_word("TO", "the points of VIA", example);
  move.target = target("TO");
  if (move.via.empty() || (arc && move.via.size() > 1)) {
    tokens_.report(code::kViaCount, place,
                   arc ? fmt::format("MOVEC goes through one point to its target; here are {}",
                                     move.via.size())
                       : fmt::format("MOVES needs a point between its beginning and its target"),
                   arc && !move.via.empty() ? "MOVES goes through any number of points"
                                            : std::string(example));
  }
}

void MotionParser::spiral(Move& move) {
  constexpr std::string_view kExample = "SPIRAL FROM 4mm TURNS 5";
  expect_word("FROM", "SPIRAL", kExample);
  move.radius = expressions_.expression();
  expect_word("TURNS", "the radius", kExample);
  move.turns = expressions_.expression();
}

void MotionParser::jog(Move& move) {
  constexpr std::string_view kExample = "JOG WORLD (x: 10mm/s) FOR 2s";
  const auto* const word =
      std::ranges::find_if(kJogWords, [&](std::string_view each) { return tokens_.at_word(each); });
  if (word == kJogWords.end()) {
    tokens_.fail_behind(code::kWordExpected, "JOINT, WORLD or TOOL expected after JOG",
                        std::string(kExample));
  }
  move.jog = static_cast<JogFrame>(word - kJogWords.begin());
  tokens_.advance();
  if (!tokens_.at(TokenKind::LeftParen)) {
    tokens_.fail_behind(
        code::kTargetExpected,
        fmt::format("the rates of JOG are written in parentheses: '(' expected after {}", *word),
        std::string(kExample));
  }
  move.target = expressions_.tuple("the rates");
}

void MotionParser::joint_target(Move& move) {
  tokens_.advance();
  move.axis = expressions_.expression();
  move.by = tokens_.at_word("BY");
  if (!move.by && !tokens_.at_word("TO")) {
    tokens_.fail_behind(code::kWordExpected, "TO or BY expected after the axis of MOVE JOINT",
                        "MOVE JOINT 3 TO 90deg");
  }
  tokens_.advance();
  move.target = expressions_.expression();
}

// target = "(" element { "," element } ")" | expr .
ExprPtr MotionParser::target(std::string_view motion, bool in_list) {
  if (tokens_.at(TokenKind::LeftParen) && !group_goes_on()) {
    return expressions_.tuple("the target");
  }
  const bool value = tokens_.at(TokenKind::LeftParen) || (at_value() && (in_list || !at_list()));
  if (!value) fail_target(motion);
  return expressions_.expression();
}

/// A token that an expression may begin with, and no clause.
bool MotionParser::at_value() const {
  if (tokens_.at(TokenKind::Word)) {
    if (clauses_.at_choice()) return false;
    return clause_word(tokens_.current()).empty() || clauses_.at_name_of_value();
  }
  if (tokens_.at(TokenKind::Reserved)) return role(tokens_.current().keyword) == KeywordRole::Value;
  return tokens_.at(TokenKind::Number) || tokens_.at(TokenKind::String) ||
         tokens_.at(TokenKind::Plus) || tokens_.at(TokenKind::Minus) ||
         tokens_.at(TokenKind::LeftBracket);
}

/// `140, 40, 0` without its parentheses.
bool MotionParser::at_list() const {
  Lexer ahead = tokens_.ahead();
  int open = 0;
  for (Token token = tokens_.next();
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
bool MotionParser::group_goes_on() const {
  Lexer ahead = tokens_.ahead();
  int open = 1;
  Token token = tokens_.next();
  for (; open > 0; token = ahead.next()) {
    if (token.kind == TokenKind::EndOfLine || token.kind == TokenKind::EndOfFile) return false;
    if (token.kind == TokenKind::LeftParen) ++open;
    if (token.kind == TokenKind::RightParen) --open;
  }
  return goes_on(token);
}

/// `MOVE 140, 40, 0` and `MOVE` alone: shows how the target is written.
void MotionParser::fail_target(std::string_view motion) {
  if (tokens_.at_line_end()) {
    tokens_.fail_behind(code::kTargetExpected, fmt::format("a target expected after {}", motion),
                        fmt::format("{}(140, 40, 0)", motion));
  }
  const Token first = tokens_.current();
  Lexer ahead = tokens_.ahead();
  std::size_t end = first.offset + first.text.size();
  for (Token token = tokens_.next();
       token.kind != TokenKind::EndOfLine && token.kind != TokenKind::EndOfFile;
       token = ahead.next()) {
    if (!clause_word(token).empty() || token.kind == TokenKind::RightParen) break;
    end = token.offset + token.text.size();
  }
  constexpr std::size_t kMostShown = 60;
  const std::string_view written = tokens_.source().substr(first.offset, end - first.offset);
  const bool plain = written.size() <= kMostShown &&
                     std::ranges::all_of(written, [](char c) { return c >= ' ' && c <= '~'; });
  const bool list =
      plain && !tokens_.at(TokenKind::LeftBracket) && written.find(',') != std::string_view::npos;
  tokens_.fail(code::kTargetExpected, first.place,
               fmt::format("a target is written in parentheses: '(' expected after {}", motion),
               fmt::format("{}({})", motion, list ? written : "140, 40, 0"));
}

}  // namespace rob::lang
