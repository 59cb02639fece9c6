#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "lang/syntax/clause_words.h"
#include "lang/syntax/parser_impl.h"
#include "lang/syntax/plain_motion.h"
#include "lang/text/ascii.h"
#include "lang/text/codes.h"
#include "lang/text/suggest.h"

/// The parser's rules for motions and their clauses.
namespace rob::lang {

namespace {

/// By Clause.
constexpr std::array<std::string_view, 5> kValuedClauses{"AT", "OVER", "ACCEL", "JERK", "ZONE"};

/// `keyword`: of a motion.
MotionKind motion_kind(Keyword keyword) {
  const auto* const word = std::ranges::find(kMotionWords, spelling(keyword));
  return static_cast<MotionKind>(word - kMotionWords.begin());
}

}  // namespace

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

// motion = ( "MOVE" | "MOVEL" ) ( expr | "BY" expr ) { clause }
//        | "MOVE" "JOINT" expr ( "TO" | "BY" ) expr { clause }
//        | ( "MOVEC" | "MOVES" ) "VIA" expr { "," expr } "TO" expr { clause }
//        | "SPIRAL" "FROM" expr "TURNS" expr { clause }
//        | "JOG" ( "JOINT" | "WORLD" | "TOOL" ) expr { clause } .
void Parser::move(Block& block) {
  const Place place = current_.place;
  Move move;
  move.kind = motion_kind(current_.keyword);
  advance();
  try {
    target_of(move);
    clauses(move.clauses);
    add(block, place, std::move(move));
  } catch (const SyntaxError&) {
    if (line_ends_with(Keyword::Do)) skip_later_block("MOVE", "ENDMOVE");
    throw;
  }
}

/// A motion in numbers alone goes with those on the lines before it. False where it is none, where
/// its word is a guess, and in a PATH, whose clauses are its own.
bool Parser::plain_motion(Block& block) {
  if (current_.place.line == muted_line_ || in_path()) return false;
  const auto motion = read_plain_motion(source_.substr(current_.offset), current_.text.size());
  if (!motion) return false;
  if (block.empty() || !std::holds_alternative<PlainMotions>(block.back().node)) {
    add(block, current_.place,
        PlainMotions{.source = source_, .file = current_.place.file, .motions = {}});
  }
  std::get<PlainMotions>(block.back().node)
      .motions.push_back({.offset = static_cast<std::uint32_t>(current_.offset),
                          .line = current_.place.line,
                          .column = current_.place.column,
                          .kind = motion_kind(current_.keyword)});
  previous_ = current_;
  lexer_.skip_to(current_.offset + motion->length);
  shift();
  shift();
  return true;
}

bool Parser::at_motion() const {
  return at(TokenKind::Reserved) &&
         std::ranges::find(kMotionWords, spelling(current_.keyword)) != kMotionWords.end();
}

void Parser::target_of(Move& move) {
  switch (move.kind) {
    case MotionKind::Arc:
    case MotionKind::Spline:
      return curve(move);
    case MotionKind::Spiral:
      return spiral(move);
    case MotionKind::Jog:
      return jog(move);
    case MotionKind::Joint:
      if (at_clause_word("JOINT")) return joint_target(move);
      break;
    case MotionKind::Line:
      break;
  }
  move.by = at_clause_word("BY");
  if (move.by) advance();
  move.target = target(word_of(move.kind));
}

/// A word that must stand here.
void Parser::expect_word(std::string_view word, std::string_view behind, std::string_view example) {
  if (at_word(word)) return advance();
  fail(code::kWordExpected, behind_previous(), fmt::format("{} expected after {}", word, behind),
       std::string(example));
}

void Parser::curve(Move& move) {
  const bool arc = move.kind == MotionKind::Arc;
  const std::string_view example = arc ? "MOVEC VIA p TO q" : "MOVES VIA p, q TO r";
  const Place place = previous_.place;
  expect_word("VIA", word_of(move.kind), example);
  do {
    if (at_clause_word("TO")) break;  // behind a comma too many, or where a point is missing
    move.via.push_back(target("VIA", true));
  } while (accept(TokenKind::Comma));
  expect_word("TO", "the points of VIA", example);
  move.target = target("TO");
  if (move.via.empty() || (arc && move.via.size() > 1)) {
    report(code::kViaCount, place,
           arc ? fmt::format("MOVEC goes through one point to its target; here are {}",
                             move.via.size())
               : fmt::format("MOVES needs a point between its beginning and its target"),
           arc && !move.via.empty() ? "MOVES goes through any number of points"
                                    : std::string(example));
  }
}

void Parser::spiral(Move& move) {
  constexpr std::string_view kExample = "SPIRAL FROM 4mm TURNS 5";
  expect_word("FROM", "SPIRAL", kExample);
  move.radius = expression();
  expect_word("TURNS", "the radius", kExample);
  move.turns = expression();
}

void Parser::jog(Move& move) {
  constexpr std::string_view kExample = "JOG WORLD (x: 10mm/s) FOR 2s";
  const auto* const word =
      std::ranges::find_if(kJogWords, [&](std::string_view each) { return at_word(each); });
  if (word == kJogWords.end()) {
    fail(code::kWordExpected, behind_previous(), "JOINT, WORLD or TOOL expected after JOG",
         std::string(kExample));
  }
  move.jog = static_cast<JogFrame>(word - kJogWords.begin());
  advance();
  if (!at(TokenKind::LeftParen)) {
    fail(code::kTargetExpected, behind_previous(),
         fmt::format("the rates of JOG are written in parentheses: '(' expected after {}", *word),
         std::string(kExample));
  }
  const Place place = current_.place;
  move.target = tuple(place, elements("the rates"));
}

/// Whether the current word is a whole value, or the beginning of one that goes on: then it is a
/// name, whatever it means elsewhere. A sign may belong to the value of a clause.
bool Parser::at_name_of_value() const {
  const bool ends = next_.kind == TokenKind::EndOfLine || next_.kind == TokenKind::Comma ||
                    begins_statement(next_) || !clause_word(next_).empty();
  return ends || (goes_on(next_) && next_.kind != TokenKind::Minus);
}

/// A word behind MOVE that is not the name of what stands there.
bool Parser::at_clause_word(std::string_view word) const {
  return at_word(word) && !at_name_of_value();
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
ExprPtr Parser::target(std::string_view motion, bool in_list) {
  if (at(TokenKind::LeftParen) && !group_goes_on()) {
    const Place place = current_.place;
    return tuple(place, elements("the target"));
  }
  if (!at(TokenKind::LeftParen) && (!at_value() || (!in_list && at_list()))) fail_target(motion);
  return expression();
}

/// A token that an expression may begin with, and no clause.
bool Parser::at_value() const {
  if (at(TokenKind::Word)) return clause_word(current_).empty() || at_name_of_value();
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

// clause = "AT" [ "LIVE" ] expr | "OVER" expr | "ACCEL" expr | "JERK" expr | "PROFILE" IDENT
//        | "ZONE" expr [ NUMBER | QUANTITY | NAME ] | "FINE" [ NUMBER | QUANTITY | NAME ]
//        | "EULER" | "IN" refframe | "WITH" IDENT | "FOR" expr .
void Parser::clauses(Clauses& clauses) {
  while (!at_line_end() && !at(Keyword::Else) && !at(Keyword::Until) && !at(Keyword::Do)) {
    const auto* const valued =
        std::ranges::find_if(kValuedClauses, [&](std::string_view word) { return at_word(word); });
    if (valued != kValuedClauses.end()) {
      clause(clauses, static_cast<Clause>(valued - kValuedClauses.begin()), *valued);
    } else if (at_word("FINE")) {
      if (clauses.fine) report_twice("FINE");
      clauses.fine = true;
      advance();
      if (at_further_value()) clauses[Clause::Fine] = primary();
    } else if (at_word("EULER")) {
      if (clauses.euler) report_twice("EULER");
      clauses.euler = true;
      clauses.euler_place = current_.place;
      advance();
    } else if (at_word("PROFILE")) {
      profile(clauses);
    } else if (at(Keyword::For)) {
      clause(clauses, Clause::For, "FOR");
    } else if (at(Keyword::With)) {
      with_tool(clauses.surroundings);
    } else if (at(Keyword::In)) {
      in_frame(clauses.surroundings);
    } else {
      fail_clause();
    }
  }
}

void Parser::report_twice(std::string_view word) {
  report(code::kDuplicateClause, current_.place, fmt::format("{} is given twice", word),
         "keep one of the two");
}

void Parser::clause(Clauses& clauses, Clause which, std::string_view word) {
  ExprPtr& slot = clauses.values[static_cast<std::size_t>(which)];
  if (slot) report_twice(word);
  advance();
  if (at_live()) {
    if (which != Clause::At) {
      fail(code::kLiveMisplaced, current_.place,
           fmt::format("{} is fixed when the motion is commanded; LIVE belongs to AT alone", word),
           "MOVE(140, 40, 0) AT LIVE 20mm/s * share");
    }
    clauses.live = true;
    clauses.live_place = current_.place;
    advance();
  }
  ExprPtr value = expression();
  if (!slot) slot = std::move(value);
  if (which == Clause::Zone && at_further_value()) clauses[Clause::ZoneAngle] = primary();
}

/// The angle of a ZONE, the distance of a FINE. A word that is nearly one of a clause is taken for
/// a slip.
bool Parser::at_further_value() const {
  const bool name = at(TokenKind::Word) && clause_word(current_).empty() &&
                    suggest(current_.text, kMotionClauseWords).empty();
  return name || at(TokenKind::Number);
}

/// LIVE with a value behind it; a variable may be called so, too.
bool Parser::at_live() const { return at_clause_word("LIVE"); }

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
  const std::string meant = did_you_mean(suggest(current_.text, kMotionClauseWords));
  if (!at(TokenKind::Word) || (meant.empty() && !remedy().empty())) end_of_line();
  fail_here(code::kUnknownClause, fmt::format("{} is no clause of a motion", described(current_)),
            meant);
}

}  // namespace rob::lang
