#include <fmt/core.h>

#include "lang/syntax/parser_impl.h"
#include "lang/text/ascii.h"
#include "lang/text/codes.h"

/// The parser's rule for ZERO.
namespace rob::lang {

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
