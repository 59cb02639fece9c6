#include "lang/syntax/header_parser.h"

#include <algorithm>
#include <array>
#include <string>

#include <fmt/format.h>

#include "lang/syntax/declarations.h"
#include "lang/text/ascii.h"
#include "lang/text/codes.h"
#include "lang/text/suggest.h"
#include "lang/values/units.h"

namespace rob::lang {

namespace {

constexpr std::array<std::string_view, 2> kLaws{"PAUL", "LOOKAHEAD"};

}  // namespace

// "ROBOT" STRING eol | "UNITS" unit { "," unit } eol | "LAW" IDENT eol
void HeaderParser::header(const Block& block, bool inside) {
  const Place place = tokens_.place();
  const std::string word = to_upper(tokens_.text());
  if (inside || !std::ranges::all_of(block, is_declaration)) {
    tokens_.fail(
        code::kHeaderTooLate, place,
        fmt::format("{} holds for the whole program and must stand before its first statement",
                    word),
        "move it to the beginning");
  }
  tokens_.advance();
  if (word == "ROBOT") return robot_header(place);
  if (word == "LAW") return law_header(place);
  do {
    units_header();
  } while (tokens_.accept(TokenKind::Comma));
}

void HeaderParser::robot_header(const Place& place) {
  if (!tokens_.at(TokenKind::String)) {
    tokens_.fail_here(code::kNameExpected, "ROBOT needs the robot's name in quotes",
                      "ROBOT \"gantry\"");
  }
  if (header_.robot) {
    tokens_.report(code::kDuplicateClause, place, "ROBOT is given twice", "keep one of the two");
  }
  header_.robot = true;
  tokens_.advance();
}

void HeaderParser::law_header(const Place& place) {
  const bool look_ahead = tokens_.at_word("LOOKAHEAD");
  if (!look_ahead && !tokens_.at_word("PAUL")) {
    const std::string meant = did_you_mean(suggest(tokens_.text(), kLaws));
    tokens_.fail_here(code::kUnknownLaw,
                      fmt::format("{} is no LAW of motion", described(tokens_.current())),
                      meant.empty() ? "there are PAUL and LOOKAHEAD" : meant);
  }
  if (header_.law) {
    tokens_.report(code::kDuplicateClause, place, "LAW is given twice", "keep one of the two");
  }
  header_.law = {tokens_.place(), look_ahead ? TransitionLaw::LookAhead : TransitionLaw::Paul};
  tokens_.advance();
}

/// One unit: of a length or of an angle.
void HeaderParser::units_header() {
  Place place = tokens_.place();
  std::string text;
  while (!tokens_.at_line_end() && !tokens_.at(TokenKind::Comma)) {
    text += tokens_.text();
    place.length = tokens_.place().column + tokens_.place().length - place.column;
    tokens_.advance();
  }
  const auto unit = find_unit(text);
  if (!unit || (unit->dimension != kLength && unit->dimension != kAngle)) {
    tokens_.fail(code::kUnitOfNoTarget, place,
                 text.empty() ? "a unit expected after UNITS"
                 : unit       ? fmt::format("{} is a unit of {}; targets have lengths and angles",
                                            shortened(text), in_words(unit->dimension))
                              : fmt::format("{} is no unit", shortened(text)),
                 "UNITS mm, deg");
  }
  const bool twice = std::ranges::any_of(
      header_.units, [&](const Unit& other) { return other.dimension == unit->dimension; });
  if (twice) {
    tokens_.report(code::kDuplicateClause, place,
                   fmt::format("UNITS names the unit of {} twice", in_words(unit->dimension)),
                   "keep one of the two");
    return;
  }
  header_.units.push_back(*unit);
}

}  // namespace rob::lang
