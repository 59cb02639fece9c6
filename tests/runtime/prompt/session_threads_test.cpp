// A prompt in real time: what is typed, what moves and what reports are threads of their own.

#include <doctest/doctest.h>

#include <fstream>
#include <string>

#include "runtime/files/files.h"
#include "tests/runtime/prompt/virtual_prompt.h"
#include "tests/support/scratch_folder.h"

using namespace rob::runtime;
using rob::test::VirtualPrompt;

namespace {

SessionOptions in_real_time() {
  SessionOptions options = VirtualPrompt::options("gantry");
  options.fast = false;
  return options;
}

/// Waits, as a person does, until the robot is in this state; at most 20 s, on a loaded machine
/// too.
bool comes_to(Session& session, const std::string& state) {
  for (int i = 0; i < 4000; ++i) {
    session.let_pass();
    if (session.state_text().starts_with("gantry " + state)) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return false;
}

}  // namespace

TEST_CASE("a prompt moves, holds, goes back and on, stops and jogs in real time") {
  VirtualPrompt prompt(in_real_time());
  Session& session = prompt.session;
  enter(session, "VAR n = 20");
  enter(session, "MOVE(n * 1mm, 0, 0)");
  CHECK(comes_to(session, "moving"));
  enter(session, ":hold");
  CHECK(comes_to(session, "held"));
  enter(session, ":back");
  CHECK(comes_to(session, "held (0, 0, 0)"));
  enter(session, ":resume");
  enter(session, "PRINT n");
  CHECK(comes_to(session, "moving"));
  CHECK(session.interrupt());
  session.finish();
  CHECK(prompt.screen.messages.find("stopped by the operator") != std::string::npos);
  session.dead_man().hold();
  rob::lang::MoveCommand jog;
  jog.kind = rob::lang::MotionKind::Jog;
  jog.jog = rob::lang::JogFrame::Joint;
  jog.count = 3;
  jog.given = rob::lang::given_all(3);
  jog.target[0] = 0.01;
  session.jog(jog, session.dead_man().watch());
  CHECK(comes_to(session, "jogging"));
  session.dead_man().release();
  session.finish();
  CHECK(prompt.enter({"PRINT n + 1"}) == "21\n");
  CHECK(session.worst() == ExitCode::Done);  // a stop is no error
}

// For the thread sanitizer: the TASK looks at the files that the program brings and takes away.
TEST_CASE("a TASK looks for files while programs begin and end") {
  const rob::test::ScratchFolder folder;
  std::ofstream(folder.file("count.rob")) << "PERSIST VAR count = 0\ncount += 1\nWAIT 0.02s\n";
  VirtualPrompt prompt(in_real_time());
  prompt.enter(
      {"TASK look\nVAR found = 0\nLOOP\nIF EXISTS(\"no.csv\") THEN\nfound += 1\nENDIF\n"
       "WAIT 0.001s\nENDLOOP\nENDTASK",
       "START look"});
  prompt.enter({":load " + folder.file("count.rob")});
  for (int i = 0; i < 5; ++i) prompt.enter({":run"});
  CAPTURE(prompt.screen.messages);
  CHECK(prompt.session.worst() == ExitCode::Done);
  CHECK(rob::runtime::read_file(folder.file("count.values"), 1000) == "count = 5\n");
}
