// The prompt without a terminal, on the virtual clock: what statements and commands do.

#include <doctest/doctest.h>

#include <fstream>

#include "tests/runtime/prompt/virtual_prompt.h"
#include "tests/support/scratch_folder.h"

using namespace rob::runtime;
using Prompt = rob::test::VirtualPrompt;

TEST_CASE("statements act at once, and the next one finds the robot where it is") {
  Prompt prompt;
  CHECK(prompt.enter({"MOVE(40,40,0)", "STOP", "PRINT HERE"}) ==
        "POSE(40mm, 40mm, 0mm, 0deg, 0deg, 0deg)\n");
  CHECK(prompt.session.worst() == ExitCode::Done);
}

TEST_CASE("successive MOVEs join without stopping, as in a program") {
  // docs/motion.md: a program of MOVE(40,40,0), MOVE(140,40,0) takes 2.75 + 5 + 2.75 s and the
  // clearing of the last corner; with a stop between it is 2.75 s more. Entries come a cycle apart.
  Prompt prompt;
  prompt.enter({"MOVE(40,40,0)", "MOVE(140,40,0)", "STOP"});
  const double joined = prompt.time();
  Prompt apart;
  apart.enter({"MOVE(40,40,0)"});
  apart.enter({"MOVE(140,40,0)", "STOP"});
  CHECK(apart.time() - joined == doctest::Approx(2.75).epsilon(0.02));
}

TEST_CASE("an error in an entry is told with its line, and nothing of it moves") {
  Prompt prompt;
  prompt.enter({"MOVE(40,40,0)", "MOVE(9000,0,0)", "STOP"});
  CHECK(prompt.screen.messages.starts_with(
      "prompt:2:5: error[E401]: axis x: 9000 mm is beyond 400 mm\n  MOVE(9000,0,0)\n"));
  CHECK(prompt.session.worst() == ExitCode::ProgramError);
  CHECK(prompt.session.state_text() == "gantry idle (40, 40, 0)");
}

TEST_CASE("an entry that fails drops the entries typed ahead, and the prompt goes on") {
  Prompt prompt;
  enter(prompt.session, "MOVE(40,40,0)");
  enter(prompt.session, "RAISE \"enough\"");
  enter(prompt.session, "MOVE(140,40,0)");
  prompt.session.finish();
  CHECK(prompt.screen.messages.find("error[E") != std::string::npos);
  CHECK(prompt.screen.messages.find("enough") != std::string::npos);
  CHECK(prompt.session.worst() == ExitCode::Fault);
  CHECK(prompt.session.state_text() == "gantry idle (40, 40, 0)");
  CHECK(prompt.enter({"PRINT 1 + 1"}) == "2\n");
}

TEST_CASE("a block takes lines until it is closed") {
  Prompt prompt;
  CHECK(enter(prompt.session, "FOR i = 1 TO 2 DO") == Session::Taken::Incomplete);
  CHECK(enter(prompt.session, "FOR i = 1 TO 2 DO\n  PRINT i") == Session::Taken::Incomplete);
  CHECK(prompt.enter({"FOR i = 1 TO 2 DO\n  PRINT i\nENDFOR"}) == "1\n2\n");
  CHECK(enter(prompt.session, "MOVE(40,") == Session::Taken::Incomplete);
  CHECK(enter(prompt.session, "PRINT \"(\"") == Session::Taken::Done);
  CHECK(enter(prompt.session, "PRINT 1 // (") == Session::Taken::Done);
}

TEST_CASE("the operator's stop brakes on the path, and drops what was typed ahead") {
  Prompt prompt;
  enter(prompt.session, "MOVE(400,0,0)");
  enter(prompt.session, "MOVE(400,400,0)");
  for (int i = 0; i < 500; ++i) prompt.session.let_pass();  // 5 s of 20 s
  CHECK(prompt.session.interrupt());
  prompt.session.finish();
  // Under Paul's law the gantry stops within 0.26 s; at 20 mm/s that is less than 6 mm.
  const auto& last = prompt.session.robot().reports().last();
  CHECK(last->sample.reference.q[0] < 0.11);
  CHECK(last->sample.reference.q[0] > 0.04);
  CHECK(last->sample.reference.q[1] == 0);
  CHECK(prompt.screen.messages.find("stopped by the operator") != std::string::npos);
  CHECK(!prompt.session.interrupt());
  prompt.enter({"MOVE(0,0,0)", "STOP"});
  CHECK(prompt.session.state_text() == "gantry idle (0, 0, 0)");
}

