#include "lang/syntax/lexer.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <utility>

#include <fmt/format.h>

#include "lang/text/ascii.h"
#include "lang/text/codes.h"
#include "lang/text/suggest.h"
#include "lang/text/utf8.h"
#include "lang/values/units.h"

namespace rob::lang {

namespace {

/// Signs, longer ones before those they begin with, otherwise frequent ones first.
constexpr auto kSigns = std::to_array<std::pair<std::string_view, TokenKind>>({
    {"..", TokenKind::Range},        {"+=", TokenKind::PlusAssign},  {"-=", TokenKind::MinusAssign},
    {"*=", TokenKind::StarAssign},   {"/=", TokenKind::SlashAssign}, {",", TokenKind::Comma},
    {"(", TokenKind::LeftParen},     {")", TokenKind::RightParen},   {"+", TokenKind::Plus},
    {"-", TokenKind::Minus},         {"*", TokenKind::Star},         {"/", TokenKind::Slash},
    {"==", TokenKind::Equal},        {"<>", TokenKind::NotEqual},    {"<=", TokenKind::LessEqual},
    {">=", TokenKind::GreaterEqual}, {"=", TokenKind::Assign},       {"<", TokenKind::Less},
    {">", TokenKind::Greater},       {":", TokenKind::Colon},        {".", TokenKind::Dot},
    {"[", TokenKind::LeftBracket},   {"]", TokenKind::RightBracket}, {"^", TokenKind::Caret},
    {"%", TokenKind::Percent},
});

struct ForeignSign {
  std::string_view sign;
  std::string_view ours;
  TokenKind kind;
  Keyword keyword{};
};

/// Words of other languages that people may write, and their names here.
constexpr auto kForeignSigns = std::to_array<ForeignSign>({
    {"!=", "<>", TokenKind::NotEqual},
    {":=", "=", TokenKind::Assign},
    {"&&", "AND", TokenKind::Reserved, Keyword::And},
    {"||", "OR", TokenKind::Reserved, Keyword::Or},
    {"!", "NOT", TokenKind::Reserved, Keyword::Not},
    {"**", "^", TokenKind::Caret},
    {"\u2212", "-", TokenKind::Minus},
    {"\u00D7", "*", TokenKind::Star},
    {"\u00B7", "*", TokenKind::Star},
    {"\u2264", "<=", TokenKind::LessEqual},
    {"\u2265", ">=", TokenKind::GreaterEqual},
    {"\u2260", "<>", TokenKind::NotEqual},
});

/// Signs with no meaning here, and what to do about them.
constexpr auto kRemedies = std::to_array<std::pair<std::string_view, std::string_view>>({
    {";", "a statement ends with its line"},
    {"#", "a comment begins with //"},
    {"'", "a text stands between double quotes: \"text\""},
    {"\u201C", "a text stands between plain double quotes: \"text\""},
    {"\u201D", "a text stands between plain double quotes: \"text\""},
    {"\u201E", "a text stands between plain double quotes: \"text\""},
    {"{", "blocks are IF … ENDIF, WHILE … ENDWHILE, FOR … ENDFOR"},
    {"}", "blocks are IF … ENDIF, WHILE … ENDWHILE, FOR … ENDFOR"},
    {"\u00A0", "this is a no-break space; type a plain one"},
    {"\u00B0", "degrees are written 90deg"},
});

/// The unit that was meant by one that is none. Capital letters are a likely mistake.
std::string unit_help(std::string_view unit) {
  if (unit.starts_with("\u00B0")) return "degrees are written 90deg";
  if (unit.starts_with("\u00B5") || unit.starts_with("\u03BC")) {
    return "micrometres are written 5um";
  }
  return did_you_mean(suggest(unit, unit_names()));
}

}  // namespace

Lexer::Lexer(std::string_view source, Diagnostics& diagnostics, std::uint32_t file, TextParts parts)
    : source_(source), diagnostics_(&diagnostics), count_(parts), file_(file) {
  if (source.starts_with(kByteOrderMark)) offset_ = begin_ = kByteOrderMark.size();
}

void Lexer::begin_at(std::size_t offset, const Place& place) {
  offset_ = begin_ = offset;
  count_ = LineCount::at(place.line);
  begin_column_ = place.column;
}

void Lexer::skip_to(std::size_t offset) {
  offset_ = offset;
  at_line_begin_ = false;
}

Lexer Lexer::quiet_copy() const {
  Lexer copy = *this;
  copy.diagnostics_ = nullptr;
  return copy;
}

bool Lexer::only_blanks_left() const {
  Lexer copy = quiet_copy();
  copy.skip_blanks();
  copy.skip_line_ends();
  return copy.offset_ >= source_.size();
}

char Lexer::at(std::size_t ahead) const {
  return offset_ + ahead < source_.size() ? source_[offset_ + ahead] : '\0';
}

/// Blanks and a comment up to the end of the line.
void Lexer::skip_blanks() {
  while (at() == ' ' || at() == '\t') ++offset_;
  while (at() == '/' && at(1) == '*') {
    skip_foreign_comment();
    while (at() == ' ' || at() == '\t') ++offset_;
  }
  if (source_.substr(offset_).starts_with("//")) {
    while (offset_ < source_.size() && at() != '\n' && at() != '\r') ++offset_;
  }
}

/// A comment of other languages, up to its end, which may stand some lines on.
void Lexer::skip_foreign_comment() {
  begin_token();
  offset_ += 2;
  report(code::kForeignComment, begin_, "'/*' begins no comment in Rob",
         "a comment begins with // and ends with its line");
  while (offset_ < source_.size() && !(at() == '*' && at(1) == '/')) {
    if (at() == '\n') {
      begin_ = offset_ + 1;
      count_.next(begin_);
      begin_column_ = 1;
    }
    ++offset_;
  }
  offset_ = std::min(offset_ + 2, source_.size());
}

/// Line ends and what is blank between them; false if there is none.
bool Lexer::skip_line_ends() {
  const std::uint32_t before = count_.line();
  while (at() == '\n' || at() == '\r') {
    if (at() == '\n') {
      begin_ = offset_ + 1;
      count_.next(begin_);
      begin_column_ = 1;
    }
    ++offset_;
    skip_blanks();
  }
  return count_.line() != before;
}

Token Lexer::next() {
  skip_blanks();
  if (at_line_begin_) {
    skip_line_ends();
  } else if (at() == '\n' || at() == '\r' || offset_ >= source_.size()) {
    begin_token();
    Token token = finish(TokenKind::EndOfLine);
    skip_line_ends();
    at_line_begin_ = true;
    return token;
  }
  begin_token();
  if (offset_ >= source_.size()) return finish(TokenKind::EndOfFile);
  Token token = read();
  token.first_on_line = at_line_begin_;
  at_line_begin_ = false;
  return token;
}

Token Lexer::read() {
  const char c = at();
  if (begins_word(c)) return word();
  if (is_digit(c) || (c == '.' && is_digit(at(1)))) return number();
  if (c == '"') return string();
  return sign();
}

Token Lexer::word() {
  skip_word();
  Token token = finish(TokenKind::Word);
  if (const auto keyword = find_keyword(token.text)) {
    token.kind = TokenKind::Reserved;
    token.keyword = *keyword;
  }
  return token;
}

// -------------------------------------------------------------------- numbers

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
  if (at() == '0' && to_upper(at(1)) == 'X' && in_word(at(2))) return hexadecimal();
  if (at() == '0' && to_upper(at(1)) == 'B' && in_word(at(2))) {
    skip_word();
    return bad(code::kMalformedNumber, "numbers are written in decimal or hexadecimal digits",
               "0xFF is 255");
  }
  scan_number();
  const std::string_view digits = source_.substr(begin_, offset_ - begin_);
  const bool whole = digits.find_first_of(".eE") == std::string_view::npos;
  if (at() == '.' && at(1) != '.') return stray_point(digits, whole);
  const bool ends = !in_word(at()) && at() != '%' && static_cast<unsigned char>(at()) < 0x80;
  return ends ? plain_number(digits, whole) : quantity(digits);
}

