#include "lang/syntax/lexer.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "lang/text/source_text.h"

using namespace rob::lang;

namespace {

struct Lexed {
  std::vector<Token> tokens;  ///< without the last EndOfLine and EndOfFile
  Diagnostics diagnostics;

  const Diagnostic& only() const {
    REQUIRE(diagnostics.all().size() == 1);
    return diagnostics.all().front();
  }
};

Lexed lex(std::string_view source) {
  Lexed lexed;
  Lexer lexer(source, lexed.diagnostics);
  for (Token token = lexer.next(); token.kind != TokenKind::EndOfFile; token = lexer.next()) {
    lexed.tokens.push_back(token);
  }
  if (!lexed.tokens.empty()) {
    REQUIRE(lexed.tokens.back().kind == TokenKind::EndOfLine);
    lexed.tokens.pop_back();
  }
  return lexed;
}

Token one(std::string_view source) {
  const Lexed lexed = lex(source);
  REQUIRE(lexed.tokens.size() == 1);
  REQUIRE_FALSE(lexed.diagnostics.has_errors());
  return lexed.tokens.front();
}

std::vector<TokenKind> kinds(std::string_view source) {
  std::vector<TokenKind> result;
  for (const Token& token : lex(source).tokens) result.push_back(token.kind);
  return result;
}

Diagnostic unreadable(std::string_view source) {
  Diagnostics diagnostics;
  CHECK_FALSE(check_source(source, diagnostics));
  REQUIRE(diagnostics.all().size() == 1);
  return diagnostics.all().front();
}

bool readable(std::string_view source) {
  Diagnostics diagnostics;
  return check_source(source, diagnostics) && diagnostics.all().empty();
}

using K = TokenKind;

}  // namespace

TEST_CASE("a MOVE is cut into its words and signs") {
  CHECK(kinds("MOVE(140, , )") ==
        std::vector{K::Reserved, K::LeftParen, K::Number, K::Comma, K::Comma, K::RightParen});
  CHECK(kinds("a<=b<>c==d>=e<f>g") == std::vector{K::Word, K::LessEqual, K::Word, K::NotEqual,
                                                  K::Word, K::Equal, K::Word, K::GreaterEqual,
                                                  K::Word, K::Less, K::Word, K::Greater, K::Word});
  CHECK(kinds("p.x[1]^2*3/4-5+6:7=8%") ==
        std::vector{K::Word,         K::Dot,    K::Word,   K::LeftBracket, K::Number,
                    K::RightBracket, K::Caret,  K::Number, K::Star,        K::Number,
                    K::Slash,        K::Number, K::Minus,  K::Number,      K::Plus,
                    K::Number,       K::Colon,  K::Number, K::Assign,      K::Number});
}

TEST_CASE("keywords are the same in capital and small letters") {
  for (const char* text : {"MOVE", "move", "Move"}) {
    const Token token = one(text);
    CHECK(token.kind == K::Reserved);
    CHECK(token.keyword == Keyword::Move);
  }
  CHECK(one("moves").keyword == Keyword::Moves);
  CHECK(one("mover").kind == K::Word);
  CHECK(one("AT").kind == K::Word);  // clause words stay usable as names
}

TEST_CASE("comments, blanks and empty lines leave no token but one line end") {
  CHECK(kinds("// a comment\n\n  STOP // here\n\n\t// there\nEND") ==
        std::vector{K::Reserved, K::EndOfLine, K::Reserved});
  CHECK(kinds("").empty());
  CHECK(kinds("   // nothing").empty());
}

TEST_CASE("line ends are LF or CR LF, and the last one may be missing") {
  const auto expected = std::vector{K::Reserved, K::EndOfLine, K::Reserved};
  CHECK(kinds("STOP\nEND\n") == expected);
  CHECK(kinds("STOP\r\nEND\r\n") == expected);
  CHECK(kinds("STOP\r\nEND") == expected);
  CHECK(kinds("\xEF\xBB\xBFSTOP\nEND") == expected);
}

TEST_CASE("a place counts characters, from 1, behind a byte order mark and across CR LF") {
  const Lexed lexed = lex("\xEF\xBB\xBFSTOP\r\n  x = \"äö\" yy\n");
  REQUIRE(lexed.tokens.size() == 6);
  CHECK(lexed.tokens[0].place == Place{1, 1, 4});
  CHECK(lexed.tokens[1].place == Place{1, 5, 0});
  CHECK(lexed.tokens[2].place == Place{2, 3, 1});
  CHECK(lexed.tokens[4].place == Place{2, 7, 4});
  CHECK(lexed.tokens[5].place == Place{2, 12, 2});
}