TEST_CASE(":hold stands on the path, and :resume goes on to the end") {
  Prompt prompt;
  enter(prompt.session, "MOVE(100,0,0)");
  for (int i = 0; i < 300; ++i) prompt.session.let_pass();
  enter(prompt.session, ":hold");
  for (int i = 0; i < 300; ++i) prompt.session.let_pass();
  const double held = prompt.session.robot().reports().last()->sample.reference.q[0];
  CHECK(prompt.session.state_text().starts_with("gantry held"));
  for (int i = 0; i < 100; ++i) prompt.session.let_pass();
  CHECK(prompt.session.robot().reports().last()->sample.reference.q[0] == held);
  CHECK(held < 0.09);
  enter(prompt.session, ":resume");
  prompt.session.finish();
  CHECK(prompt.session.state_text() == "gantry idle (100, 0, 0)");
}

TEST_CASE(":override halves the speed of what moves") {
  // 100 mm at 20 mm/s and 2·t_acc: 5 + 2.75 s; at half the speed twice that.
  Prompt whole;
  whole.enter({"MOVE(100,0,0)"});
  Prompt half;
  enter(half.session, ":override 50%");
  half.enter({"MOVE(100,0,0)"});
  CHECK(half.time() == doctest::Approx(2 * whole.time()).epsilon(0.01));
  enter(half.session, ":override 500%");
  CHECK(half.screen.messages.starts_with("error: :override takes a share from above 0% to 200%"));
}

TEST_CASE("a WHEN of the prompt stays armed from entry to entry") {
  Prompt prompt;
  prompt.enter({"WHEN DOUT[1] : DOUT[2] = ON", "DOUT[1] = ON", "WAIT 0.1s"});
  CHECK(prompt.enter({"PRINT DOUT[2]"}) == "TRUE\n");
}

TEST_CASE("an expression alone prints its value") {
  Prompt prompt;
  CHECK(prompt.enter({"2mm*3"}) == "6mm\n");
  CHECK(prompt.enter({"VAR x = 3", "x", "x == 3", "-x // three"}) == "3\nTRUE\n-3\n");
  CHECK(prompt.enter({"MOVE(40,40,0)", "STOP", "HERE"}) ==
        "POSE(40mm, 40mm, 0mm, 0deg, 0deg, 0deg)\n");
  CHECK(prompt.enter({"FUNC double(n: INT): INT\n  RETURN 2 * n\nENDFUNC", "double(4)"}) == "8\n");
  CHECK(prompt.enter({"VAR a = [1, 2, 3]", "a", "a[2]", "(1 +\n2)"}) == "[1, 2, 3]\n2\n3\n");
  CHECK(prompt.enter({"RECORD part\n  n: INT\n  w: LENGTH\nENDRECORD", "VAR p = part(n: 1, w: 2mm)",
                      "p", "p.w"}) == "part(n: 1, w: 2mm)\n2mm\n");
  CHECK(prompt.enter({":record on", "  2*3", ":list"}) == "   1  PRINT 2*3\n6\n");
}

TEST_CASE("an error in an expression is told of the expression, one in a statement of that") {
  Prompt prompt;
  const auto said = [&](const char* entry) {
    prompt.screen.messages.clear();
    prompt.enter({entry});
    return prompt.screen.messages.substr(0, prompt.screen.messages.find(']') + 1);
  };
  CHECK(said("2mm + 3s") == "prompt:1:5: error[E207]");
  CHECK(said("SIN") == "prompt:2:1: error[E205]");
  CHECK(said("HER") == "prompt:3:1: error[E201]");
  CHECK(said("MOOVE(1,2,3)") == "prompt:4:1: error[E120]");
  CHECK(said("nothing") == "prompt:5:1: error[E120]");
  CHECK(said("VAR zero = 0") == "");
  CHECK(said("1 DIV zero") == "prompt:7:3: error[E302]");
}

TEST_CASE("another law is for a robot at rest") {
  Prompt prompt;
  enter(prompt.session, "MOVE(100,0,0)");
  for (int i = 0; i < 100; ++i) prompt.session.let_pass();
  enter(prompt.session, ":law lookahead");
  CHECK(prompt.screen.messages ==
        "error: :law needs a robot at rest; it is busy\nhelp: wait for it, or :stop it\n");
  prompt.session.finish();
  CHECK(prompt.session.state_text() == "gantry idle (100, 0, 0)");
}

