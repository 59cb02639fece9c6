#include <utility>

#include <fmt/format.h>

#include "lang/syntax/parser_impl.h"
#include "lang/text/ascii.h"
#include "lang/text/codes.h"

/// The parser's rules for TRY and RAISE.
namespace rob::lang {

// "TRY" eol block "RESCUE" [ NAME ] eol block "ENDTRY" eol
void Parser::try_statement(Block& block) {
  const OpenBlock open{Keyword::Try, Keyword::Endtry, current_.place};
  Try node;
  advance();
  header_end("TRY");
  node.body = block_of(open);
  if (at(Keyword::Rescue)) {
    rescue_header(node);
    node.rescue = block_of(open);
    while (at(Keyword::Rescue)) {
      report(code::kStrayCloser, current_.place,
             fmt::format("a second RESCUE in the TRY of line {}", open.place.line),
             "one RESCUE handles all errors; IF and SELECT tell them apart");
      rescue_header(node);
      block_of(open);
    }
  } else if (at(Keyword::Endtry)) {
    report(code::kRescueMissing, current_.place,
           fmt::format("the TRY of line {} has no RESCUE", open.place.line),
           "RESCUE, on a line of its own, begins what is done when something goes wrong");
  }
  close(open);
  add(block, open.place, std::move(node));
}

void Parser::rescue_header(Try& node) {
  advance();
  if (!at_line_end()) {
    try {
      node.why = declared_name("RESCUE");
    } catch (const SyntaxError&) {
      return skip_header();
    }
  }
  header_end("RESCUE");
}

// control = "RAISE" [ expr ] .
void Parser::raise_statement(Block& block) {
  const Place place = current_.place;
  Raise node;
  advance();
  if (!at_line_end()) node.value = expression();
  add(block, place, std::move(node));
}

}  // namespace rob::lang
