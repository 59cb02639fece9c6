#include "runtime/prompt/line_diff.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

using rob::runtime::line_diff;

namespace {

using Lines = std::vector<std::string>;

std::string shown(const Lines& before, const Lines& after) {
  std::string text;
  for (const auto& line : line_diff(before, after))
    text += line.sign + std::string(line.text) + " ";
  return text;
}

}  // namespace

TEST_CASE("a difference tells what goes and what comes") {
  CHECK(shown({}, {}).empty());
  CHECK(shown({"a", "b"}, {"a", "b"}) == " a  b ");
  CHECK(shown({"a", "b", "c"}, {"a", "x", "c"}) == " a -b +x  c ");
  CHECK(shown({}, {"a"}) == "+a ");
  CHECK(shown({"a", "b", "c", "d"}, {"b", "d"}) == "-a  b -c  d ");
  CHECK(shown({"a", "b"}, {"x", "b", "y"}) == "-a +x  b +y ");
  CHECK(shown({"a", "b", "c"}, {"x", "y"}) == "-a -b -c +x +y ");
  CHECK(shown({"a", "a"}, {"a", "a", "a"}) == " a  a +a ");
}

TEST_CASE("a changed line of a long text is the only difference") {
  Lines before;
  for (int i = 0; i < 6000; ++i) before.push_back(std::to_string(i));
  for (const std::size_t changed : {0UL, 2000UL, 5999UL}) {
    CAPTURE(changed);
    Lines after = before;
    after[changed] = "x";
    const auto diff = line_diff(before, after);
    REQUIRE(diff.size() == 6001);
    CHECK(std::ranges::count(diff, ' ', [](const auto& line) { return line.sign; }) == 5999);
    CHECK(diff[changed].sign == '-');
    CHECK(diff[changed + 1].text == "x");
  }
}

TEST_CASE("signs lead from one text to the other, whatever they are, with the fewest changes") {
  std::mt19937 random(7);
  for (int round = 0; round < 300; ++round) {
    Lines before(random() % 7);
    Lines after(random() % 7);
    for (Lines* const lines : {&before, &after}) {
      for (std::string& line : *lines) line = std::string(1, static_cast<char>('a' + random() % 3));
    }
    Lines first;
    Lines second;
    std::size_t common = 0;
    for (const auto& line : line_diff(before, after)) {
      if (line.sign != '+') first.emplace_back(line.text);
      if (line.sign != '-') second.emplace_back(line.text);
      if (line.sign == ' ') ++common;
    }
    CHECK(first == before);
    CHECK(second == after);
    // All subsequences of the first: the longest one that the second has, too.
    std::size_t longest = 0;
    for (unsigned chosen = 0; chosen < 1U << before.size(); ++chosen) {
      std::size_t at = 0;
      std::size_t found = 0;
      bool whole = true;
      for (std::size_t i = 0; i < before.size() && whole; ++i) {
        if ((chosen >> i & 1U) == 0) continue;
        while (at < after.size() && after[at] != before[i]) ++at;
        whole = at < after.size();
        ++at, ++found;
      }
      if (whole) longest = std::max(longest, found);
    }
    CHECK(common == longest);
  }
}
