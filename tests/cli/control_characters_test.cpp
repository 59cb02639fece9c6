// Names and texts of others on a terminal: shown, not sent. A pipe gets the bytes.
#include <doctest/doctest.h>

#include <fstream>
#include <string>
#include <vector>

#include "tests/support/pseudo_terminal.h"
#include "tests/support/rob_command.h"

using namespace rob::test;

namespace {

/// What changes the title of a window, a CSI of one character (C1), and what turns the writing.
const std::string kTitle = "\x1b]0;forged\x07";
const std::string kC1 =
    "\xC2\x9B"
    "31m";
const std::string kTurned = "\xE2\x80\xAE";
const std::string kBytes = kTitle + kC1 + kTurned + "\x7f";
constexpr const char* kShown = "\\u{1B}]0;forged\\u{7}\\u{9B}31m\\u{202E}\\u{7F}";
/// The same as a program writes it.
constexpr const char* kWritten = "\\u{1b}]0;forged\\u{7}\\u{9b}31m\\u{202e}\\u{7f}";

/// All that a terminal gets of a run to its end; `keys` are typed when `asked` has been shown.
std::string on_terminal(const std::vector<std::string>& arguments, const std::string& asked = "",
                        const std::string& keys = "") {
  PseudoTerminal terminal(arguments, {"", {{"TERM", "vt100"}, {"LC_ALL", "C.UTF-8"}}});
  if (!keys.empty()) {
    CHECK(terminal.expect(asked));
    terminal.send(keys);
  }
  CHECK(terminal.wait() >= 0);
  return terminal.raw();
}

void check_shown(const std::string& raw) {
  CAPTURE(raw);
  CHECK(contains(raw, kShown));
  CHECK_FALSE(contains(raw, "\x1b]0"));
  CHECK_FALSE(contains(raw, "\xC2\x9B"));
  CHECK_FALSE(contains(raw, kTurned));
  CHECK_FALSE(contains(raw, "\x7f"));
}

}  // namespace

TEST_CASE("what a program prints is shown on a terminal, and a pipe gets its bytes") {
  const RobCommand rob("PRINT \"a\\n" + std::string(kWritten) + "\\tb\"\n");
  const std::string raw = on_terminal(rob.line("run", {"--fast"}));
  check_shown(raw);
  CHECK(contains(raw, "a\r\n"));  // line ends and tabs are what the program means
  CHECK(contains(raw, "\tb"));
  CHECK(contains(rob("run", {"--fast"}).out, "a\n" + kBytes + "\tb\n"));
}

TEST_CASE("texts of HALT and ASK are shown on a terminal") {
  const RobCommand halt(std::string("HALT \"") + kWritten + "\"\n");
  check_shown(on_terminal(halt.line("run"), kShown, "\r"));
  const RobCommand ask(std::string("VAR n = 1\nASK \"") + kWritten + "\" INTO n\n");
  check_shown(on_terminal(ask.line("run", {"--fast"}), kShown, "7\r"));
}

TEST_CASE("names of files are shown on a terminal, and a pipe gets their bytes") {
  const RobCommand rob("STOP\n");
  const std::string missing = rob.file("no" + kBytes + ".rob");
  check_shown(on_terminal({ROB_BINARY, "run", missing}));
  CHECK(contains(run_process({ROB_BINARY, "run", missing}).err, missing));
  const std::string wrong = rob.file("wrong" + kBytes + ".rob");
  std::ofstream(wrong) << "PRINT x\n";
  for (const char* const command : {"run", "check", "compile", "test", "fmt"}) {
    CAPTURE(command);
    check_shown(on_terminal({ROB_BINARY, command, wrong}));
    CHECK(contains(run_process({ROB_BINARY, command, wrong}).err, wrong + ":1:7: error[E201]"));
  }
  std::ofstream(wrong, std::ios::trunc) << "stop";
  check_shown(on_terminal({ROB_BINARY, "fmt", "--check", wrong}));
  CHECK(run_process({ROB_BINARY, "fmt", "--check", wrong}).out == wrong + "\n");
}

