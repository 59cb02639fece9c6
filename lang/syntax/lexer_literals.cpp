#include <array>
#include <charconv>
#include <cstdint>
#include <utility>

#include <fmt/format.h>

#include "lang/syntax/lexer.h"
#include "lang/text/ascii.h"
#include "lang/text/codes.h"
#include "lang/text/suggest.h"
#include "lang/text/utf8.h"
#include "lang/values/units.h"

/// The lexer's part for numbers, quantities and texts.
namespace rob::lang {

namespace {

/// What was meant by a unit that is none. Capital letters are a likely mistake.
std::string unit_help(std::string_view unit) {
  if (unit.starts_with("\u00B0")) return "degrees are written 90deg";
  if (unit.starts_with("\u00B5") || unit.starts_with("\u03BC"))
    return "micrometres are written 5um";
  return did_you_mean(suggest(unit, unit_names()));
}

}  // namespace

void Lexer::scan_digits() {
  while (is_digit(at())) ++offset_;
}

/// digits [ "." digits ] [ "e" [ sign ] digits ]
void Lexer::scan_number() {
  scan_digits();
  if (at() == '.' && is_digit(at(1))) {
    ++offset_;
    scan_digits();
  }
  const bool exponent = at() == 'e' || at() == 'E';
  const std::size_t sign = at(1) == '+' || at(1) == '-' ? 1 : 0;
  if (exponent && is_digit(at(1 + sign))) {
    offset_ += 1 + sign;
    scan_digits();
  }
}

Token Lexer::number() {
  if (at() == '.') {
    ++offset_;
    scan_number();
    const std::string digits = shortened(source_.substr(begin_, offset_ - begin_));
    skip_word();
    return bad(code::kMalformedNumber, "a number begins with a digit",
               fmt::format("write 0{}", digits));
  }
  if (at() == '0' && (to_upper(at(1)) == 'X' || to_upper(at(1)) == 'B') && in_word(at(2))) {
    skip_word();
    return bad(code::kMalformedNumber, "numbers are written in decimal digits");
  }
  scan_number();
  const std::string_view digits = source_.substr(begin_, offset_ - begin_);
  const bool whole = digits.find_first_of(".eE") == std::string_view::npos;
  if (at() == '.') return stray_point(digits, whole);
  const bool ends = !in_word(at()) && at() != '%' && static_cast<unsigned char>(at()) < 0x80;
  return ends ? plain_number(digits, whole) : quantity(digits);
}

/// A point behind the digits of a number that does not go on with digits: `5.`, `1.5.2`, `1e3.`.
Token Lexer::stray_point(std::string_view digits, bool whole) {
  ++offset_;
  skip_word();
  const std::string number = shortened(digits);
  if (!whole) {
    return bad(code::kMalformedNumber, "the number has ended before this point",
               fmt::format("write {}", number));
  }
  return bad(code::kMalformedNumber, "digits follow the point of a number",
             fmt::format("write {0} or {0}.0", number));
}

Token Lexer::too_large(std::string help) {
  return bad(code::kNumberTooLarge, "the number is too large", std::move(help));
}

Token Lexer::plain_number(std::string_view digits, bool whole) {
  Token token = finish(TokenKind::Number);
  const auto value = to_si(digits, Unit{});
  if (!value) return too_large("a REAL goes up to 1.7976931348623157e308");
  token.number.value = *value;
  token.number.is_integer = whole;
  if (whole) {
    constexpr std::uint64_t kBehindLast = std::uint64_t{1} << 63U;
    std::uint64_t size = 0;
    const auto result = std::from_chars(digits.data(), digits.data() + digits.size(), size);
    if (result.ec != std::errc{} || size > kBehindLast) return too_large(kLargestInt);
    token.number.integer = static_cast<std::int64_t>(size);  // the least one for kBehindLast
  }
  return token;
}

/// A number directly followed by what should be a unit.
Token Lexer::quantity(std::string_view digits) {
  const auto match = match_unit(source_.substr(offset_));
  if (!match) return unknown_unit(digits);
  offset_ += match->length;
  Token token = finish(TokenKind::Number);
  token.has_unit = true;
  const auto value = to_si(digits, match->unit);
  if (!value) return too_large("");
  token.number.value = *value;
  token.number.dimension = match->unit.dimension;
  token.number.has_unit = true;
  return token;
}

Token Lexer::unknown_unit(std::string_view digits) {
  const std::size_t unit_begin = offset_;
  if (at() == '%') ++offset_;
  if (static_cast<unsigned char>(at()) >= 0x80) {
    offset_ += decode_utf8(source_.substr(offset_)).length;
  }
  skip_word();
  const std::string_view unit = source_.substr(unit_begin, offset_ - unit_begin);
  if (unit.starts_with('_')) {
    return bad(code::kMalformedNumber, "the digits of a number are not grouped");
  }
  report(code::kUnknownUnit, unit_begin,
         fmt::format("'{}' behind {} is no unit", shortened(unit), shortened(digits)),
         unit_help(unit));
  return finish(TokenKind::Bad);
}

Token Lexer::string() {
  ++offset_;
  std::string text;
  bool sound = true;
  while (at() != '"') {
    if (offset_ >= source_.size() || at() == '\n' || at() == '\r') {
      return bad(code::kUnclosedString, "the text is not closed on its line",
                 "a text ends with \"; a quote inside it is written \\\"");
    }
    if (at() != '\\') {
      text += at();
      ++offset_;
    } else {
      const std::size_t begin = offset_;
      if (!escape(text) && std::exchange(sound, false)) {
        report(code::kUnknownEscape, begin, "this escape is unknown",
               R"(there are \" \\ \n \t and \u{20AC} with one to six hexadecimal digits)");
      }
    }
  }
  ++offset_;
  Token token = finish(TokenKind::String);
  token.string = std::move(text);
  return token;
}

/// A backslash and what belongs to it; false if it means nothing.
bool Lexer::escape(std::string& text) {
  constexpr auto kEscapes =
      std::to_array<std::pair<char, char>>({{'"', '"'}, {'\\', '\\'}, {'n', '\n'}, {'t', '\t'}});
  const char letter = at(1);
  if (letter == 'u' && at(2) == '{') return unicode_escape(text);
  for (const auto& [written, meant] : kEscapes) {
    if (letter != written) continue;
    offset_ += 2;
    text += meant;
    return true;
  }
  ++offset_;
  return false;
}

bool Lexer::unicode_escape(std::string& text) {
  offset_ += 3;
  std::uint32_t value = 0;
  const char* const first = source_.data() + offset_;
  const char* const last = source_.data() + source_.size();
  const auto [stop, error] = std::from_chars(first, last, value, 16);
  if (error == std::errc{}) offset_ += static_cast<std::size_t>(stop - first);
  if (error != std::errc{} || at() != '}' || stop - first > 6) return false;
  ++offset_;
  const bool surrogate = value >= 0xD800 && value <= 0xDFFF;
  if (value == 0 || value > 0x10FFFF || surrogate) return false;
  append_utf8(text, value);
  return true;
}

}  // namespace rob::lang
