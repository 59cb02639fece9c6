#include "lang/syntax/lexer.h"

#include <array>
#include <utility>

#include <fmt/format.h>

#include "lang/text/ascii.h"
#include "lang/text/codes.h"
#include "lang/text/utf8.h"

namespace rob::lang {

namespace {

/// Signs, longer ones before those they begin with, otherwise frequent ones first.
constexpr auto kSigns = std::to_array<std::pair<std::string_view, TokenKind>>({
    {",", TokenKind::Comma},      {"(", TokenKind::LeftParen},     {")", TokenKind::RightParen},
    {"+", TokenKind::Plus},       {"-", TokenKind::Minus},         {"*", TokenKind::Star},
    {"/", TokenKind::Slash},      {"==", TokenKind::Equal},        {"<>", TokenKind::NotEqual},
    {"<=", TokenKind::LessEqual}, {">=", TokenKind::GreaterEqual}, {"=", TokenKind::Assign},
    {"<", TokenKind::Less},       {">", TokenKind::Greater},       {":", TokenKind::Colon},
    {".", TokenKind::Dot},        {"[", TokenKind::LeftBracket},   {"]", TokenKind::RightBracket},
    {"^", TokenKind::Caret},      {"%", TokenKind::Percent},
});

struct ForeignSign {
  std::string_view sign;
  std::string_view ours;
  TokenKind kind;
  Keyword keyword{};
};

/// What people write who come from other languages, and what it is called here.
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
  if (source_.substr(offset_).starts_with("//")) {
    while (offset_ < source_.size() && at() != '\n' && at() != '\r') ++offset_;
  }
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
  if (diagnostics_ == nullptr) return;
  diagnostics_->error(code, place(begin, offset_), std::move(message), std::move(help));
}

}  // namespace rob::lang
