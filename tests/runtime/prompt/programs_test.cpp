// The program in memory: recorded, edited, run, stepped and foretold at the prompt.

#include <algorithm>
#include <cmath>
#include <fstream>

#include "runtime/files/files.h"
#include "runtime/files/kept_values.h"
#include "tests/runtime/prompt/piped_prompt.h"

using namespace rob::runtime;
using rob::test::PipedPrompt;
using rob::test::ScratchFolder;

namespace {

/// A program of three motions and a STOP, as lines are inserted.
const std::vector<std::string> kThree = {":insert 1 MOVE(40,40,0)", ":insert 2 MOVE(140,40,0)",
                                         ":insert 3 MOVE(140,80,0)", ":insert 4 STOP"};

/// The least distance of the reference, as a trace tells it, from a place of the table, mm.
double nearest(const std::string& trace, double x, double y) {
  std::ifstream rows(trace);
  std::string row;
  std::getline(rows, row);
  const auto column = [](const std::string& text, int n) {
    std::size_t at = 0;
    while (n-- > 0) at = text.find(',', at) + 1;
    return std::stod(text.substr(at));
  };
  const auto place = [&](const std::string& name) {
    const std::size_t at = ("," + row + ",").find("," + name + ",");
    return static_cast<int>(std::count(row.begin(), row.begin() + static_cast<long>(at), ','));
  };
  const int q1 = place("q1");
  const int q2 = place("q2");
  double least = 1e9;
  while (std::getline(rows, row))
    least = std::min(least, std::hypot(column(row, q1) - x, column(row, q2) - y));
  return least;
}

}  // namespace

TEST_CASE(":record keeps what is executed as it was typed, and nothing else") {
  const ScratchFolder folder;
  PipedPrompt prompt(folder);
  prompt.enter({"MOVE(1,1,0)", ":record on", "  MOVE( 40,40, 0) // there", ":where",
                "FOR i = 1 TO 2 DO\n  PRINT i\nENDFOR", "MOVE(9000,0,0)", "MOOVE", "STOP",
                "RAISE \"no\"", ":record off", "PRINT 7"});
  CHECK(prompt.enter({":list"}) ==
        "   1    MOVE( 40,40, 0) // there\n   2  FOR i = 1 TO 2 DO\n   3    PRINT i\n"
        "   4  ENDFOR\n   5  STOP\n");
}

TEST_CASE("the program is edited by line numbers, and edits are undone") {
  const ScratchFolder folder;
  PipedPrompt prompt(folder);
  prompt.enter(kThree);
  prompt.enter({":edit 2 MOVE(100,40,0)", ":delete 3 4"});
  CHECK(prompt.enter({":list"}) == "   1  MOVE(40,40,0)\n   2  MOVE(100,40,0)\n");
  CHECK(prompt.enter({":undo", ":undo", ":list 2 3"}) ==
        "   2  MOVE(140,40,0)\n   3  MOVE(140,80,0)\n");
  CHECK(prompt.enter({":redo", ":list 2"}) == "   2  MOVE(100,40,0)\n");
  prompt.said();
  prompt.enter({":edit 9 STOP"});
  CHECK(prompt.said() == "error: there is no line 9\nhelp: the program has the lines 1 to 4\n");
  prompt.enter({":new", ":list"});
  CHECK(prompt.said().ends_with("the program in memory is empty\n"));
}

TEST_CASE(":run begins without the WHENs of the prompt, and its own end with it") {
  const ScratchFolder folder;
  PipedPrompt prompt(folder);
  CHECK(prompt.enter({"WHEN DOUT[1] DO\n  PRINT \"of the prompt\"\nENDWHEN",
                      ":insert 1 WHEN DOUT[2] : DOUT[3] = ON", ":insert 2 DOUT[1] = ON",
                      ":insert 3 WAIT 0.1s", ":insert 4 DOUT[2] = ON", ":insert 5 WAIT 0.1s",
                      ":insert 6 PRINT DOUT[3]", ":run"}) == "TRUE\n");
  CHECK(prompt.enter({"DOUT[1] = OFF", "DOUT[2] = OFF", "DOUT[3] = OFF", "WAIT 0.1s",
                      "DOUT[2] = ON", "DOUT[1] = ON", "WAIT 0.1s", "PRINT DOUT[3]"}) == "FALSE\n");
}

