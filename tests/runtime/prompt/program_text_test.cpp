#include "runtime/prompt/program_text.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

using rob::runtime::ProgramText;

TEST_CASE("edits change the lines that they name, and no others") {
  ProgramText program;
  program.set("a\nb\nc\n");
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
  program.set("a\n");
  program.insert(2, "b");
  program.erase(1, 1);
  CHECK(program.undo());
  CHECK(program.text() == "a\nb\n");
  CHECK(program.undo());
  CHECK(program.text() == "a\n");
  CHECK(program.redo());
  CHECK(program.text() == "a\nb\n");
  program.replace(1, "A");
  CHECK(!program.redo());
  CHECK(program.undo());
  CHECK(program.text() == "a\nb\n");
}

TEST_CASE("what was recorded of entries that failed is taken back, and nothing else") {
  ProgramText program;
  program.set("typed\n");
  program.record("one\n  more", 3);
  program.record("two", 5);
  program.record("three", 6);
  program.take_back(5, 9);
  CHECK(program.text() == "typed\none\n  more\n");
  program.take_back(4, 9);
  CHECK(program.text() == "typed\none\n  more\n");
}
