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

// "WHEN" expr ":" action eol
void Parser::when_statement(Block& block) {
  const Place place = current_.place;
  if (line_ends_with(Keyword::Do)) {
    report(code::kNotYet, place, "WHEN … DO is not in this version of Rob yet");
    skip_later_block("WHEN", "ENDWHEN", false);
    throw SyntaxError{};
  }
  When when;
  advance();
  when.condition = expression();
  action(when.action, "WHEN");
  add(block, place, std::move(when));
}

/// What stands behind the ':' of a WHEN: one statement on the same line.
void Parser::action(Block& block, std::string_view behind) {
  if (!accept(TokenKind::Colon)) {
    fail(code::kWordExpected, behind_previous(), fmt::format("':' expected behind {}", behind),
         remedy());
  }
  if (at_line_end()) {
    fail(code::kStatementExpected, behind_previous(), "a statement expected behind ':'",
         "for example lift = OFF");
  }
  const Level level(*this);
  simple(block);
}

}  // namespace rob::lang