TEST_CASE(":run carries out the program, with variables of its own") {
  const ScratchFolder folder;
  PipedPrompt prompt(folder);
  prompt.enter({"VAR n = 5", ":insert 1 VAR n = 1", ":insert 2 MOVE(40,40,0)", ":insert 3 STOP",
                ":insert 4 PRINT n, \" \", HERE"});
  CHECK(prompt.enter({":run"}) == "1 POSE(40mm, 40mm, 0mm, 0deg, 0deg, 0deg)\n");
  CHECK(prompt.enter({"PRINT n"}) == "5\n");
  CHECK(prompt.enter({":run"}) == "1 POSE(40mm, 40mm, 0mm, 0deg, 0deg, 0deg)\n");
}

TEST_CASE("a program with errors tells all of them, and nothing moves") {
  const ScratchFolder folder;
  PipedPrompt prompt(folder);
  prompt.enter({":insert 1 MOVE(40,40,0)", ":insert 2 MOOVE", ":insert 3 MOVE(9000,0,0)", ":run"});
  const std::string said = prompt.said();
  CHECK(said.find("program:2:1: error[E120]") != std::string::npos);
  CHECK(said.find("program:3:5: error[E401]") != std::string::npos);
  CHECK(said.ends_with("error: the program has errors; nothing moves\n"));
  CHECK(prompt.session.state_text() == "gantry idle (0, 0, 0)");
}

TEST_CASE("an error while the program runs is told with its line in the program") {
  const ScratchFolder folder;
  PipedPrompt prompt(folder);
  prompt.enter(
      {"PRINT 1", "PRINT 2", ":insert 1 MOVE(40,40,0)", ":insert 2 RAISE \"enough\"", ":run"});
  CHECK(prompt.said().find("program:2:") != std::string::npos);
  CHECK(prompt.session.state_text() == "gantry idle (40, 40, 0)");
  CHECK(prompt.enter({"PRINT 3"}) == "3\n");
}

TEST_CASE("an error in a handler between two entries is told with its line at the prompt") {
  // The program is on line 1 of the prompt; the handler's PRINT is the second line of entry 3.
  const ScratchFolder folder;
  PipedPrompt prompt(folder);
  prompt.enter({":insert 1 PRINT 1", ":run", "VAR zero = 0",
                "WHEN DOUT[1] DO\n  PRINT 1 DIV zero\nENDWHEN"});
  prompt.said();
  prompt.enter({"DOUT[1] = ON"});
  for (int i = 0; i < 10; ++i) prompt.session.let_pass();
  CHECK(prompt.said().starts_with("prompt:4:11: error[E302]"));
  CHECK(prompt.session.robot().open() == 0);
}

TEST_CASE(":run from a line executes what is declared before, and no statement") {
  const ScratchFolder folder;
  PipedPrompt prompt(folder);
  prompt.enter({":insert 1 VAR n = 3", ":insert 2 MOVE(40,40,0)", ":insert 3 n = 4",
                ":insert 4 PROC tell()", ":insert 5 PRINT n", ":insert 6 ENDPROC",
                ":insert 7 VAR m = n + 1", ":insert 8 IF TRUE THEN", ":insert 9 tell()",
                ":insert 10 ENDIF", ":insert 11 PRINT m"});
  CHECK(prompt.enter({":run from 8"}) == "3\n4\n");
  CHECK(prompt.session.state_text() == "gantry idle (0, 0, 0)");
  prompt.said();
  prompt.enter({":run from 9"});
  CHECK(prompt.said() ==
        "error: no statement begins in line 9 outside of all blocks\n"
        "help: the next one begins in line 11\n");
  CHECK(prompt.enter({":run from 2"}) == "4\n5\n");  // line 3 is executed: n is 4, and m 5
}