TEST_CASE("an unknown command is told with the nearest one") {
  Prompt prompt;
  enter(prompt.session, ":wher");
  CHECK(prompt.screen.messages == "error: there is no command :wher\nhelp: did you mean :where?\n");
}

TEST_CASE("help, ?, quit and exit are commands without a colon, where they are no names") {
  Prompt prompt;
  const std::string list = prompt.enter({":help"});
  CHECK(list.find("  :teach POINT") != std::string::npos);
  CHECK(prompt.enter({"help"}) == list);
  CHECK(prompt.enter({" ? "}) == list);
  CHECK(prompt.enter({"Help MOVE"}) == prompt.enter({":help MOVE"}));
  CHECK(prompt.enter({"help :where"}) ==
        "  :where                       the robot's position: axes and pose\n");
  CHECK(prompt.enter({"LOOP\n  exit\nENDLOOP", "VAR help = 3", "help"}) == "3\n");
  CHECK_FALSE(prompt.session.over());
  prompt.enter({"Exit"});
  CHECK(prompt.session.over());
  Prompt other;
  other.enter({"VAR quit = 1", "quit"});
  CHECK_FALSE(other.session.over());
  CHECK(other.screen.results == "1\n");
}

TEST_CASE("SAFE values are taken where an entry fails, and may be set again") {
  Prompt prompt;
  prompt.enter({"SIGNAL torch = DOUT[1] SAFE OFF", "torch = ON"});
  CHECK(prompt.enter({"PRINT torch"}) == "TRUE\n");
  prompt.enter({"RAISE \"out of gas\""});
  CHECK(prompt.enter({"PRINT torch"}) == "FALSE\n");
  prompt.enter({"torch = ON"});
  CHECK(prompt.enter({"PRINT torch"}) == "TRUE\n");
}

TEST_CASE("a TASK of the prompt runs beside the entries, and shares variables with them") {
  Prompt prompt;
  prompt.enter(
      {"VAR n = 5", "VAR told = \"\"",
       "TASK count\n  LOOP\n    n += 1\n    told = \"t\"\n    WAIT 0.1s\n  ENDLOOP\nENDTASK"});
  CHECK(prompt.enter({"WAIT 1s", "PRINT n"}) == "5\n");  // declared, not started
  // Begun, and ten times more in 1.05 s: it looks in each cycle of 10 ms.
  CHECK(prompt.enter({"START count", "WAIT 1.05s", "PRINT n, told"}) == "16t\n");
  CHECK(prompt.enter({"n = 100", "WAIT 0.05s", "PRINT n >= 100 AND n <= 101"}) == "TRUE\n");
  CHECK(prompt.session.errors() == 0);
  prompt.enter({"START count"});
  CHECK(prompt.screen.messages.find("E343") != std::string::npos);
  CHECK(prompt.session.errors() == 1);
}

TEST_CASE("a TASK that is declared anew has ended, and the new one can be started") {
  Prompt prompt;
  prompt.enter({"VAR n = 0", "TASK count\n  LOOP\n    n += 1\n    WAIT 0.1s\n  ENDLOOP\nENDTASK",
                "START count", "WAIT 0.35s"});
  CHECK(prompt.enter({"PRINT n"}) == "4\n");
  prompt.enter({"TASK count\n  n = 1000\nENDTASK"});
  CHECK(prompt.enter({"n = 7", "WAIT 1s", "PRINT n"}) == "7\n");
  CHECK(prompt.enter({"START count", "WAIT 0.1s", "PRINT n"}) == "1000\n");
}

