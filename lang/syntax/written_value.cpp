#include "lang/syntax/written_value.h"

#include "lang/syntax/lexer.h"
#include "lang/text/ascii.h"
#include "lang/text/source_text.h"
#include "lang/values/units.h"

namespace rob::lang {
namespace {

std::optional<Slot> truth_of(std::string_view word) {
  const bool on = same_word(word, "TRUE") || same_word(word, "ON");
  if (!on && !same_word(word, "FALSE") && !same_word(word, "OFF")) return std::nullopt;
  return Slot{.integer = on ? 1 : 0};
}

std::optional<Slot> name_of(std::string_view word, const TypeDetail& enumeration) {
  const auto value = value_of(enumeration, word);
  return value ? std::optional(Slot{.integer = *value}) : std::nullopt;
}

}  // namespace

std::optional<Slot> slot_of(const NumberLiteral& number, bool negative, const Type& type) {
  if (type.is(Type::Kind::Int)) {
    const bool least = number.integer < 0;
    if (!number.is_integer || (least && !negative)) return std::nullopt;
    return Slot{.integer = negative && !least ? -number.integer : number.integer};
  }
  if (number.dimension != type.dimension) return std::nullopt;
  // The language knows no -0.
  return Slot{.real = (negative ? -number.value : number.value) + 0.0};
}

std::optional<Slot> read_scalar(std::string_view text, const Type& type) {
  Diagnostics unread;
  if (!check_source(text, unread)) return std::nullopt;
  Lexer lexer = Lexer(text, unread).quiet_copy();
  Token token = lexer.next();
  const bool negative = token.kind == TokenKind::Minus;
  const bool sign = negative || token.kind == TokenKind::Plus;
  if (sign) token = lexer.next();
  // Nothing else stands there: no further line, and no comment.
  const std::size_t end = token.offset + token.text.size();
  if (text.find_first_not_of(" \t", end) != std::string_view::npos) return std::nullopt;
  if (type.is(Type::Kind::Enum)) return sign ? std::nullopt : name_of(token.text, *type.detail);
  if (!type.numeric()) return sign ? std::nullopt : truth_of(token.text);
  if (token.kind != TokenKind::Number) return std::nullopt;
  return slot_of(token.number, negative, type);
}

std::string example_of(const Type& type) {
  if (type.is(Type::Kind::Enum)) return type.detail->names.front();
  if (type.is(Type::Kind::Int)) return "7";
  return type.is(Type::Kind::Real) ? example_of(type.dimension) : "TRUE";
}

}  // namespace rob::lang