TEST_CASE("names with line ends cannot forge messages, neither on a terminal nor in a pipe") {
  const RobCommand rob("STOP\n");
  const std::string forged = "rob: all is well";
  const std::string name = rob.file("a\n" + forged + "\n.rob");
  std::ofstream(name) << "PRINT x\nTEST \"t\\n" << forged << "\"\n  EXPECT FALSE\nENDTEST\n";
  const auto forges = [&](const std::string& text) { return contains(text, "\n" + forged); };
  for (const std::string& file :
       {name, rob.file("none\n" + forged), rob.file("none\n" + forged + ".rob")}) {
    for (const char* const command : {"run", "check", "compile", "test", "fmt"}) {
      CAPTURE(command);
      const ProcessResult result = run_process({ROB_BINARY, command, file});
      CHECK_FALSE(forges(result.err));
      CHECK_FALSE(forges(result.out));
      CHECK(contains(result.err, "\\nrob: all is well"));
      CHECK_FALSE(forges(on_terminal({ROB_BINARY, command, file})));
    }
  }
  std::ofstream(name, std::ios::trunc) << "TEST \"t\\n"
                                       << forged << "\"\n  PRINT \"\\n"
                                       << forged << "\"\n  EXPECT FALSE\nENDTEST\n";
  const ProcessResult tests = run_process({ROB_BINARY, "test", name});
  CHECK_FALSE(forges(tests.out));
  CHECK(contains(tests.out, "0 ok, 1 failed"));
  std::ofstream(name, std::ios::trunc) << "stop";
  CHECK_FALSE(forges(run_process({ROB_BINARY, "fmt", "--check", name}).out));
}

TEST_CASE("arguments that a message quotes cannot forge another one") {
  const RobCommand rob("STOP\n");
  const std::string forged = "x\nrob: all is well";
  for (const std::vector<std::string>& more :
       std::vector<std::vector<std::string>>{{"--robot", forged},
                                             {"--robot", forged + ".toml"},
                                             {"--law", forged},
                                             {"--override", forged},
                                             {"--backend", forged},
                                             {"--signals", forged},
                                             {"--trace", "/" + forged + "/none"},
                                             {"--" + forged}}) {
    CAPTURE(more.front());
    const ProcessResult result = rob("run", more);
    CHECK(result.exit_code != 0);
    CHECK_FALSE(contains(result.err, "\nrob: all is well"));
  }
  const ProcessResult help = run_process({ROB_BINARY, "help", forged});
  CHECK(contains(help.err, "x\\nrob: all is well"));
  check_shown(on_terminal({ROB_BINARY, "help", kBytes}));
}

TEST_CASE("a message that quotes a text of the program shows it") {
  const RobCommand rob(std::string("RAISE \"") + kWritten + "\\nrob: all is well\"\n");
  check_shown(on_terminal(rob.line("run", {"--fast"})));
  CHECK_FALSE(contains(rob("run", {"--fast"}).err, "\nrob: all is well"));
  const RobCommand source("PRINT \"" + kBytes + "\" + y\n");
  const ProcessResult result = source("compile");
  CHECK(contains(result.err, std::string("  PRINT \"") + kShown + "\" + y\n"));
  CHECK(contains(result.err, "\n  " + std::string(std::string(kShown).size() + 11, ' ') + "^\n"));
}

TEST_CASE("JSON has no byte in it that a terminal acts on, and means the same") {
  const RobCommand rob(std::string("PRINT \"") + kWritten + "\"\n");
  for (const std::string& text :
       {rob("run", {"--fast", "--json"}).out, on_terminal(rob.line("run", {"--fast", "--json"}))}) {
    for (const std::string& part : {kTitle, kC1, kTurned, std::string("\x7f")})
      CHECK_FALSE(contains(text, part));
    const auto document = nlohmann::json::parse(text.substr(text.find('{')));
    CHECK(document["output"][0] == kBytes);
  }
}

TEST_CASE("texts of a robot file are shown") {
  const RobCommand rob("STOP\n");
  std::ofstream(rob.file("r.toml")) << "name = \"a\\u001b]0;forged\\u0007\\u0000\\u009b\"\n";
  const ProcessResult result = rob("check", {"--robot", rob.file("r.toml")});
  CHECK(contains(result.err, "is no name; write a small letter"));
  const std::string raw = on_terminal(rob.line("check", {"--robot", rob.file("r.toml")}));
  CHECK_FALSE(contains(raw, "\x1b]0"));
  CHECK_FALSE(contains(raw, "\xC2\x9B"));
  CHECK(contains(raw, "\\u001B]0;forged\\u0007\\u0000\\u{9B}"));
}

TEST_CASE("the prompt shows what it prints and what it is told") {
  const ScratchFolder folder;
  PseudoTerminal terminal({ROB_BINARY}, {folder.path().string(),
                                         {{"TERM", "vt100"},
                                          {"LC_ALL", "C.UTF-8"},
                                          {"NO_COLOR", "1"},
                                          {"XDG_STATE_HOME", folder.path().string()}}});
  REQUIRE(terminal.expect("> "));
  terminal.send(std::string("PRINT \"") + kWritten + "\"\r");
  CHECK(terminal.expect(kShown));
  terminal.send(std::string("HALT \"") + kWritten + "\"\r");
  CHECK(terminal.expect(std::string("HALT ") + kShown));
  CHECK(terminal.expect("? "));
  terminal.send("\r");
  terminal.send(":quit\r");
  CHECK(terminal.wait() == 0);
  CHECK_FALSE(contains(terminal.raw(), "\x1b]0"));
  CHECK_FALSE(contains(terminal.raw(), "\xC2\x9B"));
}
