#include "lang/text/diagnostic.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>
#include <string>

#include "lang/text/codes.h"

using namespace rob::lang;

namespace {

Diagnostic error_at(std::uint32_t line, std::uint32_t column, std::uint32_t length = 1) {
  return {Severity::Error, "E101", {line, column, length}, "message", ""};
}

/// The three lines that a rendered diagnostic without help has.
struct Rendered {
  std::string head, source, caret;
};
Rendered rendered(const Diagnostic& diagnostic, std::string_view source) {
  const std::string text = render(diagnostic, "f.rob", source);
  const std::size_t first = text.find('\n');
  const std::size_t second = text.find('\n', first + 1);
  REQUIRE(second != std::string::npos);
  REQUIRE(text.back() == '\n');
  return {text.substr(0, first), text.substr(first + 1, second - first - 1),
          text.substr(second + 1, text.size() - second - 2)};
}

}  // namespace

TEST_CASE("a message shows the place, the line, the caret and the remedy") {
  const Diagnostic diagnostic{
      Severity::Error, "E120", {2, 1, 3}, "'MOV' is no statement", "did you mean MOVE?"};
  CHECK(render(diagnostic, "square.rob", "STOP\nMOV(1,2,3)\n") ==
        "square.rob:2:1: error[E120]: 'MOV' is no statement\n"
        "  MOV(1,2,3)\n"
        "  ^^^\n"
        "help: did you mean MOVE?\n");
}

TEST_CASE("a warning is called one, and a message about the whole file has no line") {
  const Diagnostic diagnostic{Severity::Warning, "W501", {0, 0, 1}, "no statement", ""};
  CHECK(render(diagnostic, "a.rob", "// nothing\n") == "a.rob: warning[W501]: no statement\n");
}

TEST_CASE("without its source a message is its first line and the help") {
  Diagnostic diagnostic = error_at(3, 7);
  diagnostic.help = "mend it";
  CHECK(render(diagnostic, "a.rob", "") == "a.rob:3:7: error[E101]: message\nhelp: mend it\n");
}

TEST_CASE("the caret stands under the character of the column, however many bytes it has") {
  const Rendered text = rendered(error_at(1, 8, 2), "x = \"äö\" 40");
  CHECK(text.source == "  x = \"äö\" 40");
  CHECK(text.caret == "         ^^");
}

TEST_CASE("the caret may stand behind the last character") {
  const Rendered text = rendered(error_at(1, 12), "MOVE(140,40\r\nSTOP");
  CHECK(text.source == "  MOVE(140,40");
  CHECK(text.caret == "             ^");
}

TEST_CASE("a byte order mark is not shown and not counted") {
  const Rendered text = rendered(error_at(1, 1, 4), "\xEF\xBB\xBFMOVE");
  CHECK(text.source == "  MOVE");
  CHECK(text.caret == "  ^^^^");
}

TEST_CASE("nothing in a source line can move the cursor of a terminal") {
  const Rendered text = rendered(error_at(1, 6),
                                 "a\tb\x1B[\x7F\xC2\x9B"
                                 "c");
  CHECK(text.source == "  a b\\u{1B}[\\u{7F}\\u{9B}c");
  CHECK(text.caret == "            ^^^^^^");  // under the DEL, which is shown as six characters
}

TEST_CASE("the caret stands under its character behind others that are shown as several") {
  const Rendered text = rendered(error_at(1, 4, 2), "\x1B\xE2\x80\xAE\"x\" + y");
  CHECK(text.source == "  \\u{1B}\\u{202E}\"x\" + y");
  CHECK(text.caret == "                 ^^");
}

TEST_CASE("bytes that are no UTF-8 are shown as numbers") {
  CHECK(rendered(error_at(1, 1),
                 "a\xE4"
                 "b")
            .source == "  a\\xE4b");
  CHECK(rendered(error_at(1, 1), "a\xC3").source == "  a\\xC3");
}

TEST_CASE("of a long line at most 200 bytes around the place are shown, in whole characters") {
  std::string line;
  for (int i = 0; i < 1000; ++i) line += "ä";  // two bytes each
  line += "!";
  for (int i = 0; i < 1000; ++i) line += "€";  // three bytes each
  const Rendered text = rendered(error_at(1, 1001), line);
  CHECK(text.source.size() - 2 <= 200);
  CHECK(text.source.size() - 2 >= 195);
  const std::size_t mark = text.source.find('!');
  REQUIRE(mark != std::string::npos);
  const auto characters =
      std::ranges::count_if(text.source.substr(0, mark), [](char c) { return (c & 0xC0) != 0x80; });
  CHECK(text.caret == std::string(static_cast<std::size_t>(characters), ' ') + "^");
  CHECK(text.source.find('?') == std::string::npos);
}

