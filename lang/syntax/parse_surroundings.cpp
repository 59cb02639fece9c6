#include <array>
#include <memory>
#include <utility>

#include <fmt/format.h>

#include "lang/syntax/parser_impl.h"
#include "lang/text/ascii.h"
#include "lang/text/codes.h"

/// The parser's rules for WITH and IN, and for the statements PATH, PRESS, OVERRIDE and LOAD.
namespace rob::lang {

/// A word that begins a statement by its place alone, and is a name where something is made of it:
/// before a parenthesis, where a routine is called so.
bool Parser::at_placed_word(std::string_view word) {
  if (!at_word(word)) return false;
  switch (next_.kind) {
    case TokenKind::Assign:
    case TokenKind::Equal:
    case TokenKind::Dot:
    case TokenKind::LeftBracket:
      return false;
    case TokenKind::LeftParen:
      return !names_routine(word);
    default:
      return true;
  }
}

bool Parser::in_path() const {
  for (const OpenBlock& open : open_blocks_) {
    if (open.closer == Keyword::Endpath) return true;
  }
  return false;
}

ExprPtr Parser::name_behind(std::string_view word, std::string_view example) {
  advance();
  if (!at(TokenKind::Word)) {
    fail_here(code::kNameExpected,
              fmt::format("a name expected after {}, not {}", word, described(current_)),
              std::string(example));
  }
  ExprPtr name = make(current_.place, Name{.text = std::string(current_.text)});
  advance();
  return name;
}

// "WITH" IDENT
void Parser::with_tool(Surroundings& surroundings) {
  surroundings_ = true;
  if (surroundings.tool != nullptr) report_twice("WITH");
  surroundings.tool = name_behind("WITH", "the name of a TOOL");
}

// "IN" refframe .   refframe = IDENT | "TOOL" .
void Parser::in_frame(Surroundings& surroundings) {
  surroundings_ = true;
  if (surroundings.has_frame()) report_twice("IN");
  const bool in_tool = next_.kind == TokenKind::Word && same_word(next_.text, "TOOL");
  surroundings.frame_place = next_.place;
  if (in_tool) advance();
  surroundings.frame = in_tool ? nullptr : name_behind("IN", "the name of a FRAME, or TOOL");
  surroundings.in_tool = in_tool;
  if (in_tool) advance();
}

/// What stands before DO; where it cannot be read the block is read all the same.
template <typename Header>
void Parser::header_up_to_do(Header header) {
  try {
    header();
    header_word(Keyword::Do, "what stands here");
  } catch (const SyntaxError&) {
    recover_until(Keyword::Do);
  }
}

// "WITH" ( IDENT [ "IN" refframe ] | "IN" refframe ) "DO" eol block "ENDWITH" eol
void Parser::with_statement(Block& block) {
  const OpenBlock open{Keyword::With, Keyword::Endwith, current_.place};
  With node;
  header_up_to_do([&] {
    const bool frame_alone = next_.kind == TokenKind::Reserved && next_.keyword == Keyword::In;
    if (frame_alone) {
      advance();
    } else {
      with_tool(node.surroundings);
    }
    if (at(Keyword::In)) in_frame(node.surroundings);
  });
  node.body = block_of(open);
  close(open);
  add(block, open.place, std::move(node));
}

// "PATH" { clause } "DO" eol pathblock "ENDPATH" eol
void Parser::path_statement(Block& block) {
  const OpenBlock open{Keyword::Endpath, Keyword::Endpath, current_.place};
  if (!current_.first_on_line) {
    fail_here(code::kMisplaced, "PATH cannot stand on the line of another statement",
              "begin a new line before it");
  }
  PathBlock node;
  header_up_to_do([&] {
    advance();
    clauses(node.clauses);
  });
  node.body = block_of(open);
  close(open);
  add(block, open.place, std::move(node));
}

// "PRESS" IDENT expr [ "LIMIT" expr ] [ "IN" refframe ] "DO" eol block "ENDPRESS" eol
void Parser::press_statement(Block& block) {
  const OpenBlock open{Keyword::Endpress, Keyword::Endpress, current_.place};
  if (!current_.first_on_line) {
    fail_here(code::kMisplaced, "PRESS cannot stand on the line of another statement",
              "begin a new line before it");
  }
  Press node;
  header_up_to_do([&] { press_header(node); });
  node.body = block_of(open);
  close(open);
  add(block, open.place, std::move(node));
}

void Parser::press_header(Press& press) {
  constexpr std::array<std::string_view, 3> kAxes{"X", "Y", "Z"};
  advance();
  press.axis = -1;
  for (std::size_t i = 0; i < kAxes.size(); ++i) {
    if (at_word(kAxes[i])) press.axis = static_cast<int>(i);
  }
  if (press.axis < 0) {
    fail_here(code::kNoPressAxis,
              fmt::format("PRESS needs the axis X, Y or Z, not {}", described(current_)),
              "PRESS Z 10N DO");
  }
  advance();
  press.force = expression();
  if (at_word("LIMIT")) {
    advance();
    press.limit = expression();
  }
  if (at(Keyword::In)) in_frame(press.surroundings);
}

// "OVERRIDE" expr
void Parser::override_statement(Block& block) {
  const Place place = current_.place;
  advance();
  SetOverride node;
  node.share = expression();
  add(block, place, std::move(node));
}

// "LOAD" expr [ "COG" expr ]
void Parser::load_statement(Block& block) {
  const Place place = current_.place;
  advance();
  Load node;
  node.mass = expression();
  if (at_word("COG")) {
    advance();
    node.cog = expression();
  }
  add(block, place, std::move(node));
}

}  // namespace rob::lang
