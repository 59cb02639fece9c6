#include "lang/text/visible.h"

#include <doctest/doctest.h>

#include <string>

#include "lang/text/utf8.h"

using namespace rob::lang;

namespace {

std::string character(char32_t c) {
  std::string text;
  append_utf8(text, c);
  return text;
}

}  // namespace

TEST_CASE("what could move a cursor or turn the writing is shown as Rob's texts write it") {
  CHECK(visible("\x1b]0;title\x07") == "\\u{1B}]0;title\\u{7}");
  CHECK(visible("a\nb\tc\r") == "a\\nb\\tc\\u{D}");
  CHECK(visible(std::string_view("a\0b", 3)) == "a\\u{0}b");
  CHECK(visible("\x7f") == "\\u{7F}");
  CHECK(visible(character(0x9B)) == "\\u{9B}");
  CHECK(visible(character(0x202E) + "x" + character(0x2069)) == "\\u{202E}x\\u{2069}");
  CHECK(visible(character(0x2028) + character(0x2029)) == "\\u{2028}\\u{2029}");
}

TEST_CASE("exactly the control characters, the line ends and what turns the writing are replaced") {
  for (char32_t c = 1; c < 0x3000; ++c) {
    if (c >= 0xD800 && c < 0xE000) continue;
    const bool control = c < 0x20 || (c >= 0x7F && c <= 0x9F);
    const bool separator = c == 0x2028 || c == 0x2029;
    const bool turns = (c >= 0x202A && c <= 0x202E) || (c >= 0x2066 && c <= 0x2069);
    const std::string text = character(c);
    CAPTURE(static_cast<unsigned>(c));
    CHECK((visible(text) == text) == !(control || separator || turns));
    const bool in_lines = c == '\n' || c == '\t';
    CHECK((visible_lines(text) == text) == (in_lines || !(control || separator || turns)));
    const bool ends_line = (c >= 0x0A && c <= 0x0D) || c == 0x85 || separator;
    CHECK((on_one_line(text) == text) == !ends_line);
  }
}

TEST_CASE("text of any language stays, and bytes that are no UTF-8 are shown as numbers") {
  CHECK(visible("größer 20 µm € 例 \U0001F600") == "größer 20 µm € 例 \U0001F600");
  CHECK(visible("a\xFF\xC3") == "a\\xFF\\xC3");
  CHECK(visible_lines("\x9B\n") == "\\x9B\n");
  CHECK(on_one_line("\xFF\x1b\n") == "\xFF\x1b\\n");
  CHECK(visible("").empty());
}

TEST_CASE("a JSON document keeps its meaning, and its own lines") {
  CHECK(visible_json("{\n  \"a\": \"" + character(0x9B) + character(0x202E) + "\x7f\"\n}\n") ==
        "{\n  \"a\": \"\\u009b\\u202e\\u007f\"\n}\n");
}