TEST_CASE("the first token of a line knows that it is one") {
  const Lexed lexed = lex("a b\n  c d");
  REQUIRE(lexed.tokens.size() == 5);
  CHECK(lexed.tokens[0].first_on_line);
  CHECK_FALSE(lexed.tokens[1].first_on_line);
  CHECK(lexed.tokens[3].first_on_line);
  CHECK_FALSE(lexed.tokens[4].first_on_line);
}

TEST_CASE("a number without point and exponent is an INT, any other a REAL") {
  const Token whole = one("140");
  CHECK(whole.number.is_integer);
  CHECK(whole.number.integer == 140);
  CHECK(whole.number.value == 140);
  for (const auto& [text, value] : {std::pair{"0.5", 0.5},
                                    {"1e3", 1000.0},
                                    {"2E-2", 0.02},
                                    {"1.5e+2", 150.0},
                                    {"007.0", 7.0}}) {
    const Token real = one(text);
    CHECK_FALSE(real.number.is_integer);
    CHECK(real.number.value == value);
    CHECK(real.number.dimension == kNone);
  }
  CHECK(one("9223372036854775807").number.integer == INT64_MAX);
}

TEST_CASE("a quantity is a number with its unit, in mm and deg") {
  const Token length = one("9mm");
  CHECK(length.number.value == 9);
  CHECK(length.number.dimension == kLength);
  CHECK_FALSE(length.number.is_integer);
  CHECK(length.has_unit);
  CHECK(one("50mm/s").number.dimension == kSpeed);
  CHECK(one("2m/s^2").number.dimension == kAcceleration);
  CHECK(one("50%").number.value == 0.5);
  CHECK(one("1e-6mm").number.value == 1e-6);
  CHECK(one("3in").number.dimension == kLength);  // a unit, though IN is reserved
}

TEST_CASE("a unit with a blank before it is a word of its own") {
  CHECK(kinds("50mm / s") == std::vector{K::Number, K::Slash, K::Word});
  CHECK(kinds("50mm/speed") == std::vector{K::Number, K::Slash, K::Word});
  CHECK(kinds("10 mm") == std::vector{K::Number, K::Word});
}

TEST_CASE("an unknown unit is shown with the one that was meant") {
  const Diagnostic wrong = lex("x = 5mmm").only();
  CHECK(wrong.code == "E111");
  CHECK(wrong.place == Place{1, 6, 3});
  CHECK(wrong.help == "did you mean mm?");
  CHECK(lex("90\u00B0").only().help == "degrees are written 90deg");
  CHECK(lex("5\u00B5m").only().help == "micrometres are written 5um");
}

TEST_CASE("a number too large for its type is refused") {
  CHECK(lex("1e400").only().code == "E110");
  CHECK(lex("9223372036854775809").only().code == "E110");
  CHECK(lex("1e308kN").only().code == "E110");
  CHECK(one("9223372036854775808.0").number.value == 9223372036854775808.0);
}

TEST_CASE("hexadecimal numbers are INTs of 63 bits at most") {
  CHECK(one("0xFF").number.integer == 255);
  CHECK(one("0XaB").number.integer == 171);
  CHECK(one("0x10").number.is_integer);
  CHECK(one("0x7FFFFFFFFFFFFFFF").number.integer == INT64_MAX);
  CHECK(lex("0x8000000000000000").only().code == "E110");
  CHECK(lex("0xFFmm").only().code == "E109");
}

TEST_CASE("binary digits, bare points and grouped digits are refused") {
  CHECK(lex("0x1G").only().message == "hexadecimal digits are 0 to 9 and A to F");
  CHECK(lex("0b101").only().message == "numbers are written in decimal or hexadecimal digits");
  CHECK(lex(".5").only().help == "write 0.5");
  CHECK(lex("5.").only().help == "write 5 or 5.0");
  CHECK(lex("1.5.").only().help == "write 1.5");
  CHECK(lex("1e3.").only().help == "write 1e3");
  CHECK(lex("1_000").only().code == "E109");
}

TEST_CASE("a text may hold quotes, line feeds and any character") {
  CHECK(one("\"\"").string.empty());
  CHECK(one(R"("a \"b\" \\ \n \t \u{20AC} \u{1F916} ä")").string ==
        "a \"b\" \\ \n \t \u20AC \U0001F916 ä");
  CHECK(one("\"// no comment\"").string == "// no comment");
}

