// The prompt on a terminal, in real time, as a person sees it.

#include <doctest/doctest.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <regex>
#include <string>
#include <vector>

#include "tests/support/process.h"
#include "tests/support/pseudo_terminal.h"
#include "tests/support/scratch_folder.h"

using namespace rob::test;
using namespace std::chrono_literals;

namespace {

constexpr const char* kCtrlC = "\x03";
constexpr const char* kCtrlD = "\x04";
constexpr const char* kLeft = "\033[D";
constexpr const char* kUp = "\033[A";
constexpr const char* kAtRest = "gantry idle (0, 0, 0)> ";

/// Prompts on the gantry that share a folder, one after another.
struct Desk {
  PseudoTerminal::Options options(const std::string& term = "vt100") const {
    return {folder.path().string(),
            {{"TERM", term},
             {"LC_ALL", "C.UTF-8"},
             {"NO_COLOR", "1"},
             {"XDG_STATE_HOME", (folder.path() / "states").string()}}};
  }
  PseudoTerminal::Options coloured() const {
    PseudoTerminal::Options more = options("xterm-256color");
    more.environment["NO_COLOR"] = "";
    return more;
  }
  ScratchFolder folder;
};

bool matches(const std::string& text, const char* pattern) {
  return std::regex_match(text, std::regex(pattern));
}

std::ptrdiff_t lines_with(const PseudoTerminal& terminal, const std::string& part) {
  return std::ranges::count_if(terminal.screen(), [&](const std::string& line) {
    return line.find(part) != std::string::npos;
  });
}

/// The place of a line; the number of lines if it is not there.
std::size_t line_of(const std::vector<std::string>& lines, const std::string& text) {
  return static_cast<std::size_t>(std::ranges::find(lines, text) - lines.begin());
}

}  // namespace

TEST_CASE("a line is typed while the robot moves; Ctrl-C stops the robot, then drops the line") {
  const Desk desk;
  PseudoTerminal terminal({ROB_BINARY}, desk.options());
  INFO(terminal.raw());
  REQUIRE(terminal.expect(kAtRest));
  terminal.send("MOVE(100,0,0)\r");
  REQUIRE(terminal.expect("gantry moving"));
  terminal.send("PRINT 1 + 1");
  REQUIRE(terminal.expect("PRINT 1 + 1"));
  terminal.watch(700ms);
  CHECK_MESSAGE(matches(terminal.last_line(), R"(gantry moving \([0-9.]+, 0, 0\) *> PRINT 1 \+ 1)"),
                terminal.last_line());
  CHECK(lines_with(terminal, "PRINT 1 + 1") == 1);

  terminal.send(kCtrlC);
  REQUIRE(terminal.expect("stopped by the operator"));
  REQUIRE(terminal.expect("idle"));
  terminal.watch(100ms);
  CHECK_MESSAGE(matches(terminal.last_line(), R"(gantry idle \([0-9.]+, 0, 0\) *> PRINT 1 \+ 1)"),
                terminal.last_line());
  terminal.send(kCtrlC);
  REQUIRE(terminal.expect("^C"));
  REQUIRE(terminal.expect("> "));
  CHECK_MESSAGE(matches(terminal.last_line(), R"(gantry idle \([0-9.]+, 0, 0\)>)"),
                terminal.last_line());
  terminal.send(kCtrlD);
  CHECK(terminal.wait() == 0);
  CHECK(terminal.modes_as_found());
}

