#include "lang/vm/answer.h"

#include <optional>

#include <fmt/format.h>

#include "lang/syntax/lexer.h"
#include "lang/text/ascii.h"
#include "lang/text/source_text.h"

namespace rob::lang {
namespace {

bool is_text(std::string_view line) {
  Diagnostics unread;
  return check_source(line, unread);
}

bool read_number(const NumberLiteral& number, bool negative, const Type& type, Slot& value) {
  if (type.is(Type::Kind::Int)) {
    const bool least = number.integer < 0;
    if (!number.is_integer || (least && !negative)) return false;
    value.integer = negative && !least ? -number.integer : number.integer;
    return true;
  }
  if (number.dimension != type.dimension) return false;
  const double size = number.value;
  value.real = (negative ? -size : size) + 0.0;  // the language knows no -0
  return true;
}

bool read_truth(const Token& token, Slot& value) {
  const bool on = same_word(token.text, "TRUE") || same_word(token.text, "ON");
  if (!on && !same_word(token.text, "FALSE") && !same_word(token.text, "OFF")) return false;
  value.integer = on ? 1 : 0;
  return true;
}

bool read_name(const Token& token, const TypeDetail& enumeration, Slot& value) {
  const auto named = value_of(enumeration, token.text);
  if (named) value.integer = *named;
  return named.has_value();
}

bool read_answer(std::string_view line, const Type& type, Slot& value) {
  if (!is_text(line)) return false;
  Diagnostics unread;
  Lexer lexer = Lexer(line, unread).quiet_copy();
  Token token = lexer.next();
  const bool negative = token.kind == TokenKind::Minus;
  const bool sign = negative || token.kind == TokenKind::Plus;
  if (sign) token = lexer.next();
  if (lexer.next().kind != TokenKind::EndOfLine) return false;
  if (type.is(Type::Kind::Enum)) return !sign && read_name(token, *type.detail, value);
  if (!type.numeric()) return !sign && read_truth(token, value);
  return token.kind == TokenKind::Number && read_number(token.number, negative, type, value);
}

bool read_answer(std::string_view line, std::string& value) {
  if (!is_text(line)) return false;
  value = line;
  return true;
}

/// "'7' is not a length, such as 5mm": for one who has to try again.
std::string misread_answer(std::string_view line, const Type& type) {
  if (!is_text(line)) return "that is no text";
  if (type.is(Type::Kind::Enum)) {
    return fmt::format("'{}' is none of {}", shortened(line), fmt::join(type.detail->names, ", "));
  }
  const std::string example = type.is(Type::Kind::Int)    ? "7"
                              : type.is(Type::Kind::Real) ? example_of(type.dimension)
                                                          : "TRUE";
  return fmt::format("'{}' is not {}, such as {}", shortened(line), in_words(type), example);
}

}  // namespace

Reply Question::ask(Machine& machine, int line, std::string text, const Type& type, Slot* numbers,
                    std::string* texts, std::size_t index) {
  if (!misread_.empty()) text = fmt::format("{}; {}", misread_, text);
  std::optional<std::string> answer;
  const Reply reply = machine.ask(line, text, answer);
  if (reply == Reply::Later) return reply;
  forget();
  if (reply == Reply::Refused || !answer) return reply;
  const bool read = type.is(Type::Kind::String) ? read_answer(*answer, texts[index])
                                                : read_answer(*answer, type, numbers[index]);
  if (read) return Reply::Done;
  misread_ = misread_answer(*answer, type);
  return Reply::Later;
}

}  // namespace rob::lang