TEST_CASE(":resume behind a step goes on to the end, which is no place to hold") {
  for (const char* const law : {":law paul", ":law lookahead"}) {
    CAPTURE(law);
    const ScratchFolder folder;
    PipedPrompt prompt(folder);
    prompt.enter({law});
    prompt.enter(kThree);
    prompt.enter({":delete 4"});
    prompt.said();
    prompt.enter({":step", ":resume"});
    CHECK(prompt.said().ends_with("held where line 2 begins: MOVE(140,40,0)\n"));
    CHECK(prompt.session.state_text() == "gantry idle (140, 80, 0)");
    prompt.enter({":step", ":step", ":step"});
    CHECK(prompt.said() ==
          "held where line 2 begins: MOVE(140,40,0)\nheld where line 3 begins: MOVE(140,80,0)\n");
    CHECK(prompt.session.state_text() == "gantry idle (140, 80, 0)");
  }
}

TEST_CASE(
    ":step holds where the motion of the next line begins, on the path of the whole program") {
  // Paul's law: line 2 begins at the decision point of line 1, while the corner at (40, 40) has
  // still to be rounded; so nothing is reached exactly, and the corner keeps its form.
  const ScratchFolder folder;
  PipedPrompt prompt(folder);
  prompt.enter(kThree);
  prompt.enter({":step"});
  CHECK(prompt.said().ends_with("held where line 2 begins: MOVE(140,40,0)\n"));
  CHECK(prompt.session.state_text().find("held") != std::string::npos);
  CHECK(prompt.axis(0) < 40);
  CHECK(prompt.axis(0) > 5);
  prompt.enter({":step"});
  CHECK(prompt.said() == "held where line 3 begins: MOVE(140,80,0)\n");
  CHECK(prompt.axis(0) > 100);
  CHECK(prompt.axis(1) == doctest::Approx(40).epsilon(0.01));  // the corner has just begun
  prompt.enter({":step"});
  CHECK(prompt.said() == "held where line 4 begins: STOP\n");
  CHECK(prompt.axis(1) < 80);
  prompt.enter({":step"});
  CHECK(prompt.said().empty());
  CHECK(prompt.session.state_text() == "gantry idle (140, 80, 0)");
}

TEST_CASE("stepping rounds each corner as far as running does") {
  const ScratchFolder folder;
  double missed[2];
  for (const bool steps : {false, true}) {
    {
      PipedPrompt prompt(folder, "gantry", folder.file("trace.csv"));
      prompt.enter(kThree);
      prompt.enter(steps ? std::vector<std::string>{":step", ":step", ":step", ":step"}
                         : std::vector<std::string>{":run"});
      REQUIRE(prompt.session.state_text() == "gantry idle (140, 80, 0)");
    }
    missed[steps ? 1 : 0] = nearest(folder.file("trace.csv"), 40, 40);
  }
  // docs/getting-started.md: the triangle's first corner is missed by 4 mm. A sample is taken
  // every 10 ms, 0.2 mm at most; the nearest one is off by 0.1²/(2·4) mm at most.
  CHECK(missed[0] == doctest::Approx(4.0).epsilon(0.02));
  CHECK(missed[1] == doctest::Approx(missed[0]).epsilon(0.001));
}

TEST_CASE("a breakpoint holds on the path each time, and :resume goes on") {
  const ScratchFolder folder;
  PipedPrompt prompt(folder);
  prompt.enter({":insert 1 FOR i = 1 TO 2 DO", ":insert 2 MOVE(40*i,0,0)", ":insert 3 STOP",
                ":insert 4 ENDFOR", ":break 2"});
  CHECK(prompt.enter({":break"}) == "   2* MOVE(40*i,0,0)\n");
  CHECK(prompt.enter({":list 2"}) == "   2* MOVE(40*i,0,0)\n");
  prompt.enter({":run"});
  CHECK(prompt.said().ends_with("held where line 2 begins: MOVE(40*i,0,0)\n"));
  CHECK(prompt.axis(0) < 1);
  prompt.enter({":resume"});
  CHECK(prompt.said().ends_with("held where line 2 begins: MOVE(40*i,0,0)\n"));
  CHECK(prompt.axis(0) == doctest::Approx(40).epsilon(0.02));
  prompt.enter({":break off 2", ":resume"});
  CHECK(prompt.session.state_text() == "gantry idle (80, 0, 0)");
  prompt.enter({":run"});
  CHECK(prompt.said().empty());
}