TEST_CASE("what a program prints stands above the line that is being typed") {
  const Desk desk;
  PseudoTerminal terminal({ROB_BINARY}, desk.options());
  INFO(terminal.raw());
  REQUIRE(terminal.expect(kAtRest));
  terminal.send("LOOP\rWAIT 0.1s\rPRINT \"tick\"\rENDLOOP\r");
  REQUIRE(terminal.expect("tick\r\n"));
  terminal.send("abc");
  REQUIRE(terminal.expect("tick"));
  REQUIRE(terminal.expect("tick"));
  terminal.send(std::string(kLeft) + kLeft + "X");
  REQUIRE(terminal.expect("tick"));
  terminal.watch(50ms);
  CHECK_MESSAGE(terminal.last_line().ends_with("> aXbc"), terminal.last_line());
  CHECK(lines_with(terminal, "aXbc") == 1);
  // The word in the entry's own line aside, every tick has a line for itself.
  const std::vector<std::string> lines = terminal.screen();
  CHECK(std::ranges::count(lines, "tick") >= 4);
  CHECK(lines_with(terminal, "tick") == std::ranges::count(lines, "tick") + 1);
  terminal.send(kCtrlC);
  CHECK(terminal.expect("stopped by the operator"));
}

TEST_CASE("an error appears under what was typed, with a caret; a block can be dropped") {
  const Desk desk;
  PseudoTerminal terminal({ROB_BINARY}, desk.options());
  INFO(terminal.raw());
  REQUIRE(terminal.expect(kAtRest));
  terminal.send("MOVE(9000,0,0)\r");
  REQUIRE(terminal.expect("help: "));
  REQUIRE(terminal.expect(kAtRest));
  std::vector<std::string> lines = terminal.screen();
  const std::size_t typed = line_of(lines, std::string(kAtRest) + "MOVE(9000,0,0)");
  REQUIRE(typed + 3 < lines.size());
  CHECK(lines[typed + 1] == "prompt:1:5: error[E401]: axis x: 9000 mm is beyond 400 mm");
  CHECK(lines[typed + 2] == "  MOVE(9000,0,0)");
  CHECK(lines[typed + 3] == "      ^");

  terminal.send("FOR i = 1 TO 2 DO\rPRINT i\r");
  REQUIRE(terminal.expect("PRINT i"));
  REQUIRE(terminal.expect("\u2026"));
  terminal.send(kCtrlC);
  REQUIRE(terminal.expect(kAtRest));
  terminal.send("PRINT 40 + 2\r");
  REQUIRE(terminal.expect("42\r\n"));
  REQUIRE(terminal.expect(kAtRest));
  lines = terminal.screen();
  CHECK(line_of(lines, "42") < lines.size());
  CHECK(line_of(lines, "1") == lines.size());
}

TEST_CASE("a paste ends at its first error, and what follows in it is shown") {
  const Desk desk;
  PseudoTerminal terminal({ROB_BINARY}, desk.options());
  INFO(terminal.raw());
  REQUIRE(terminal.expect(kAtRest));
  terminal.send("\033[200~PRINT 40 + 1\rMOOVE(1,2,3)\rPRINT 40 + 2\rPRINT 40 + 3\033[201~\r");
  REQUIRE(terminal.expect("E120"));
  REQUIRE(terminal.expect("not executed, of what was pasted:"));
  REQUIRE(terminal.expect("41\r\n"));
  const std::vector<std::string> lines = terminal.screen();
  CHECK(line_of(lines, "41") < lines.size());
  CHECK(line_of(lines, "  PRINT 40 + 2") < lines.size());
  CHECK(line_of(lines, "  PRINT 40 + 3") < lines.size());
  CHECK(line_of(lines, "42") == lines.size());
}

TEST_CASE("lines that come in one go end at the first error, too, where a paste is not marked") {
  const Desk desk;
  PseudoTerminal terminal({ROB_BINARY}, desk.options("dumb"));
  INFO(terminal.raw());
  REQUIRE(terminal.expect(kAtRest));
  terminal.send("PRINT 40 + 1\rMOOVE(1,2,3)\rPRINT 40 + 2\rPRINT 40 + 3\r");
  REQUIRE(terminal.expect("E120"));
  REQUIRE(terminal.expect("not executed, of what was pasted:"));
  REQUIRE(terminal.expect("  PRINT 40 + 2\r\n  PRINT 40 + 3\r\n"));
  terminal.send("PRINT 50 + 1\r");  // typed later: that is another thing
  REQUIRE(terminal.expect("51\r\n"));
  CHECK(terminal.raw().find("42\r\n") == std::string::npos);
}

