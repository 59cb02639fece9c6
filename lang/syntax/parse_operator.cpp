#include <utility>

#include <fmt/format.h>

#include "lang/syntax/parser_impl.h"
#include "lang/text/ascii.h"
#include "lang/text/codes.h"

/// The parser's rules for HALT and ASK, and for the operator whom SIMULATE plays.
namespace rob::lang {

// control = "HALT" [ expr ] .
void Parser::halt_statement(Block& block) {
  const Place place = current_.place;
  Halt halt;
  advance();
  if (!at_line_end() && !at(Keyword::Else)) halt.text = expression();
  add(block, place, std::move(halt));
}

// panel = "ASK" expr "INTO" place .
void Parser::ask_statement(Block& block) {
  const Place place = current_.place;
  Ask ask;
  advance();
  ask.text = expression();
  if (!at_word("INTO")) {
    fail_here(code::kWordExpected,
              fmt::format("INTO and a variable expected, not {}", described(current_)),
              "for example ASK \"how many? \" INTO count");
  }
  advance();
  ask.target = postfix();
  add(block, place, std::move(ask));
}

/// Whether the word behind SIMULATE means the operator. GO and ANSWER always do there, as in a
/// signal script.
bool Parser::operators_simulation(Simulate& node) {
  if (next_.kind != TokenKind::Assign) return false;
  if (at_word("GO")) node.what = Simulate::What::Go;
  if (at_word("ANSWER")) node.what = Simulate::What::Answer;
  return node.what != Simulate::What::Input;
}

}  // namespace rob::lang
