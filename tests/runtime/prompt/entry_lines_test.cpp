#include "runtime/prompt/entry_lines.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

using rob::runtime::EntryLines;

namespace {

/// After each line, whether the next one is awaited without a look at the entry; the compiler finds
/// an open block whenever it looks, except in the last line.
std::vector<bool> goes_on(const std::vector<std::string>& lines) {
  EntryLines entry;
  std::vector<bool> answers;
  for (const std::string& line : lines) {
    entry.add(line);
    answers.push_back(entry.surely_goes_on());
    if (!answers.back()) entry.note_open_block();
  }
  return answers;
}

}  // namespace

TEST_CASE("in a block that is open only a line that closes one is looked at") {
  CHECK(goes_on({"FOR i = 1 TO 3 DO", "  PRINT i", "  MOVE(i, 2, 3)", "ENDFOR"}) ==
        std::vector<bool>{false, true, true, false});
  CHECK(goes_on({"func f(): INT", "return 1", "endfunc"}) == std::vector<bool>{false, true, false});
}

TEST_CASE("lines between brackets go on, those in texts and comments do not count") {
  CHECK(goes_on({"VAR a = [1,", "2, (3", "+ 4)", "]"}) ==
        std::vector<bool>{true, true, true, false});
  CHECK(goes_on({"PRINT \"(\" // ["}) == std::vector<bool>{false});
  CHECK(goes_on({R"(PRINT "\\" + "(")"}) == std::vector<bool>{false});
  CHECK(goes_on({R"(PRINT "\"(")"}) == std::vector<bool>{false});
  CHECK(EntryLines::brackets_open("MOVE(1,\n2"));
  CHECK_FALSE(EntryLines::brackets_open("MOVE(1,\n2, 3)\n"));
}

TEST_CASE("a long block of blocks is looked at a few times, and when it is complete") {
  std::vector<std::string> lines{"LOOP"};
  for (int i = 0; i < 10'000; ++i) {
    lines.insert(lines.end(), {"  IF n > 0 THEN  // (", "    EXIT", "  ENDIF"});
  }
  lines.emplace_back("ENDLOOP");
  const std::vector<bool> answers = goes_on(lines);
  const auto looks = std::count(answers.begin(), answers.end(), false);
  CHECK(looks < 60);  // log(30'000) / log(5/4) = 46, and some at the beginning
  CHECK_FALSE(answers.back());
}

TEST_CASE("a line with a mistake in it delays a look by a quarter of the entry at most") {
  std::vector<std::string> lines{"LOOP"};
  for (int i = 0; i < 1000; ++i) lines.emplace_back("  STOP");
  lines.insert(lines.end(), {"  IF n > 0 THEN", "  ENDIF", "  PRINT 1 DO", "ENDLOOP"});
  for (int i = 0; i < 400; ++i) lines.emplace_back("ENDLOOP");
  const std::vector<bool> answers = goes_on(lines);
  const auto behind = std::find(answers.begin() + 1004, answers.end(), false);
  CHECK(behind - answers.begin() < 1004 + 1004 / 4 + 1);
}