TEST_CASE("a line of a block with a mistake is told at once, and alone is typed again") {
  const Desk desk;
  PseudoTerminal terminal({ROB_BINARY}, desk.options());
  INFO(terminal.raw());
  REQUIRE(terminal.expect(kAtRest));
  terminal.send("FOR i = 1 TO 2 DO\r");
  REQUIRE(terminal.expect("\u2026"));
  terminal.send("PRINT j\r");
  REQUIRE(terminal.expect("prompt:2:9: error[E201]"));
  REQUIRE(terminal.expect("\u2026"));
  terminal.send("PRINT 10 * i\r");
  REQUIRE(terminal.expect("\u2026"));
  terminal.send("ENDFOR\r");
  REQUIRE(terminal.expect("10\r\n"));
  REQUIRE(terminal.expect("20\r\n"));
}

TEST_CASE("a block is indented, its end is not, and blanks that are typed count alone") {
  const Desk desk;
  PseudoTerminal terminal({ROB_BINARY}, desk.options());
  INFO(terminal.raw());
  REQUIRE(terminal.expect(kAtRest));
  terminal.send("IF 1 == 1 THEN\r    LOOP\rEXIT\rENDLOOP\rELSE\rPRINT 2\rENDIF\rPRINT 40 + 2\r");
  REQUIRE(terminal.expect("42\r\n"));
  const std::vector<std::string> lines = terminal.screen();
  const std::size_t first = line_of(lines, std::string(kAtRest) + "IF 1 == 1 THEN");
  REQUIRE(first + 6 < lines.size());
  CHECK(std::vector<std::string>(lines.begin() + static_cast<std::ptrdiff_t>(first) + 1,
                                 lines.begin() + static_cast<std::ptrdiff_t>(first) + 7) ==
        std::vector<std::string>{"\u2026     LOOP", "\u2026       EXIT", "\u2026     ENDLOOP",
                                 "\u2026   ELSE", "\u2026     PRINT 2", "\u2026   ENDIF"});
}

TEST_CASE("the history has a block as a whole, also in the next session") {
  const Desk desk;
  {
    PseudoTerminal terminal({ROB_BINARY}, desk.options());
    INFO(terminal.raw());
    REQUIRE(terminal.expect(kAtRest));
    terminal.send("FOR i = 1 TO 2 DO\rPRINT 10 * i\rENDFOR\r");
    REQUIRE(terminal.expect("20\r\n"));
    REQUIRE(terminal.expect(kAtRest));
    terminal.send(std::string(kUp) + "\r");
    REQUIRE(terminal.expect("10\r\n"));
    REQUIRE(terminal.expect("20\r\n"));
  }
  PseudoTerminal terminal({ROB_BINARY}, desk.options());
  INFO(terminal.raw());
  REQUIRE(terminal.expect(kAtRest));
  terminal.send(kUp);
  REQUIRE(terminal.expect("ENDFOR"));
  terminal.send("\r");
  REQUIRE(terminal.expect("10\r\n"));
  CHECK(terminal.expect("20\r\n"));
}

TEST_CASE("a paste of 50 lines is shown once, and Enter executes it") {
  const Desk desk;
  PseudoTerminal terminal({ROB_BINARY}, desk.options());
  INFO(terminal.raw());
  REQUIRE(terminal.expect(kAtRest));
  std::string text = "VAR n = 0\r";
  for (int i = 1; i <= 48; ++i) text += "n = n + " + std::to_string(i) + "\r";
  terminal.send("\033[200~" + text + "PRINT n\033[201~");
  REQUIRE(terminal.expect("50 lines are pasted"));
  REQUIRE(terminal.expect(kAtRest));
  terminal.watch(300ms);
  CHECK(lines_with(terminal, "n = n + 48") == 1);
  terminal.send("\r");
  CHECK(terminal.expect("1176\r\n"));  // 48 * 49 / 2
}

