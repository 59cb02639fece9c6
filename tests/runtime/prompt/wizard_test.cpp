// :frame and :tool ask for positions one after the other, and declare what they make.
#include <doctest/doctest.h>

#include <string>

#include "tests/runtime/prompt/piped_prompt.h"
#include "tests/support/scratch_folder.h"

using namespace rob::runtime;
using rob::test::PipedPrompt;
using rob::test::ScratchFolder;

namespace {

bool says(const std::string& text, const std::string& part) {
  const bool found = text.find(part) != std::string::npos;
  if (!found) MESSAGE(text);
  return found;
}

const std::string kPen = "TOOL pen = POSE(0mm, 0mm, 120mm)";

/// Positions in which the tip of a pen of 120 mm touches (350, 0, 200) mm.
std::string touch(const std::string& angles) {
  return "MOVE POSE(350mm, 0mm, 200mm, " + angles + ") WITH probe FINE";
}

}  // namespace

TEST_CASE(":frame asks for three positions, and the FRAME can be used") {
  const ScratchFolder folder;
  PipedPrompt prompt(folder);
  prompt.enter({":frame table"});
  CHECK(says(prompt.screen.messages, "table: move to its origin, then Enter; :stop leaves"));
  prompt.enter({"MOVE(100, 50, 0)", ""});
  CHECK(says(prompt.screen.messages, "a place on its x axis"));
  prompt.enter({"MOVE(100, 150, 0)", ""});
  CHECK(says(prompt.screen.messages, "a place in its xy plane"));
  const std::string written = prompt.enter({"MOVE(60, 100, 0)", ""});
  CHECK(written.starts_with("FRAME table = FRAME3(POSE("));
  // Its x axis is the world's y.
  CHECK(prompt.enter({"PRINT ROUND(table.c, 0.01deg), \" \", ROUND(table.x, 0.01mm)"}) ==
        "90deg 100mm\n");
  CHECK_FALSE(prompt.session.workshop().wizard.has_value());
}

TEST_CASE("positions on a line make no frame: it asks once more") {
  const ScratchFolder folder;
  PipedPrompt prompt(folder);
  prompt.enter({":frame table", ""});
  prompt.enter({"MOVE(50, 0, 0)", ""});
  prompt.enter({"MOVE(100, 0, 0)", ""});
  CHECK(says(prompt.screen.messages, "E337"));
  CHECK(prompt.screen.messages.ends_with("table: move to its origin, then Enter; :stop leaves\n"));
  CHECK(prompt.session.workshop().wizard.has_value());
}

TEST_CASE(":tool finds the tip of a tool by touch, on an arm") {
  const ScratchFolder folder;
  PipedPrompt prompt(folder, "irb120");
  prompt.enter({"TOOL probe = POSE(0mm, 0mm, 120mm)", ":tool pen"});
  CHECK(says(prompt.screen.messages, "(1 of 4)"));
  for (const char* angles :
       {"180deg, 0deg, 180deg", "150deg, 0deg, 180deg", "180deg, 30deg, 180deg"})
    prompt.enter({touch(angles), ""});
  CHECK(says(prompt.screen.messages, "(4 of 4)"));
  prompt.enter({":done"});
  CHECK(says(prompt.screen.messages, "pen needs more positions"));
  prompt.enter({touch("200deg, -20deg, 180deg"), ""});
  CHECK(says(prompt.screen.messages, "mm from the flange, missed by 0"));
  const std::string written = prompt.enter({":done"});
  CHECK(written.starts_with("TOOL pen = TOOL4(POSE("));
  CHECK(prompt.enter({"PRINT DIST(pen, probe) < 0.2mm"}) == "TRUE\n");
}

TEST_CASE("a frame can be touched with a tool's tip") {
  const ScratchFolder folder;
  PipedPrompt prompt(folder, "irb120");
  prompt.enter({kPen, ":frame table pen"});
  for (const char* at : {"350mm, 0mm, 200mm", "350mm, 80mm, 200mm", "300mm, 0mm, 200mm"})
    prompt.enter({"MOVE POSE(" + std::string(at) + ", 180deg, 0deg, 180deg) WITH pen FINE", ""});
  const std::string near =
      "PRINT DIST(table, POSE(350mm, 0mm, 200mm)) < 0.2mm, ROUND(table.c, 1deg)";
  CHECK(prompt.enter({near}) == "TRUE90deg\n");
  prompt.enter({":frame table felt"});
  CHECK(says(prompt.screen.messages, "there is no tool felt"));
}

TEST_CASE(":stop leaves it, and Enter then does nothing") {
  const ScratchFolder folder;
  PipedPrompt prompt(folder);
  prompt.enter({":frame table", "", ":stop", "", "", ""});
  CHECK(says(prompt.screen.messages, "table is left as it was"));
  CHECK(prompt.screen.results.empty());
  prompt.enter({":done"});
  CHECK(says(prompt.screen.messages, "there is nothing to be done"));
}

TEST_CASE("it writes into the program in memory, after the lines that come first") {
  const ScratchFolder folder;
  PipedPrompt prompt(folder);
  prompt.enter({":insert 1 ROBOT \"gantry\"", ":insert 2 MOVE(40, 40, 0)", ":frame table", "",
                "MOVE(100, 0, 0)", "", "MOVE(0, 100, 0)", ""});
  const ProgramText& program = prompt.session.workshop().program;
  REQUIRE(program.size() == 3);
  CHECK(program.line(2).starts_with("FRAME table = FRAME3("));
  // Anew: the same line.
  const std::string first = program.line(2);
  prompt.enter({":frame table", "", "MOVE(100, 0, 0)", "", "MOVE(100, 100, 0)", ""});
  CHECK(program.size() == 3);
  CHECK(program.line(2) != first);
  prompt.enter({":undo", ":undo"});
  CHECK(program.size() == 2);
}