TEST_CASE("a TASK ends where what it uses is declared anew, and that is told") {
  const std::string count = "TASK count\n  LOOP\n    step()\n    WAIT 0.1s\n  ENDLOOP\nENDTASK";
  const std::vector<std::string> begin = {
      "VAR n = 0", "CONST by = 1", "PROC step()\n  VAR own = by\n  n += own\nENDPROC",
      count,       "START count",  "WAIT 0.35s"};
  const std::string ended =
      "TASK count has ended: what it uses has been declared anew; START count";
  for (const std::string anew : {"VAR n = 100", "CONST by = 2", "PROC step()\n  n += 3\nENDPROC"}) {
    CAPTURE(anew);
    Prompt prompt;
    prompt.enter(begin);
    CHECK(prompt.enter({"PRINT n"}) == "4\n");
    prompt.enter({"VAR own = 7", "VAR other = 0"});  // names that it does not use
    CHECK(prompt.screen.messages.find(ended) == std::string::npos);
    prompt.enter({anew});
    CHECK(prompt.screen.messages.find(ended) != std::string::npos);
    CHECK(prompt.session.errors() == 0);
    const std::string stood = prompt.enter({"PRINT n"});
    CHECK(prompt.enter({"WAIT 1s", "PRINT n"}) == stood);
    const std::string changed = prompt.enter({"START count", "WAIT 0.05s", "PRINT n"});
    const int by = anew == "CONST by = 2" ? 2 : anew == "VAR n = 100" ? 1 : 3;
    CHECK(std::stoi(changed) == std::stoi(stood) + by);
  }
}

TEST_CASE("a WHEN that was armed before a TASK is declared shares its variables with it") {
  Prompt prompt;
  prompt.enter({"VAR n = 0", "VAR seen = 0", "SIGNAL go = DOUT[1]",
                "WHEN go DO\n  n += 10\nENDWHEN", "n = 1", "go = ON", "WAIT 0.1s", "go = OFF"});
  CHECK(prompt.enter({"PRINT n"}) == "11\n");
  prompt.enter(
      {"TASK look\n  LOOP\n    seen = n\n    IF n == 100 THEN n = 200\n    WAIT 0.01s\n"
       "  ENDLOOP\nENDTASK",
       "START look", "WAIT 0.1s"});
  CHECK(prompt.enter({"PRINT seen"}) == "11\n");
  prompt.enter({"go = ON", "WAIT 0.1s", "go = OFF", "WAIT 0.1s"});
  CHECK(prompt.enter({"PRINT n, \" \", seen"}) == "21 21\n");
  // And the other way: the handler counts on from what the TASK has made of it.
  prompt.enter({"n = 100", "WAIT 0.1s", "go = ON", "WAIT 0.1s"});
  CHECK(prompt.enter({"PRINT n, \" \", seen"}) == "210 210\n");
  CHECK(prompt.session.errors() == 0);
}

TEST_CASE("one TASK may be declared anew as often as one likes, and 16 there can be") {
  Prompt prompt;
  for (int i = 0; i < 40; ++i)
    prompt.enter({"TASK one\n  PRINT " + std::to_string(i) + "\nENDTASK"});
  CHECK(prompt.enter({"START one", "WAIT 0.1s"}) == "39\n");
  for (int i = 2; i <= 16; ++i)
    prompt.enter({"TASK t" + std::to_string(i) + "\n  WAIT 1s\nENDTASK"});
  prompt.enter({"TASK t16\n  WAIT 2s\nENDTASK"});
  CHECK(prompt.session.errors() == 0);
  prompt.enter({"TASK t17\n  WAIT 1s\nENDTASK"});
  CHECK(prompt.session.errors() == 1);
}

TEST_CASE("where declaring arrays anew has used up the room, the help names :reset") {
  Prompt prompt;
  int declared = 0;
  for (; prompt.session.errors() == 0 && declared < 100; ++declared)
    prompt.enter({"VAR a: ARRAY[100000] OF REAL"});
  CHECK(declared > 1);
  CHECK(prompt.screen.messages.find("E229") != std::string::npos);
  CHECK(prompt.screen.messages.find(":reset gives all of it back") != std::string::npos);
  prompt.session.reset();
  CHECK(prompt.enter({"VAR a: ARRAY[100000] OF REAL", "PRINT a[100000]"}) == "0\n");
}

TEST_CASE("a command that needs rest may be typed at once after a START") {
  const rob::test::ScratchFolder folder;
  const std::string file = folder.file("a.rob");
  std::ofstream(file) << "MOVE(1, 1, 1)\n";
  Prompt prompt;
  prompt.enter({"TASK tick\n  LOOP\n    WAIT 0.1s\n  ENDLOOP\nENDTASK"});
  CHECK(rob::runtime::enter(prompt.session, "START tick") == Session::Taken::Done);
  rob::runtime::enter(prompt.session, ":load " + file);
  CHECK(prompt.session.errors() == 0);
  CHECK(rob::runtime::enter(prompt.session, "MOVE(40, 0, 0)") == Session::Taken::Done);
  for (int i = 0; i < 5; ++i) prompt.session.let_pass();
  rob::runtime::enter(prompt.session, ":load " + file);  // it moves
  CHECK(prompt.session.errors() == 1);
}