TEST_CASE("a text must be closed on its line") {
  const Lexed lexed = lex("PRINT \"abc\nSTOP");
  CHECK(lexed.only().code == "E107");
  CHECK(lexed.only().place == Place{1, 7, 4});
  CHECK(lexed.tokens.back().keyword == Keyword::Stop);
}

TEST_CASE("an unknown escape is named once a text") {
  for (const char* text : {R"("\q")", R"("\u{110000}")", R"("\u{D800}")", R"("\u{}")", R"("\u{0}")",
                           R"("\u41")", R"("\u{1234567}")", R"("\a \b \c")"}) {
    CAPTURE(text);
    const Diagnostic wrong = lex(text).only();
    CHECK(wrong.code == "E108");
    CHECK(wrong.place.column == 2);
  }
}

TEST_CASE("operators of other languages are reported and read as ours") {
  const Lexed lexed = lex("a != b && !c || d := e ** 2");
  CHECK(lexed.diagnostics.error_count() == 6);
  std::vector<TokenKind> found;
  for (const Token& token : lexed.tokens) found.push_back(token.kind);
  CHECK(found == std::vector{K::Word, K::NotEqual, K::Word, K::Reserved, K::Reserved, K::Word,
                             K::Reserved, K::Word, K::Assign, K::Word, K::Caret, K::Number});
  CHECK(lexed.tokens[3].keyword == Keyword::And);
  CHECK(lexed.diagnostics.all()[0].help == "write <>");
}

TEST_CASE("a sign that Rob does not use is named, with the remedy") {
  CHECK(lex("STOP;").only().help == "a statement ends with its line");
  CHECK(lex("# STOP").diagnostics.all()[0].help == "a comment begins with //");
  CHECK(lex("\u20AC").only().message ==
        "the character U+20AC can stand in texts and comments only");
  CHECK(lex("\x01").only().message == "the character U+0001 can stand in texts and comments only");
}

TEST_CASE("a quiet copy goes on by itself and reports nothing") {
  Diagnostics diagnostics;
  Lexer lexer("a 5q b", diagnostics);
  lexer.next();
  Lexer ahead = lexer.quiet_copy();
  CHECK(ahead.next().kind == K::Bad);
  CHECK_FALSE(diagnostics.has_errors());
  CHECK(lexer.next().kind == K::Bad);
  CHECK(diagnostics.error_count() == 1);
}

TEST_CASE("a NUL byte is named with its offset") {
  const Diagnostic wrong = unreadable(std::string_view("STOP\n\0END", 9));
  CHECK(wrong.code == "E103");
  CHECK(wrong.message == "byte 5 is NUL: this is not a text file");
  CHECK(wrong.place == Place{2, 1, 1});
}

TEST_CASE("bytes that are no UTF-8 are named with the offset of the first") {
  CHECK(unreadable("// \xE4\xF6\nSTOP").message == "byte 3 is not valid UTF-8 (and 1 more)");
  CHECK(unreadable("\xC0\x80").code == "E104");          // overlong
  CHECK(unreadable("\xED\xA0\x80").code == "E104");      // a surrogate
  CHECK(unreadable("\xF4\x90\x80\x80").code == "E104");  // beyond U+10FFFF
  CHECK(unreadable("ab\xE2\x82").message == "byte 2 is not valid UTF-8 (and 1 more)");
  CHECK(readable("// \u00E4 \u20AC \U0010FFFF"));
}

TEST_CASE("a carriage return alone is named with its offset") {
  CHECK(unreadable("STOP\rEND").message == "byte 4 is a carriage return without a line feed");
  CHECK(unreadable("STOP\r").code == "E105");
  CHECK(readable("STOP\r\nEND\r\n"));
}

TEST_CASE("a line may be 65536 bytes long and a file 64 MiB, no more") {
  const std::string longest(kMaxLineBytes, ' ');
  CHECK(readable("STOP\n" + longest + "\nSTOP"));
  const Diagnostic too_long = unreadable("STOP\n" + longest + " \nSTOP");
  CHECK(too_long.code == "E102");
  CHECK(too_long.message == "the line is too long: more than 65536 bytes");
  CHECK(too_long.place.line == 2);
  std::string file;
  while (file.size() < kMaxSourceBytes) file += longest.substr(1) + "\n";
  CHECK(readable(file));
  CHECK(unreadable(file + "\n").code == "E101");
}