/// 0xFF: an INT of at most 63 bits.
Token Lexer::hexadecimal() {
  skip_word();
  const std::string_view digits = source_.substr(begin_ + 2, offset_ - begin_ - 2);
  std::uint64_t size = 0;
  const auto result = std::from_chars(digits.data(), digits.data() + digits.size(), size, 16);
  if (result.ptr != digits.data() + digits.size()) {
    return bad(code::kMalformedNumber, "hexadecimal digits are 0 to 9 and A to F",
               "a hexadecimal number has no unit and no point");
  }
  if (result.ec != std::errc{} || size > static_cast<std::uint64_t>(INT64_MAX)) {
    return too_large("hexadecimal numbers go up to 0x7FFFFFFFFFFFFFFF");
  }
  Token token = finish(TokenKind::Number);
  token.number.integer = static_cast<std::int64_t>(size);
  token.number.value = static_cast<double>(size);
  token.number.is_integer = true;
  return token;
}

/// A point after the digits of a number that does not go on with digits: `5.`, `1.5.2`, `1e3.`.
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
  const auto value = quantity_of(digits, Unit{});
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
  const auto value = quantity_of(digits, match->unit);
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
         fmt::format("'{}' after {} is no unit", shortened(unit), shortened(digits)),
         unit_help(unit));
  return finish(TokenKind::Bad);
}