TEST_CASE(":edit with a line alone opens the old text") {
  const Desk desk;
  PseudoTerminal terminal({ROB_BINARY}, desk.options());
  INFO(terminal.raw());
  REQUIRE(terminal.expect(kAtRest));
  terminal.send(":insert 1 PRINT 41\r");
  REQUIRE(terminal.expect("line 1 inserted: PRINT 41"));
  terminal.send(":edit 1\r");
  REQUIRE(terminal.expect(":edit 1 PRINT 41"));
  terminal.send("\b2\r");
  CHECK(terminal.expect("line 1 changed: PRINT 42"));
}

TEST_CASE("Ctrl-\\ brakes as Ctrl-C does, and the prompt stays") {
  const Desk desk;
  PseudoTerminal terminal({ROB_BINARY}, desk.options());
  INFO(terminal.raw());
  REQUIRE(terminal.expect(kAtRest));
  terminal.send("MOVE(100,0,0)\r");
  REQUIRE(terminal.expect("gantry moving"));
  terminal.send("\x1c");
  REQUIRE(terminal.expect("stopped by the operator"));
  REQUIRE(terminal.expect("idle"));
  terminal.send(kCtrlD);
  CHECK(terminal.wait() == 0);
}

TEST_CASE("Ctrl-Z suspends at rest, and says why it does not while the robot is under way") {
  const Desk desk;
  PseudoTerminal terminal({ROB_BINARY}, desk.options());
  INFO(terminal.raw());
  REQUIRE(terminal.expect(kAtRest));
  terminal.send("MOVE(30,0,0)\r");
  REQUIRE(terminal.expect("gantry moving"));
  terminal.send("\x1a");
  REQUIRE(terminal.expect("Ctrl-Z does nothing while the robot is under way; :stop it first"));
  REQUIRE(terminal.expect("idle (30, 0, 0)"));
  terminal.send("\x1a");
  terminal.watch(700ms);
  terminal.signal(SIGCONT);
  terminal.send("PRINT 40 + 2\r");
  REQUIRE(terminal.expect("42\r\n"));
  terminal.send("MOVE(31,0,0)\r");
  REQUIRE(terminal.expect("idle (31, 0, 0)"));
  CHECK(terminal.raw().find("fault") == std::string::npos);
}

TEST_CASE("Tab completes what may stand there, and lists what is ambiguous") {
  const Desk desk;
  PseudoTerminal terminal({ROB_BINARY}, desk.options());
  INFO(terminal.raw());
  REQUIRE(terminal.expect(kAtRest));
  terminal.send(":whe\t");
  REQUIRE(terminal.expect("re "));
  terminal.send("\r");
  REQUIRE(terminal.expect("x 0 mm, y 0 mm, theta 0 deg"));
  REQUIRE(terminal.expect(kAtRest));
  terminal.send("spi\t");
  REQUIRE(terminal.expect("SPIRAL "));
  terminal.send(kCtrlC);
  REQUIRE(terminal.expect(kAtRest));
  terminal.send("MOVE(10,0,0) A\t");
  REQUIRE(terminal.expect("ACCEL  AT"));
  REQUIRE(terminal.expect("MOVE(10,0,0) A"));
}

TEST_CASE("HALT and ASK take the next line; a colon command is none") {
  const Desk desk;
  PseudoTerminal terminal({ROB_BINARY}, desk.options());
  INFO(terminal.raw());
  REQUIRE(terminal.expect(kAtRest));
  terminal.send("VAR n : INT\rASK \"how many?\" INTO n\r");
  REQUIRE(terminal.expect("how many?\r\n"));
  REQUIRE(terminal.expect("? "));
  terminal.send(":law newton\r");
  REQUIRE(terminal.expect(":law takes paul or lookahead"));
  REQUIRE(terminal.expect("? "));
  terminal.send("20\r");
  REQUIRE(terminal.expect(kAtRest));
  terminal.send("PRINT n + 1\rHALT\r");
  REQUIRE(terminal.expect("21\r\n"));
  REQUIRE(terminal.expect("Enter goes on"));
  terminal.send("\rPRINT 7 * 7\r");
  CHECK(terminal.expect("49\r\n"));
}

