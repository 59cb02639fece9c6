#include <utility>

#include <fmt/format.h>

#include "lang/syntax/parser_impl.h"
#include "lang/text/ascii.h"
#include "lang/text/codes.h"

/// The parser's rules for POINT and TEACH.
namespace rob::lang {

// decl = "POINT" names [ "=" expr ] eol .
void Parser::point_declaration(Block& block) {
  const Place place = current_.place;
  if (!open_blocks_.empty()) {
    report(code::kOnlyTopLevel, place, "POINT can stand only outside all blocks",
           fmt::format("write it before the {} of line {}", opener_of(open_blocks_.front().closer),
                       open_blocks_.front().place.line));
  }
  advance();
  PointDeclaration points;
  try {
    do {
      points.points.push_back({.declared = declared_name("POINT")});
    } while (accept(TokenKind::Comma));
    if (accept(TokenKind::Assign)) {
      points.value = expression();
    } else if (!at_line_end()) {
      fail_here(code::kAssignExpected, fmt::format("'=' expected, not {}", described(current_)),
                fmt::format("POINT {} = POSE(10mm, 20mm, 0mm), or the name alone",
                            shortened(points.points.front().declared.name)));
    }
  } catch (const SyntaxError&) {
    points.sound = false;
    points.value = nullptr;
    add(block, place, std::move(points));
    throw;
  }
  add(block, place, std::move(points));
}

// control = "TEACH" IDENT .
void Parser::teach_statement(Block& block) {
  const Place place = current_.place;
  advance();
  if (!at(TokenKind::Word)) {
    fail_here(code::kNameExpected,
              fmt::format("the name of a POINT expected after TEACH, not {}", described(current_)));
  }
  Teach teach;
  teach.target.text = current_.text;
  teach.target_place = current_.place;
  taught_.insert(to_upper(current_.text));
  advance();
  add(block, place, std::move(teach));
}

}  // namespace rob::lang