// ---------------------------------------------------------------------- texts

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
               R"(there are \" \\ \n \r \t and \u{20AC} with one to six hexadecimal digits)");
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
  constexpr auto kEscapes = std::to_array<std::pair<char, char>>(
      {{'"', '"'}, {'\\', '\\'}, {'n', '\n'}, {'r', '\r'}, {'t', '\t'}});
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

// ---------------------------------------------------------------------- signs

Token Lexer::sign() {
  const std::string_view rest = source_.substr(offset_);
  for (const ForeignSign& foreign : kForeignSigns) {
    if (rest.front() != foreign.sign.front() || !rest.starts_with(foreign.sign)) continue;
    offset_ += foreign.sign.size();
    report(code::kForeignOperator, begin_, fmt::format("'{}' is no operator of Rob", foreign.sign),
           fmt::format("write {}", foreign.ours));
    Token token = finish(foreign.kind);
    token.keyword = foreign.keyword;
    return token;
  }
  for (const auto& [text, kind] : kSigns) {
    if (!rest.starts_with(text)) continue;
    offset_ += text.size();
    return finish(kind);
  }
  return unknown_sign();
}

Token Lexer::unknown_sign() {
  const CodePoint c = decode_utf8(source_.substr(offset_));
  const std::string_view text = source_.substr(offset_, c.length);
  const auto number = static_cast<unsigned>(c.value);
  offset_ += c.length;
  for (const auto& [sign, help] : kRemedies) {
    if (text == sign) {
      return bad(code::kUnknownCharacter, fmt::format("'{}' is no sign of Rob", text),
                 std::string(help));
    }
  }
  if (c.value > 0x20 && c.value < 0x7F) {
    return bad(code::kUnknownCharacter, fmt::format("'{}' is no sign of Rob", text));
  }
  return bad(code::kUnknownCharacter,
             fmt::format("the character U+{:04X} can stand in texts and comments only", number),
             "names are made of the letters A to Z, digits and _");
}

// --------------------------------------------------------------------- places

void Lexer::skip_word() {
  while (in_word(at())) ++offset_;
}

void Lexer::begin_token() {
  begin_column_ += count_code_points(source_.substr(begin_, offset_ - begin_));
  begin_ = offset_;
}

/// The place of bytes from the token's beginning on, in characters.
Place Lexer::place(std::size_t begin, std::size_t end) const {
  const std::uint32_t before = count_code_points(source_.substr(begin_, begin - begin_));
  const std::uint32_t length = count_code_points(source_.substr(begin, end - begin));
  return {count_.line(), begin_column_ + before, length, file_};
}

Token Lexer::finish(TokenKind kind) {
  Token token;
  token.kind = kind;
  token.offset = begin_;
  token.text = source_.substr(begin_, offset_ - begin_);
  token.place = place(begin_, offset_);
  return token;
}

Token Lexer::bad(std::string_view code, std::string message, std::string help) {
  report(code, begin_, std::move(message), std::move(help));
  return finish(TokenKind::Bad);
}

/// Reports about the source from `begin` to what has been read.
void Lexer::report(std::string_view code, std::size_t begin, std::string message,
                   std::string help) {
  if (diagnostics_ == nullptr || muted_) return;
  diagnostics_->error(code, place(begin, offset_), std::move(message), std::move(help));
}

}  // namespace rob::lang