TEST_CASE("an answer that looks like a block opens none; a command acts while one is open") {
  const Desk desk;
  PseudoTerminal terminal({ROB_BINARY}, desk.options());
  INFO(terminal.raw());
  REQUIRE(terminal.expect(kAtRest));
  terminal.send("VAR name = \"\"\rASK \"who?\" INTO name\r");
  REQUIRE(terminal.expect("who?\r\n"));
  REQUIRE(terminal.expect("? "));
  terminal.send("LOOP\r");
  REQUIRE(terminal.expect(kAtRest));
  terminal.send("FOR i = 1 TO 1 DO\r:law\r");
  REQUIRE(terminal.expect("paul\r\n"));
  terminal.send("PRINT name + \"ed\"\rENDFOR\r");
  CHECK(terminal.expect("LOOPed\r\n"));
}

TEST_CASE("the history lasts from one session to the next") {
  const Desk desk;
  {
    PseudoTerminal terminal({ROB_BINARY}, desk.options());
    INFO(terminal.raw());
    REQUIRE(terminal.expect(kAtRest));
    terminal.send("PRINT 100 + 11\r");
    REQUIRE(terminal.expect("111\r\n"));
    terminal.send(":quit\r");
    CHECK(terminal.wait() == 0);
    CHECK(terminal.modes_as_found());
  }
  CHECK(read_whole_file(desk.folder.path() / "states" / "rob" / "history") ==
        "PRINT 100 + 11\n:quit\n");
  PseudoTerminal terminal({ROB_BINARY}, desk.options());
  REQUIRE(terminal.expect(kAtRest));
  terminal.send(std::string(kUp) + kUp);
  REQUIRE(terminal.expect("PRINT 100 + 11"));
  terminal.send("\r");
  CHECK(terminal.expect("111\r\n"));
}

TEST_CASE("Ctrl-D in motion: the robot comes to rest first") {
  const Desk desk;
  PseudoTerminal terminal({ROB_BINARY}, desk.options());
  INFO(terminal.raw());
  REQUIRE(terminal.expect(kAtRest));
  terminal.send("MOVE(100,0,0)\r");
  REQUIRE(terminal.expect("gantry moving"));
  terminal.send(kCtrlD);
  CHECK(terminal.expect("the robot comes to rest first"));
  CHECK(terminal.wait() == 0);
  CHECK(terminal.modes_as_found());
}

TEST_CASE("a second Ctrl-C brakes as hard as the axes can, and takes the force away") {
  const Desk desk;
  PseudoTerminal terminal({ROB_BINARY}, desk.options());
  INFO(terminal.raw());
  REQUIRE(terminal.expect(kAtRest));
  terminal.send("MOVE(100,0,0)\r");
  REQUIRE(terminal.expect("gantry moving"));
  terminal.watch(2s);  // it has its full speed
  terminal.send(kCtrlC);
  terminal.watch(60ms);
  terminal.send(kCtrlC);
  CHECK(terminal.expect("the drives are without force"));
  CHECK(terminal.expect("fault"));
  terminal.send("MOVE(0,0,0)\r");
  CHECK(terminal.expect("the robot has stopped for good"));
  terminal.send(":reset\r");
  REQUIRE(terminal.expect("gantry idle ("));
  terminal.send(kCtrlD);
  CHECK(terminal.wait() == 0);
}

TEST_CASE("whatever ends the prompt, the exit code tells it and the terminal is as it was") {
  struct End {
    int signal;
    int exit_code;
  };
  for (const End end :
       {End{SIGTERM, 143}, End{SIGHUP, 129}, End{SIGUSR1, 138}, End{SIGSEGV, 128 + SIGSEGV}}) {
    CAPTURE(end.signal);
    const Desk desk;
    PseudoTerminal terminal({ROB_BINARY}, desk.options());
    INFO(terminal.raw());
    REQUIRE(terminal.expect(kAtRest));
    CHECK(!terminal.modes_as_found());
    terminal.send("MOVE(100,0,0)\r");
    REQUIRE(terminal.expect("gantry moving"));
    terminal.signal(end.signal);
    CHECK(terminal.wait() == end.exit_code);
    CHECK(terminal.modes_as_found());
  }
}

