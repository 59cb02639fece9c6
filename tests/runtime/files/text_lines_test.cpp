#include "runtime/files/text_lines.h"

#include <doctest/doctest.h>

#include <string>
#include <string_view>
#include <vector>

using rob::runtime::split_lines;
using rob::runtime::take_line;

TEST_CASE("lines are split at their ends, and the last end begins no line") {
  CHECK(split_lines("").empty());
  CHECK(split_lines("a") == std::vector<std::string>{"a"});
  CHECK(split_lines("a\n") == std::vector<std::string>{"a"});
  CHECK(split_lines("\n  b //c\n\n") == std::vector<std::string>{"", "  b //c", ""});
}

TEST_CASE("a line is taken from a text without its end") {
  std::string_view text = "a\n\nb";
  CHECK(take_line(text) == "a");
  CHECK(text == "\nb");
  CHECK(take_line(text).empty());
  CHECK(take_line(text) == "b");
  CHECK(text.empty());
}