TEST_CASE("the carets do not run out of the part that is shown") {
  const Rendered text = rendered(error_at(1, 1, 5000), std::string(5000, 'x'));
  CHECK(text.source == "  " + std::string(200, 'x'));
  CHECK(text.caret == "  " + std::string(200, '^'));
}

TEST_CASE("diagnostics come in the order of their places") {
  Diagnostics diagnostics;
  diagnostics.error("E101", {7, 1, 1}, "third");
  diagnostics.error("E101", {2, 9, 1}, "second");
  diagnostics.warning("W501", {2, 3, 1}, "first");
  diagnostics.error("E102", {7, 1, 1}, "fourth");
  REQUIRE(diagnostics.all().size() == 4);
  CHECK(diagnostics.all()[0].message == "first");
  CHECK(diagnostics.all()[1].message == "second");
  CHECK(diagnostics.all()[2].message == "third");
  CHECK(diagnostics.all()[3].message == "fourth");
  CHECK(diagnostics.error_count() == 3);
}

TEST_CASE("a warning alone is no error") {
  Diagnostics diagnostics;
  diagnostics.warning("W501", {1, 1, 1}, "doubtful");
  CHECK_FALSE(diagnostics.has_errors());
}

TEST_CASE("what is found beyond the most is counted") {
  Diagnostics diagnostics;
  for (std::uint32_t i = 1; i <= 150; ++i) diagnostics.add(error_at(i, 1));
  CHECK(diagnostics.all().size() == Diagnostics::kMost);
  CHECK(diagnostics.error_count() == 150);
  CHECK(diagnostics.left_out() == 150 - Diagnostics::kMost);
}

TEST_CASE("warnings cannot keep an error from being seen") {
  Diagnostics diagnostics;
  for (std::uint32_t i = 1; i <= 150; ++i) diagnostics.warning("W501", {i, 1, 1}, "doubtful");
  diagnostics.error("E101", {500, 1, 1}, "wrong");
  CHECK(diagnostics.all().size() == Diagnostics::kMost);
  CHECK(diagnostics.all().back().message == "wrong");
}

TEST_CASE("every code has a title, and none is given twice") {
  std::set<std::string_view> seen;
  for (const CodeTitle& entry : all_codes()) {
    CAPTURE(entry.code);
    CHECK(seen.insert(entry.code).second);
    CHECK(entry.code.size() == 4);
    CHECK_FALSE(entry.title.empty());
    CHECK(title_of(entry.code) == entry.title);
  }
  CHECK(title_of("E999").empty());
}

TEST_CASE("a message that quotes a control character is kept as a terminal may show it") {
  Diagnostics diagnostics;
  diagnostics.error("E160", {1, 7, 3}, "cm\x02 is no unit", "a\tb\xFF");
  CHECK(diagnostics.all().front().message == "cm\\u{2} is no unit");
  CHECK(diagnostics.all().front().help == "a\\tb\\xFF");
}

TEST_CASE("neither a message nor the name of its file can forge another message") {
  const Diagnostic diagnostic{
      Severity::Error, "E120", {1, 1, 1}, "no\nf.rob:9:9: error[E999]: forged", "a\rb\xC2\x85 c"};
  CHECK(render(diagnostic, "f\ng.rob", "") ==
        "f\\ng.rob:1:1: error[E120]: no\\nf.rob:9:9: error[E999]: forged\n"
        "help: a\\u{D}b\\u{85} c\n");
}

TEST_CASE("a range of lines has an error in it or has none") {
  Diagnostics diagnostics;
  diagnostics.add(error_at(5, 1));
  diagnostics.warning("W501", {8, 1, 1}, "doubtful");
  CHECK(diagnostics.has_error_between({3, 1}, {5, 9}));
  CHECK(diagnostics.has_error_between({5, 1}, {5, 9}));
  CHECK_FALSE(diagnostics.has_error_between({1, 1}, {4, 9}));
  CHECK_FALSE(diagnostics.has_error_between({6, 1}, {9, 9}));
  CHECK_FALSE(diagnostics.has_error_between({5, 1, 1, 2}, {5, 9, 1, 2}));
}
