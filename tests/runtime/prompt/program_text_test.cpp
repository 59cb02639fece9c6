#include "runtime/prompt/program_text.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

using rob::runtime::ProgramText;

TEST_CASE("edits change the lines that they name, and no others") {
  ProgramText program;
  program.set("a\nb\nc\n", "");
  program.replace(2, "B");
  CHECK(program.text() == "a\nB\nc\n");
  program.insert(1, "0");
  program.insert(5, "d");
  CHECK(program.text() == "0\na\nB\nc\nd\n");
  program.erase(2, 4);
  CHECK(program.text() == "0\nd\n");
  CHECK(program.line(2) == "d");
}

TEST_CASE("every edit can be undone and done again, until the next edit") {
  ProgramText program;
  CHECK(!program.undo());
  program.set("a\n", "");
  program.insert(2, "b");
  program.erase(1, 1);
  CHECK(program.undo().has_value());
  CHECK(program.text() == "a\nb\n");
  CHECK(program.undo().has_value());
  CHECK(program.text() == "a\n");
  CHECK(program.redo().has_value());
  CHECK(program.text() == "a\nb\n");
  program.replace(1, "A");
  CHECK(!program.redo());
  CHECK(program.undo().has_value());
  CHECK(program.text() == "a\nb\n");
}

TEST_CASE("what was recorded of entries that failed is taken back, and nothing else") {
  ProgramText program;
  program.set("typed\n", "");
  program.record("one\n  more", 3);
  program.record("two", 5);
  program.record("three", 6);
  program.take_back(5, 9);
  CHECK(program.text() == "typed\none\n  more\n");
  program.take_back(4, 9);
  CHECK(program.text() == "typed\none\n  more\n");
}

TEST_CASE("each edit says what it did, and so does who takes it back") {
  ProgramText program;
  program.set("a\nb\nc\n", "loaded");
  CHECK(program.replace(2, "B") == "line 2 changed: B");
  CHECK(program.insert(4, "d") == "line 4 inserted: d");
  CHECK(program.erase(1, 1) == "line 1 deleted: a");
  CHECK(program.erase(1, 2) == "lines 1 to 2 deleted");
  CHECK(program.undo()->what == "lines 1 to 2 deleted");
  CHECK(program.undo()->what == "line 1 deleted: a");
  CHECK(program.text() == "a\nB\nc\nd\n");
  CHECK(program.redo()->what == "line 1 deleted: a");
}

TEST_CASE("a name is another one wherever it stands, but in texts, comments and fields") {
  ProgramText program;
  program.set("POINT pick\nMOVE Pick // pick\nPRINT \"pick\", part.pick, pick.x, pickup\n", "");
  CHECK(program.has_name("PICK"));
  CHECK_FALSE(program.has_name("up"));
  program.rename({"pick", "place"});
  CHECK(program.text() ==
        "POINT place\nMOVE place // pick\nPRINT \"pick\", part.pick, place.x, pickup\n");
  const auto undone = program.undo();
  REQUIRE(undone->renaming.has_value());
  CHECK(undone->renaming->to == "place");
  CHECK(program.text() ==
        "POINT pick\nMOVE Pick // pick\nPRINT \"pick\", part.pick, pick.x, pickup\n");
}

TEST_CASE("the program in memory knows which points it declares, after every edit") {
  rob::runtime::ProgramText program;
  program.set("POINT a, b\nMOVE c\n  point d\nPRINT \"POINT e\"\n", "");
  for (const char* const name : {"a", "B", "d"}) CHECK(program.declares_point(name));
  for (const char* const name : {"c", "e"}) CHECK_FALSE(program.declares_point(name));
  program.insert(1, "POINT a");
  program.erase(2, 2);
  CHECK(program.declares_point("a"));
  CHECK_FALSE(program.declares_point("b"));
  program.undo();
  CHECK(program.declares_point("b"));
  program.rename({"a", "z"});
  CHECK(program.declares_point("z"));
  CHECK_FALSE(program.declares_point("a"));
}
