#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "lang/syntax/parser_impl.h"
#include "lang/text/ascii.h"
#include "lang/text/codes.h"

/// The parser's rules for ARRAY, RECORD and lists.
namespace rob::lang {

// primary = "[" expr { "," expr } "]" .
ExprPtr Parser::list() {
  const Level level(*this);
  const Place place = current_.place;
  List list;
  int height = 0;
  advance();
  if (at(TokenKind::RightBracket)) {
    fail(code::kListEmpty, place, "there is nothing between the brackets",
         "an ARRAY has at least one element: VAR a: ARRAY[3] OF INT fills it with 0");
  }
  do {
    list.elements.push_back(expression());
    height = std::max(height, list.elements.back()->height);
  } while (accept(TokenKind::Comma));
  if (!accept(TokenKind::RightBracket)) {
    fail(code::kBracketExpected, behind_previous(), "']' expected after the list", remedy());
  }
  return make(place, std::move(list), height + 1);
}

// type = "ARRAY" "[" expr "]" "OF" type .
Type Parser::array_type() {
  const Level level(*this);
  const Place place = current_.place;
  advance();
  if (!at(TokenKind::LeftBracket)) {
    fail(code::kBracketExpected, behind_previous(), "'[' and the length expected after ARRAY",
         "ARRAY[3] OF LENGTH");
  }
  advance();
  ExprPtr length = expression();
  if (!accept(TokenKind::RightBracket)) {
    fail(code::kBracketExpected, behind_previous(), "']' expected after the length of the ARRAY",
         at(TokenKind::Comma) ? "an ARRAY of several indices is an ARRAY[2] OF ARRAY[3] OF INT"
                              : remedy());
  }
  if (!at_word("OF")) {
    fail(code::kWordExpected, behind_previous(), "OF and the type of the elements expected",
         "ARRAY[3] OF LENGTH");
  }
  advance();
  const Type element = type();
  TypeDetail& detail = types_->details.emplace_back();
  detail.element = element;
  detail.written = static_cast<int>(first_array_length_ + array_lengths_.size());
  array_lengths_.push_back({.array = &detail, .length = std::move(length), .place = place});
  return {Type::Kind::Array, {}, &detail};
}

// decl = "RECORD" NAME eol { NAME { "," NAME } ":" type eol } "ENDRECORD" eol .
void Parser::record_declaration(Block& block) {
  const OpenBlock open{Keyword::Record, Keyword::Endrecord, current_.place};
  if (!open_blocks_.empty()) {
    report(code::kOnlyTopLevel, open.place, "RECORD can stand only outside all blocks",
           fmt::format("write it before the {} of line {}", spelling(open_blocks_.front().opener),
                       open_blocks_.front().place.line));
  }
  RecordDeclaration record;
  advance();
  try {
    record.declared = declared_name("RECORD");
    if (named_type(record.declared.name)) {
      fail(code::kReservedName, record.declared.place,
           fmt::format("{} is a type of the language", shortened(record.declared.name)),
           "choose another name");
    }
    record.detail = &types_->record(file_, record.declared.name);
    header_end("RECORD");
  } catch (const SyntaxError&) {
    record.sound = false;
    skip_header();
  }
  record_fields(record);
  // A statement that stands where a field should is left for what follows.
  const bool statement =
      at(TokenKind::Reserved) && !at(Keyword::End) && role(current_.keyword) != KeywordRole::Closer;
  statement ? report_unclosed(open) : close(open);
  if (record.detail != nullptr) add(block, open.place, std::move(record));
}

void Parser::record_fields(RecordDeclaration& record) {
  const auto at_end = [&] {
    return at(TokenKind::EndOfFile) ||
           (at(TokenKind::Reserved) && role(current_.keyword) != KeywordRole::Value);
  };
  for (;;) {
    while (accept(TokenKind::EndOfLine)) {
    }
    if (at_end()) return;
    try {
      record.groups.push_back(record_group());
      end_of_line();
    } catch (const SyntaxError&) {
      record.sound = false;
      recover();
    }
  }
}

RecordDeclaration::Fields Parser::record_group() {
  RecordDeclaration::Fields group;
  do {
    count_node(current_.place);
    group.names.push_back(declared_name("RECORD"));
  } while (accept(TokenKind::Comma));
  if (!accept(TokenKind::Colon)) {
    fail(code::kWordExpected, behind_previous(), "':' and a type expected after the field",
         fmt::format("for example {}: LENGTH", shortened(group.names.back().name)));
  }
  group.type = type();
  return group;
}

}  // namespace rob::lang