TEST_CASE("a terminal that goes away in motion is a hang-up") {
  const Desk desk;
  PseudoTerminal terminal({ROB_BINARY}, desk.options());
  INFO(terminal.raw());
  REQUIRE(terminal.expect(kAtRest));
  terminal.send("MOVE(100,0,0)\r");
  REQUIRE(terminal.expect("gantry moving"));
  terminal.hang_up();
  CHECK(terminal.wait() == 129);
}

TEST_CASE("the pendant takes the screen, and gives it back to the prompt; SIGTERM ends both") {
  const Desk desk;
  PseudoTerminal terminal({ROB_BINARY}, desk.options());
  INFO(terminal.raw());
  REQUIRE(terminal.expect(kAtRest));
  terminal.send(":jog\r");
  REQUIRE(terminal.expect("\033[?1049h"));
  terminal.watch(700ms);  // it asks the terminal for its keyboard, and gets no answer
  terminal.send("q");
  REQUIRE(terminal.expect("\033[?1049l"));
  REQUIRE(terminal.expect(kAtRest));
  terminal.send("PRINT 6 * 111\r");
  REQUIRE(terminal.expect("666\r\n"));
  terminal.send(":jog\r");
  REQUIRE(terminal.expect("\033[?1049h"));
  terminal.signal(SIGTERM);
  CHECK(terminal.wait() == 143);
  CHECK(terminal.modes_as_found());
}

TEST_CASE("SIGTERM ends a prompt whose robot is held") {
  const Desk desk;
  PseudoTerminal terminal({ROB_BINARY}, desk.options());
  INFO(terminal.raw());
  REQUIRE(terminal.expect(kAtRest));
  terminal.send("MOVE(100,0,0)\r:hold\r");
  REQUIRE(terminal.expect("gantry held"));
  terminal.signal(SIGTERM);
  CHECK(terminal.wait() == 143);
  CHECK(terminal.modes_as_found());
}

TEST_CASE("a prompt that is killed is told by the next one, once") {
  const Desk desk;
  {
    PseudoTerminal terminal({ROB_BINARY}, desk.options());
    INFO(terminal.raw());
    REQUIRE(terminal.expect(kAtRest));
    terminal.signal(SIGKILL);
    CHECK(terminal.wait() == 128 + SIGKILL);
  }
  PseudoTerminal terminal({ROB_BINARY}, desk.options());
  INFO(terminal.raw());
  CHECK(terminal.expect("unclean end: the run of the prompt on gantry"));
  REQUIRE(terminal.expect(kAtRest));
  terminal.send(kCtrlD);
  CHECK(terminal.wait() == 0);
  PseudoTerminal next({ROB_BINARY}, desk.options());
  REQUIRE(next.expect(kAtRest));
  CHECK(next.raw().find("unclean") == std::string::npos);
}

TEST_CASE("no colours where they are not wanted, and no control sequences on a dumb terminal") {
  const Desk desk;
  const auto session = [&](const PseudoTerminal::Options& options) {
    PseudoTerminal terminal({ROB_BINARY}, options);
    REQUIRE(terminal.expect("gantry idle (0, 0, 0)"));
    terminal.send("PRINT 1000 + 1\r");
    REQUIRE(terminal.expect("1001\r\n"));
    terminal.send(kCtrlD);
    CHECK(terminal.wait() == 0);
    return terminal.raw();
  };
  CHECK(session(desk.coloured()).find("\033[32mgantry idle (0, 0, 0)\033[0m> ") !=
        std::string::npos);
  CHECK(session(desk.options("xterm-256color")).find("\033[32m") == std::string::npos);
  PseudoTerminal::Options without = desk.coloured();
  without.environment["TERM"] = "vt100";  // terminfo knows none of it
  CHECK(session(without).find("\033[32m") == std::string::npos);
  CHECK(session(desk.options("dumb")).find('\033') == std::string::npos);
}

