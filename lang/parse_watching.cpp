#include <utility>

#include <fmt/format.h>

#include "lang/codes.h"
#include "lang/parser_impl.h"

/// The parser's rules for what is looked at in every control cycle.
namespace rob::lang {

// until = "UNTIL" expr [ "ELSE" simple ] .
void Parser::behind_motion(Block& block) {
  if (!at(Keyword::Until)) return;
  const Place place = block.back().place;
  WatchedMotion watched;
  watched.motion.push_back(std::move(block.back()));
  block.pop_back();
  advance();
  watched.until = expression();
  if (at(Keyword::Else) && !current_.first_on_line) {
    advance();
    watched.has_else = true;
    alternative(watched.otherwise);
  }
  add(block, place, std::move(watched));
}

}  // namespace rob::lang
