#include "lang/syntax/type_parser.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "lang/syntax/named_types.h"
#include "lang/text/ascii.h"
#include "lang/text/codes.h"
#include "lang/text/suggest.h"
#include "lang/text/utf8.h"
#include "lang/values/units.h"

namespace rob::lang {

namespace {

std::string type_help(std::string_view word, const TextNames::Defined& defined) {
  if (same_word(word, "REF")) return "REF stands before the name, as in REF n: INT";
  std::vector<std::string_view> names(defined.records.begin(), defined.records.end());
  names.insert(names.end(), defined.enums.begin(), defined.enums.end());
  std::ranges::transform(named_types(), std::back_inserter(names), &NamedType::name);
  const std::string help = did_you_mean(suggest(word, names));
  if (!help.empty() || !find_unit(word)) return help;
  return fmt::format("a unit as a type stands in brackets: [{}]", word);
}

}  // namespace

TypeParser::TypeParser(TokenReader& tokens, TreeBuilder& tree, TextNames& names,
                       ExpressionParser& expressions, const SourceContext& context)
    : tokens_(tokens),
      tree_(tree),
      names_(names),
      expressions_(expressions),
      table_(*context.types),
      first_array_length_(context.array_lengths) {}

void TypeParser::finish(Program& program) {
  program.array_lengths = std::move(array_lengths_);
  program.frame_uses = std::move(frame_uses_);
}

// type = ( IDENT | "FRAME" | "TOOL" ) [ "IN" IDENT ] | "[" unit "]"
//      | "ARRAY" [ "[" expr "]" ] "OF" type .
Type TypeParser::type() {
  if (tokens_.at(TokenKind::LeftBracket)) return unit_type();
  const Token word = tokens_.current();
  if (tokens_.at(Keyword::Array)) return array_type();
  if (!tokens_.at(TokenKind::Word)) {
    tokens_.fail_here(code::kUnknownType, fmt::format("a type expected, not {}", described(word)),
                      type_help(word.text, names_.defined()));
  }
  if (tokens_.at_word("LIST") && same_word(tokens_.next().text, "OF")) return list_type();
  if (const NamedType* const known = named_type(word.text)) {
    tokens_.advance();
    if (known->type.is(Type::Kind::Pose)) return pose_type();
    if (known->type.is(Type::Kind::Joints)) return Type::joints(table_.joints.get());
    return known->type.is(Type::Kind::Vec) && tokens_.at_word("OF") ? vec_type() : known->type;
  }
  if (const TypeDetail* const record = names_.record(word)) {
    tokens_.advance();
    return {record->enumeration ? Type::Kind::Enum : Type::Kind::Record, {}, record};
  }
  tokens_.fail_here(code::kUnknownType, fmt::format("{} is no type", described(word)),
                    type_help(word.text, names_.defined()));
}

// type = "ARRAY" [ "[" expr "]" ] "OF" type .
Type TypeParser::array_type() {
  const TreeBuilder::Level level(tree_);
  const Place place = tokens_.place();
  tokens_.advance();
  if (tokens_.at_word("OF")) {
    tokens_.advance();
    return table_.array(type(), kAnyLength);
  }
  if (!tokens_.at(TokenKind::LeftBracket)) {
    tokens_.fail_behind(code::kBracketExpected, "'[' and the length expected after ARRAY",
                        "ARRAY[3] OF LENGTH");
  }
  tokens_.advance();
  ExprPtr length = expressions_.expression();
  if (!tokens_.accept(TokenKind::RightBracket)) {
    tokens_.fail_behind(code::kBracketExpected, "']' expected after the length of the ARRAY",
                        tokens_.at(TokenKind::Comma)
                            ? "an ARRAY of several indices is an ARRAY[2] OF ARRAY[3] OF INT"
                            : tokens_.remedy());
  }
  if (!tokens_.at_word("OF")) {
    tokens_.fail_behind(code::kWordExpected, "OF and the type of the elements expected",
                        "ARRAY[3] OF LENGTH");
  }
  tokens_.advance();
  const Type element = type();
  TypeDetail& detail = table_.details.emplace_back();
  detail.element = element;
  detail.written = static_cast<int>(first_array_length_ + array_lengths_.size());
  array_lengths_.push_back({.array = &detail, .length = std::move(length), .place = place});
  return {Type::Kind::Array, {}, &detail};
}

// type = "LIST" "OF" type .
Type TypeParser::list_type() {
  const TreeBuilder::Level level(tree_);
  tokens_.advance();
  tokens_.advance();
  return table_.list(type());
}

/// [ "IN" IDENT ] after POSE.
Type TypeParser::pose_type() {
  if (!tokens_.at(Keyword::In)) return Type::pose();
  tokens_.advance();
  if (!tokens_.at(TokenKind::Word)) {
    tokens_.fail_here(
        code::kNameExpected,
        fmt::format("the name of a FRAME expected after IN, not {}", described(tokens_.current())));
  }
  const Token name = tokens_.current();
  tokens_.advance();
  if (same_word(name.text, "world")) return Type::pose();
  const TypeDetail* const frame = names_.frame(name);
  frame_uses_.push_back({frame, name.place});
  return Type::pose(frame);
}

/// "OF" type after VEC, which alone is one of LENGTH.
Type TypeParser::vec_type() {
  tokens_.advance();
  const Token word = tokens_.current();
  const Type part = type();
  if (part.is(Type::Kind::Real)) return Type::vec(part.dimension);
  tokens_.fail(
      code::kUnknownType, word.place,
      fmt::format("a VEC is made of numbers with a unit, or of REAL; this is {}", in_words(part)),
      "as in VEC OF FORCE");
}

// "[" unit "]": names are units here, reserved words or not, so the source itself is looked at.
Type TypeParser::unit_type() {
  tokens_.advance();
  const Token first = tokens_.current();
  const auto at_end = [&] {
    return tokens_.at(TokenKind::RightBracket) || tokens_.at(TokenKind::Bad);
  };
  while (!tokens_.at_line_end() && !at_end()) tokens_.advance();
  if (!tokens_.at(TokenKind::RightBracket) || tokens_.place().line != first.place.line) {
    tokens_.fail_behind(code::kBracketExpected, "']' expected after the unit");
  }
  std::string unit_name(
      tokens_.source().substr(first.offset, tokens_.current().offset - first.offset));
  std::erase_if(unit_name, [](char c) { return c == ' ' || c == '\t'; });
  const auto unit = find_unit(unit_name);
  if (!unit) {
    Token written = first;
    written.text = unit_name;
    written.place.length = std::max(count_code_points(unit_name), 1U);
    tokens_.fail(code::kUnknownUnit, written.place,
                 fmt::format("{} is no unit", described(written)),
                 did_you_mean(suggest(unit_name, unit_names())));
  }
  tokens_.advance();
  return Type::real(unit->dimension);
}

}  // namespace rob::lang