TEST_CASE("the error of a TASK is shown, and the entries go on") {
  Prompt prompt;
  prompt.enter({"TASK wrong\n  WAIT 0.1s\n  RAISE \"bad\"\nENDTASK", "START wrong", "WAIT 0.5s"});
  CHECK(prompt.screen.messages == "prompt:3:3: error[E340]: bad\n    RAISE \"bad\"\n    ^^^^^\n");
  CHECK(prompt.session.worst() == ExitCode::Fault);
  CHECK(prompt.enter({"PRINT 6 * 111"}) == "666\n");
}

TEST_CASE("a WHEN that was the last entry stays armed when the operator stops a jog") {
  Prompt prompt;
  prompt.enter({"WHEN DOUT[1] : DOUT[2] = ON"});
  rob::lang::MoveCommand jog;
  jog.kind = rob::lang::MotionKind::Jog;
  jog.jog = rob::lang::JogFrame::Joint;
  jog.count = 3;
  jog.given = rob::lang::given_all(3);
  jog.target[0] = 0.01;
  prompt.session.dead_man().hold();
  prompt.session.jog(jog, prompt.session.dead_man().watch());
  for (int i = 0; i < 100; ++i) prompt.session.let_pass();
  REQUIRE(prompt.session.interrupt());
  prompt.session.finish();
  CHECK(prompt.enter({"DOUT[1] = ON", "WAIT 0.1s", "PRINT DOUT[2]"}) == "TRUE\n");
}

TEST_CASE("behind an error in a handler the prompt goes on") {
  Prompt prompt;
  prompt.enter({"VAR zero = 0", "WHEN DOUT[1] DO\n  PRINT 1 DIV zero\nENDWHEN", "DOUT[1] = ON",
                "WAIT 0.1s"});
  CHECK(prompt.screen.messages.find("error[E302]") != std::string::npos);
  CHECK(prompt.enter({"MOVE(40,0,0)", "STOP", "PRINT HERE"}) ==
        "POSE(40mm, 0mm, 0mm, 0deg, 0deg, 0deg)\n");
}

/// Until the time of an observation has come, a handler can begin.
constexpr const char* kPass = "PROC pass()\n  WAIT 0.1s\n  VAR t = CLOCK\nENDPROC";

TEST_CASE("a handler of an earlier entry interrupts routines of later ones, and finds its own") {
  Prompt prompt;
  prompt.enter({"VAR n = 1", "FUNC doubled(x: INT): INT\n  RETURN 2 * x\nENDFUNC",
                "WHEN DOUT[1] DO\n  VAR a: ARRAY[50] OF INT\n  a[50] = doubled(n)\n"
                "  n = n + a[50]\nENDWHEN"});
  CHECK(prompt.enter({"VAR b: ARRAY[200] OF INT", "b[200] = 7", "VAR s = \"kept\"",
                      "PROC first()\n  PRINT \"first\"\nENDPROC", kPass,
                      "FUNC slow(k: INT): INT\n  VAR c: ARRAY[9] OF INT\n  c[9] = k\n"
                      "  first()\n  pass()\n  RETURN c[9] + n\nENDFUNC",
                      "DOUT[1] = ON\nPRINT slow(4), \" \", slow(5)",
                      "PRINT n, \" \", b[200], \" \", b[1], \" \", s"}) ==
        "first\nfirst\n7 8\n3 7 0 kept\n");
  CHECK(prompt.enter({"DOUT[1] = OFF", "pass()", "DOUT[1] = ON", "pass()", "PRINT n"}) == "9\n");
  CHECK(prompt.screen.messages.empty());
}

TEST_CASE("an error in a handler of an earlier entry can be rescued, and says where it was") {
  Prompt prompt;
  CHECK(prompt.enter({"VAR zero = 0", "WHEN DOUT[1] DO\n  PRINT 1 DIV zero\nENDWHEN", kPass,
                      "TRY\n  DOUT[1] = ON\n  pass()\nRESCUE why\n  PRINT why\nENDTRY",
                      "PRINT \"on\""}) == "E302: division by zero\non\n");
  prompt.enter({"DOUT[1] = OFF", "pass()", "DOUT[1] = ON\npass()"});
  CHECK(prompt.screen.messages.find("prompt:3:11: error[E302]") != std::string::npos);
}

