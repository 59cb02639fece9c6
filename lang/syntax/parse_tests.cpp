#include <utility>

#include <fmt/format.h>

#include "lang/syntax/parser_impl.h"
#include "lang/text/ascii.h"
#include "lang/text/codes.h"

/// The parser's rules for TEST, EXPECT and SIMULATE.
namespace rob::lang {

namespace {

constexpr const char* kSimulateExample = "SIMULATE part_here = ON AFTER 2s";

}  // namespace

// routine = "TEST" STRING eol block "ENDTEST" eol .
void Parser::test() {
  const OpenBlock open{Keyword::Test, Keyword::Endtest, current_.place};
  if (!open_blocks_.empty()) {
    report(code::kMisplaced, current_.place,
           "TEST can only stand at the top level, outside of all blocks",
           fmt::format("move it behind the end of the {} of line {}",
                       opener_of(open_blocks_.front().closer), open_blocks_.front().place.line));
  }
  Routine test;
  test.place = open.place;
  test.test = true;
  advance();
  try {
    if (!at(TokenKind::String)) {
      fail_here(code::kNameExpected,
                fmt::format("the name of the TEST expected, not {}", described(current_)),
                "TEST \"the lift comes up\"");
    }
    test.name = current_.string;
    test.name_place = current_.place;
    advance();
    header_end("TEST");
  } catch (const SyntaxError&) {
    test.sound = false;
    skip_header();
  }
  test.body = block_of(open);
  test.end = current_.place;
  close(open);
  count_node(test.place);
  test.index = routines_.size();
  routines_.push_back(std::move(test));
}

// control = "EXPECT" expr .
void Parser::expect_statement(Block& block) {
  const Place place = current_.place;
  Expect node;
  advance();
  const std::size_t begin = current_.offset;
  node.condition = expression();
  node.text = source_text(begin, previous_.offset + previous_.text.size());
  add(block, place, std::move(node));
}

// control = "SIMULATE" ( IDENT [ "." IDENT ] | channel | "GO" | "ANSWER" ) "=" expr
//           [ "AFTER" expr ] .
void Parser::simulate_statement(Block& block) {
  const Place place = current_.place;
  Simulate node;
  advance();
  node.target_place = current_.place;
  if (operators_simulation(node)) {
    advance();
  } else if (at_channel()) {
    node.target = channel("SIMULATE");
  } else if (at(TokenKind::Word)) {
    node.target.text = current_.text;
    advance();
  } else {
    fail_here(
        code::kNameExpected,
        fmt::format("the name of an input expected after SIMULATE, not {}", described(current_)),
        kSimulateExample);
  }
  if (node.target.index == nullptr && accept(TokenKind::Dot)) {
    node.part = current_.text;
    node.part_place = current_.place;
    if (!at(TokenKind::Word)) {
      fail_here(code::kNameExpected,
                fmt::format("x, y or z expected behind the '.', not {}", described(current_)),
                "SIMULATE force.z = 5N AFTER 2s");
    }
    advance();
  }
  if (!accept(TokenKind::Assign)) {
    fail_here(code::kAssignExpected, fmt::format("'=' expected, not {}", described(current_)),
              kSimulateExample);
  }
  node.value = expression();
  if (at_word("AFTER")) {
    advance();
    node.after = expression();
  }
  add(block, place, std::move(node));
}

}  // namespace rob::lang