TEST_CASE("breakpoints and steps are of the program: what is typed on such a line runs through") {
  const ScratchFolder folder;
  PipedPrompt prompt(folder);
  prompt.enter({":insert 1 MOVE(10,0,0)", ":break 1", ":run", ":stop"});
  CHECK(prompt.said().find("held where line 1 begins") != std::string::npos);
  prompt.enter({"MOVE(20,0,0)", "MOVE(30,0,0)"});
  CHECK(prompt.session.state_text() == "gantry idle (30, 0, 0)");
}

TEST_CASE(":check and :time foretell from where the robot stands, and nothing moves") {
  // From (0, 0) line 1 takes 40 mm at 20 mm/s, 2 s, but at least 2·t_acc = 2.75 s; from (140, 40)
  // it takes 100 mm, 5 s.
  const ScratchFolder folder;
  PipedPrompt prompt(folder);
  prompt.enter({":insert 1 MOVE(40,40,0)"});
  CHECK(prompt.enter({":time"}).find("     1    0.00     2.75") != std::string::npos);
  prompt.enter({"MOVE(140,40,0)"});
  const double now = prompt.time();
  CHECK(prompt.enter({":check"}).find("     1    0.00     5.00") != std::string::npos);
  CHECK(prompt.session.state_text() == "gantry idle (140, 40, 0)");
  CHECK(prompt.time() - now < 0.1);  // it is not run
}

TEST_CASE("a program for another law or robot is refused, with the way out") {
  const ScratchFolder folder;
  PipedPrompt prompt(folder);
  prompt.enter({":insert 1 LAW LOOKAHEAD", ":insert 2 MOVE(40,0,0)", ":run"});
  CHECK(prompt.said().ends_with(
      "error: the program asks for another law; gantry is under paul\nhelp: :law lookahead\n"));
  prompt.enter({":law lookahead", ":run"});
  CHECK(prompt.session.state_text() == "gantry idle (40, 0, 0)");
}

TEST_CASE(":vars tells names, types and values") {
  const ScratchFolder folder;
  PipedPrompt prompt(folder);
  prompt.enter({"VAR reach = 20mm", "VAR n = 1", "CONST name = \"x\"", "n = n + 1"});
  const double now = prompt.axis(0);
  CHECK(prompt.enter({":vars"}) ==
        "n = 2  // a whole number\nname = x  // a text\nreach = 20mm  // a length\n");
  CHECK(prompt.axis(0) == now);
  CHECK(prompt.enter({":list"}).empty());
}

TEST_CASE("a program with PERSIST keeps its variables when it is run at the prompt") {
  const ScratchFolder folder;
  const std::string file = folder.file("count.rob");
  std::ofstream(file) << "PERSIST VAR count = 0\ncount += 1\nWRITE \"log.txt\": \"run \", count\n"
                         "PRINT count\n";
  PipedPrompt prompt(folder);
  CHECK(prompt.enter({":load " + file, ":run", ":run"}) == "1\n2\n");
  CHECK(rob::runtime::read_file(folder.file("count.values"), 1000) == "count = 2\n");
  CHECK(rob::runtime::read_file(folder.file("log.txt"), 1000) == "run 1\nrun 2\n");
  const rob::runtime::ValuesLock other(folder.file("count.values"));
  CHECK(prompt.enter({":run"}).empty());
  CHECK(prompt.session.worst() == ExitCode::InputOutput);
}

TEST_CASE("a program with PERSIST needs a file before it is run") {
  const ScratchFolder folder;
  PipedPrompt prompt(folder);
  prompt.enter({":insert 1 PERSIST VAR count = 0", ":run"});
  CHECK(prompt.screen.messages.find("it has no file yet\nhelp: :save FILE\n") != std::string::npos);
}

TEST_CASE("a program with a DEVICE runs at the prompt; on the virtual clock none is opened") {
  const ScratchFolder folder;
  PipedPrompt prompt(folder);
  CHECK(prompt.enter({":insert 1 DEVICE scale = \"tcp://127.0.0.1:9\"", ":insert 2 VAR line = \"\"",
                      ":insert 3 SEND scale: \"W\"",
                      ":insert 4 RECEIVE scale INTO line TIMEOUT 0.5s ELSE PRINT \"none\"",
                      ":run"}) == "none\n");
}
