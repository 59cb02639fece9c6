#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "lang/syntax/declarations.h"
#include "lang/syntax/parser_impl.h"
#include "lang/text/ascii.h"
#include "lang/text/codes.h"
#include "lang/text/suggest.h"
#include "lang/values/units.h"

/// The parser's rules for ROBOT, UNITS and LAW.
namespace rob::lang {
namespace {

constexpr std::array<std::string_view, 2> kLaws{"PAUL", "LOOKAHEAD"};

}  // namespace

// "ROBOT" STRING eol | "UNITS" unit { "," unit } eol | "LAW" IDENT eol
void Parser::header(const Block& block) {
  const Place place = current_.place;
  const std::string word = to_upper(current_.text);
  if (!open_blocks_.empty() || !std::ranges::all_of(block, is_declaration)) {
    fail(code::kHeaderTooLate, place,
         fmt::format("{} holds for the whole program and has to stand before its first statement",
                     word),
         "move it to the beginning");
  }
  advance();
  if (word == "ROBOT") return robot_header(place);
  if (word == "LAW") return law_header(place);
  do {
    units_header();
  } while (accept(TokenKind::Comma));
}

void Parser::robot_header(const Place& place) {
  if (!at(TokenKind::String)) {
    fail_here(code::kNameExpected, "ROBOT needs the robot's name in quotes", "ROBOT \"gantry\"");
  }
  if (header_.robot) {
    report(code::kDuplicateClause, place, "ROBOT is given twice", "keep one of the two");
  }
  header_.robot = true;
  advance();
}

void Parser::law_header(const Place& place) {
  const bool look_ahead = at_word("LOOKAHEAD");
  if (!look_ahead && !at_word("PAUL")) {
    const std::string meant = did_you_mean(suggest(current_.text, kLaws));
    fail_here(code::kUnknownLaw, fmt::format("{} is no LAW of motion", described(current_)),
              meant.empty() ? "there are PAUL and LOOKAHEAD" : meant);
  }
  if (header_.law) {
    report(code::kDuplicateClause, place, "LAW is given twice", "keep one of the two");
  }
  header_.law = {current_.place, look_ahead ? TransitionLaw::LookAhead : TransitionLaw::Paul};
  advance();
}

/// One unit: of a length or of an angle.
void Parser::units_header() {
  Place place = current_.place;
  std::string text;
  while (!at_line_end() && !at(TokenKind::Comma)) {
    text += current_.text;
    place.length = current_.place.column + current_.place.length - place.column;
    advance();
  }
  const auto unit = find_unit(text);
  if (!unit || (unit->dimension != kLength && unit->dimension != kAngle)) {
    fail(code::kUnitOfNoTarget, place,
         text.empty() ? "a unit expected after UNITS"
         : unit       ? fmt::format("{} is a unit of {}; targets have lengths and angles",
                                    shortened(text), in_words(unit->dimension))
                      : fmt::format("{} is no unit", shortened(text)),
         "UNITS mm, deg");
  }
  const bool twice = std::ranges::any_of(
      header_.units, [&](const Unit& other) { return other.dimension == unit->dimension; });
  if (twice) {
    report(code::kDuplicateClause, place,
           fmt::format("UNITS names the unit of {} twice", in_words(unit->dimension)),
           "keep one of the two");
    return;
  }
  header_.units.push_back(*unit);
}

}  // namespace rob::lang
