#include <string>
#include <utility>

#include <fmt/format.h>

#include "lang/syntax/parser_impl.h"
#include "lang/text/ascii.h"
#include "lang/text/codes.h"
#include "lang/text/utf8.h"

/// The parser's rules for LOOP, SELECT and ASSERT.
namespace rob::lang {

/// The rest of a header that could not be read.
void Parser::skip_header() {
  brackets_ = 0;
  while (!at_line_end()) shift();
}

/// The end of a header's line; `word` is what the header begins with.
void Parser::header_end(std::string_view word) {
  if (at_line_end()) return;
  if (!at(TokenKind::Bad)) {  // that is reported already
    report(code::kLineEndExpected, current_.place,
           fmt::format("{} cannot stand on the line of {}", described(current_), word),
           "begin a new line before it");
  }
  skip_header();
}

// "LOOP" eol block "ENDLOOP" eol
void Parser::loop_statement(Block& block) {
  const OpenBlock open{Keyword::Loop, Keyword::Endloop, current_.place};
  Loop loop;
  advance();
  header_end("LOOP");
  loop.body = block_of(open);
  close(open);
  add(block, open.place, std::move(loop));
}

// "SELECT" expr eol { "CASE" expr { "," expr } ":" eol block } [ "ELSE" eol block ] "ENDSELECT" eol
void Parser::select_statement(Block& block) {
  const OpenBlock open{Keyword::Select, Keyword::Endselect, current_.place};
  Select node;
  advance();
  try {
    node.selector = expression();
    header_end("SELECT");
  } catch (const SyntaxError&) {
    skip_header();
  }
  const Block before = block_of(open);
  if (!before.empty()) {
    report(code::kMisplaced, before.front().place, "nothing may stand between SELECT and CASE",
           "move it behind a CASE, or before SELECT");
  }
  select_branches(node, open);
  close(open);
  add(block, open.place, std::move(node));
}

void Parser::select_branches(Select& node, const OpenBlock& open) {
  while (at(Keyword::Case) || at(Keyword::Else)) {
    if (node.has_else) {
      report(code::kStrayCloser, current_.place,
             fmt::format("{} behind the ELSE of the SELECT of line {}", spelling(current_.keyword),
                         open.place.line),
             "ELSE stands last");
    }
    if (at(Keyword::Case)) {
      node.cases.push_back({current_.place, {}, {}});
      Select::Case& branch = node.cases.back();
      advance();
      case_values(branch);
      branch.body = block_of(open);
    } else {
      advance();
      accept(TokenKind::Colon);  // as behind CASE; it changes nothing
      header_end("ELSE");
      node.has_else = true;
      node.otherwise = block_of(open);
    }
  }
}

void Parser::case_values(Select::Case& branch) {
  try {
    do {
      branch.values.push_back(expression());
    } while (accept(TokenKind::Comma));
    if (!accept(TokenKind::Colon)) {
      fail(code::kWordExpected, behind_previous(), "':' expected after the values of CASE",
           remedy());
    }
    header_end("CASE");
  } catch (const SyntaxError&) {
    skip_header();
  }
}

// control = "ASSERT" expr .
void Parser::assert_statement(Block& block) {
  const Place place = current_.place;
  Assert node;
  advance();
  const std::size_t begin = current_.offset;
  node.condition = expression();
  node.text = source_text(begin, previous_.offset + previous_.text.size());
  add(block, place, std::move(node));
}

/// A piece of the source for messages: on one line, and not too long for one.
std::string Parser::source_text(std::size_t begin, std::size_t end) const {
  constexpr std::size_t kMost = 80;  // [choice] the message still fits two lines of a terminal
  std::string text;
  for (const char c : source_.substr(begin, end - begin)) {
    const bool blank = c == ' ' || c == '\t' || c == '\n' || c == '\r';
    if (!blank) text += c;
    if (blank && !text.ends_with(' ')) text += ' ';
  }
  if (text.size() <= kMost) return text;
  std::size_t cut = kMost;
  while (is_utf8_continuation(text[cut])) --cut;
  return text.substr(0, cut) + "\u2026";
}

}  // namespace rob::lang
