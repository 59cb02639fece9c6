#include <fmt/core.h>

#include "lang/syntax/parser_impl.h"
#include "lang/text/ascii.h"
#include "lang/text/codes.h"

/// The parser's rule for ZERO.
namespace rob::lang {

/// A variable may be called so, too.
bool Parser::at_zero() const {
  return same_word(current_.text, "ZERO") && next_.kind != TokenKind::Assign &&
         next_.kind != TokenKind::Equal && next_.kind != TokenKind::Dot &&
         next_.kind != TokenKind::LeftBracket && next_.kind != TokenKind::LeftParen;
}

// robot = "ZERO" "force" .
void Parser::zero_statement(Block& block) {
  const Place place = current_.place;
  advance();
  if (!at_word("force")) {
    fail_here(code::kNotZeroed,
              fmt::format("ZERO sets the force sensor to zero, not {}", described(current_)),
              "write ZERO force");
  }
  advance();
  add(block, place, ZeroForce{});
}

}  // namespace rob::lang