TEST_CASE("an entry that fails tells how many behind it are dropped, and their names are free") {
  Prompt prompt;
  enter(prompt.session, "MOVE(40,0,0)");
  enter(prompt.session, "RAISE \"enough\"");
  enter(prompt.session, "VAR n = 1");
  enter(prompt.session, "PROC f()\n  PRINT 1\nENDPROC");
  enter(prompt.session, "DOUT[1] = ON\nVAR m = 1");
  prompt.session.finish();
  CHECK(prompt.screen.messages.starts_with("dropped, typed ahead: 3 entries\n"));
  for (const char* const name : {"n", "m"}) {
    CAPTURE(name);
    prompt.screen.messages.clear();
    enter(prompt.session, std::string("PRINT ") + name);
    CHECK(prompt.screen.messages.find("error[E201]") != std::string::npos);
  }
  CHECK(prompt.enter({"VAR n = 2", "VAR f = 3", "PRINT n + f"}) == "5\n");
}

TEST_CASE("a type is not declared anew, nor a routine where there is a value") {
  Prompt prompt;
  prompt.enter({"RECORD r\n  x: INT\nENDRECORD", "VAR a = 3"});
  enter(prompt.session, "RECORD r\n  y: LENGTH\nENDRECORD");
  CHECK(prompt.screen.messages.find("error[E202]: r is already declared") != std::string::npos);
  prompt.screen.messages.clear();
  enter(prompt.session, "FUNC a(): INT\n  RETURN 4\nENDFUNC");
  CHECK(prompt.screen.messages.find("error[E202]: a is already declared") != std::string::npos);
  CHECK(prompt.enter({"PRINT a, r(x: 1)"}) == "3r(x: 1)\n");
}

TEST_CASE(":jog is refused while something moves, or is held") {
  Prompt prompt;
  enter(prompt.session, "MOVE(40,0,0)");
  for (int i = 0; i < 100; ++i) prompt.session.let_pass();
  enter(prompt.session, ":jog");
  enter(prompt.session, ":hold");
  for (int i = 0; i < 200; ++i) prompt.session.let_pass();
  enter(prompt.session, ":jog");
  CHECK_FALSE(prompt.session.take_pendant());
  CHECK(prompt.screen.messages ==
        "error: the pendant needs a robot at rest\nhelp: :stop before\n"
        "error: the pendant needs a robot at rest; it is held\nhelp: :resume or :stop before\n");
  enter(prompt.session, ":stop");
  prompt.session.finish();
  prompt.session.let_pass();
  enter(prompt.session, ":jog");
  CHECK(prompt.session.take_pendant());
}

TEST_CASE("each line of :help fits 80 columns") {
  Prompt prompt;
  std::string rows = prompt.enter({":help"});
  while (!rows.empty()) {
    const std::string row = rows.substr(0, rows.find('\n'));
    CHECK_MESSAGE(row.size() < 80, row);
    rows.erase(0, row.size() + 1);
  }
}

TEST_CASE("an OBSTACLE stands there from its entry on, and may be declared anew") {
  const std::string pen =
      "TOOL pen = POSE(0mm, 0mm, 80mm) SHAPE CAPSULE((0mm, 0mm, 0mm), (0mm, 0mm, 80mm), 5mm)";
  Prompt prompt;
  prompt.enter({pen, "MOVE(40, 40, 0)", "MOVE(140, 40, 0) WITH pen FINE"});
  CHECK(prompt.session.worst() == ExitCode::Done);
  prompt.enter({"OBSTACLE ball = SPHERE((100mm, 40mm, 50mm), 10mm)"});
  CHECK(enter(prompt.session, "MOVE(40, 40, 0) WITH pen") == Session::Taken::Done);
  prompt.session.finish();
  CHECK(prompt.screen.messages.find("error[E580]: gripper hits ball") != std::string::npos);
  CHECK(prompt.session.state_text() == "gantry idle (140, 40, 0)");
  prompt.enter({"ALLOW ball DO\n  MOVE(40, 40, 0) WITH pen FINE\nENDALLOW"});
  CHECK(prompt.session.state_text() == "gantry idle (40, 40, 0)");
  prompt.enter(
      {"OBSTACLE ball = SPHERE((100mm, 140mm, 50mm), 10mm)", "MOVE(140, 40, 0) WITH pen FINE"});
  CHECK(prompt.session.state_text() == "gantry idle (140, 40, 0)");
}