TEST_CASE("errors are red and warnings yellow, at the prompt and of all commands") {
  const Desk desk;
  PseudoTerminal prompt({ROB_BINARY}, desk.coloured());
  REQUIRE(prompt.expect("gantry idle (0, 0, 0)"));
  prompt.send("MOVE(9000,0,0)\r");
  CHECK(prompt.expect("prompt:1:5: \033[31merror[E401]:\033[0m axis x"));
  prompt.send(":nothing\r");
  CHECK(prompt.expect("\033[31merror:\033[0m there is no command"));
  std::ofstream(desk.folder.path() / "wrong.rob") << "MOVE(9000,0,0)\n";
  PseudoTerminal check({ROB_BINARY, "check", "wrong.rob"}, desk.coloured());
  CHECK(check.expect("wrong.rob:1:5: \033[31merror[E401]:\033[0m axis x"));
  CHECK(check.wait() == 65);
  PseudoTerminal plain({ROB_BINARY, "check", "wrong.rob"}, desk.options());
  CHECK(plain.expect("wrong.rob:1:5: error[E401]: axis x"));
  CHECK(plain.wait() == 65);
}

TEST_CASE("where the locale is not UTF-8 the terminal gets ASCII alone") {
  const Desk desk;
  PseudoTerminal::Options plain = desk.options();
  plain.environment["LC_ALL"] = "C";
  PseudoTerminal terminal({ROB_BINARY}, plain);
  INFO(terminal.raw());
  REQUIRE(terminal.expect(kAtRest));
  terminal.send("LOOP\r");
  REQUIRE(terminal.expect("... "));
  terminal.send("GOTO 3\r");
  REQUIRE(terminal.expect("LOOP ... ENDLOOP repeats"));
  terminal.send(kCtrlC);
  REQUIRE(terminal.expect("^C"));
  terminal.send(":jog\r");
  REQUIRE(terminal.expect("<- -> x"));
  terminal.send("q");
  REQUIRE(terminal.expect(kAtRest));
  terminal.send(kCtrlD);
  CHECK(terminal.wait() == 0);
  CHECK(std::ranges::all_of(terminal.raw(), [](char c) { return (c & 0x80) == 0; }));
}

TEST_CASE(":frame at a terminal: Enter takes where the robot stands, Ctrl-C leaves") {
  const Desk desk;
  PseudoTerminal terminal({ROB_BINARY, "--fast"}, desk.options());
  INFO(terminal.raw());
  REQUIRE(terminal.expect(kAtRest));
  terminal.send(":frame table\r");
  REQUIRE(terminal.expect("table: move to its origin, then Enter"));
  terminal.send("\r");
  REQUIRE(terminal.expect("table: move to a place on its x axis"));
  terminal.send(kCtrlC);
  REQUIRE(terminal.expect("table is left as it was"));
  terminal.send(":frame table\r");
  REQUIRE(terminal.expect("table: move to its origin, then Enter"));
  terminal.send("\r");
  REQUIRE(terminal.expect("on its x axis"));
  terminal.send("MOVE(100, 0, 0)\r");
  REQUIRE(terminal.expect("idle (100, 0, 0)"));
  terminal.send("\r");
  REQUIRE(terminal.expect("in its xy plane"));
  terminal.send("MOVE(0, 100, 0)\r");
  REQUIRE(terminal.expect("idle (0, 100, 0)"));
  terminal.send("\r");
  REQUIRE(terminal.expect("FRAME table = FRAME3("));
  terminal.send("table.c\r");
  REQUIRE(terminal.expect("0deg"));
  terminal.send(kCtrlD);
  CHECK(terminal.wait() == 0);
}
