#include <doctest/doctest.h>

#include <cmath>

#include "runtime/files/files.h"
#include "tests/runtime/prompt/piped_prompt.h"
#include "tests/runtime/prompt/virtual_prompt.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/trace_file.h"

using rob::test::PipedPrompt;
using rob::test::ScratchFolder;

TEST_CASE(":back drives from motion to motion, and the next statement begins there") {
  const ScratchFolder folder;
  PipedPrompt prompt(folder);
  prompt.enter({"MOVE(40,0,0)", "STOP", "MOVE(40,40,0)", "STOP", "DOUT[1] = ON"});
  prompt.said();
  CHECK(prompt.enter({":back", "PRINT HERE, DOUT[1]"}) ==
        "POSE(40mm, 0mm, 0mm, 0deg, 0deg, 0deg)TRUE\n");
  CHECK(prompt.said() == "back where line 3 began; outputs are as they were\n");
  CHECK(prompt.enter({":back", "PRINT HERE"}) == "POSE(0mm, 0mm, 0mm, 0deg, 0deg, 0deg)\n");
  prompt.said();
  prompt.enter({":back"});
  CHECK(prompt.said() == "there is no way back from here: what is recorded begins here\n");
  CHECK(prompt.enter({"MOVE(10,0,0)", "STOP", "PRINT HERE"}) ==
        "POSE(10mm, 0mm, 0mm, 0deg, 0deg, 0deg)\n");
}

TEST_CASE("in a program that is held :back leads from line to line, and :resume forth and on") {
  const ScratchFolder folder;
  const std::string trace = folder.file("way.csv");
  {
    PipedPrompt prompt(folder, "gantry", trace);
    prompt.enter({":insert 1 MOVE(40,40,0) FINE", ":insert 2 MOVE(140,40,0) FINE",
                  ":insert 3 MOVE(140,80,0) FINE", ":insert 4 PRINT HERE", ":step", ":step"});
    prompt.said();
    prompt.enter({":back"});
    CHECK(prompt.said() == "back where line 2 began; outputs are as they were\n");
    CHECK(std::hypot(prompt.axis(0) - 40, prompt.axis(1) - 40) < 1e-9);
    CHECK(prompt.session.state_text() == "gantry held (40, 40, 0)");
    prompt.enter({":back"});
    CHECK(prompt.session.state_text() == "gantry held (0, 0, 0)");
    CHECK(prompt.enter({":resume"}) == "POSE(140mm, 80mm, 0mm, 0deg, 0deg, 0deg)\n");
    CHECK(prompt.session.state_text() == "gantry idle (140, 80, 0)");
  }
  // Corner to corner, there and back and there: the way between them is straight.
  const auto rows = rob::test::parse_trace(rob::runtime::read_file(trace, 100'000'000)).rows;
  double off = 0;
  int comes_by = 0;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const auto [x, y] = std::pair{rows[i].q[0], rows[i].q[1]};
    const double first = std::abs(x - y);
    const double second = std::abs(y - 40);
    const double third = std::abs(x - 140);
    off = std::max(off, x <= 40 + 1e-9 ? first : std::min(second, third));
    if ((rows[i - 1].q[0] - 33.3) * (x - 33.3) < 0) ++comes_by;
  }
  CHECK(off < 1e-6);
  CHECK(comes_by == 3);
}

TEST_CASE("the operator stops the way back, and what was held is dropped") {
  for (const char* const law : {"paul", "lookahead"}) {
    CAPTURE(law);
    rob::test::VirtualPrompt prompt;
    prompt.enter({std::string(":law ") + law, "MOVE(100,0,0)", "STOP", "MOVE(100,50,0)"});
    enter(prompt.session, "MOVE(200,50,0)");
    for (int i = 0; i < 100; ++i) prompt.session.let_pass();
    enter(prompt.session, ":hold");
    for (int i = 0; i < 200; ++i) prompt.session.let_pass();
    enter(prompt.session, ":back");
    for (int i = 0; i < 100; ++i) prompt.session.let_pass();
    const double before = prompt.session.robot().reports().last()->sample.reference.q[0];
    REQUIRE(prompt.session.interrupt());
    prompt.session.finish();
    const double x = prompt.session.robot().reports().last()->sample.reference.q[0];
    CHECK(x < before);
    CHECK(x > 0.1);
    prompt.enter({"MOVE(150,0,0)", "STOP"});
    CHECK(prompt.session.state_text() == "gantry idle (150, 0, 0)");
  }
}

TEST_CASE("behind a hold on the way back :resume drives forth again") {
  rob::test::VirtualPrompt prompt;
  prompt.enter({"MOVE(100,0,0)", "STOP"});
  enter(prompt.session, ":back");
  for (int i = 0; i < 200; ++i) prompt.session.let_pass();
  enter(prompt.session, ":hold");
  for (int i = 0; i < 200; ++i) prompt.session.let_pass();
  const std::string there = prompt.session.state_text();
  CHECK(there.find("(100") == std::string::npos);
  CHECK(there.find("(0, ") == std::string::npos);
  enter(prompt.session, ":resume");
  prompt.session.finish();
  prompt.session.let_pass();
  CHECK(prompt.session.state_text() == "gantry idle (100, 0, 0)");
  prompt.enter({"MOVE(20,0,0)", "STOP"});
  CHECK(prompt.session.state_text() == "gantry idle (20, 0, 0)");
}

TEST_CASE("a second hold ends the way back from a hold; :resume goes on") {
  rob::test::VirtualPrompt prompt;
  enter(prompt.session, "MOVE(100,0,0)");
  const auto pass = [&] {
    for (int i = 0; i < 200; ++i) prompt.session.let_pass();
  };
  const auto x = [&] { return prompt.session.robot().reports().last()->sample.reference.q[0]; };
  pass();
  enter(prompt.session, ":hold");
  pass();
  const double left = x();
  enter(prompt.session, ":back");
  for (int i = 0; i < 80; ++i) prompt.session.let_pass();
  enter(prompt.session, ":hold");
  pass();
  const double there = x();
  CHECK(there < left);
  CHECK(there > 0);
  pass();
  CHECK(x() == there);
  enter(prompt.session, ":resume");
  prompt.session.finish();
  prompt.session.let_pass();
  CHECK(prompt.session.state_text() == "gantry idle (100, 0, 0)");
}

TEST_CASE("held at a STOP, the line before is the one under way") {
  const ScratchFolder folder;
  PipedPrompt prompt(folder);
  prompt.enter(
      {":insert 1 MOVE(40,40,0)", ":insert 2 MOVE(140,40,0)", ":insert 3 STOP", ":step", ":step"});
  REQUIRE(prompt.said().ends_with("held where line 3 begins: STOP\n"));
  prompt.enter({":back"});
  CHECK(prompt.said() == "back where line 2 began; outputs are as they were\n");
}

TEST_CASE("an arm goes back along its line, and the record of another robot is not gone back") {
  const ScratchFolder folder;
  PipedPrompt prompt(folder, "irb120");
  prompt.enter({"VAR p = HERE", "MOVEL p + (0mm, 50mm, 0mm)", "STOP"});
  prompt.enter({":back"});
  CHECK(prompt.enter({"PRINT DIST(HERE, p) < 0.001mm"}) == "TRUE\n");
  prompt.enter({":robot gantry"});
  prompt.said();
  prompt.enter({":back"});
  CHECK(prompt.said().starts_with("there is no way back"));
}
