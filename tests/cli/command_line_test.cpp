// What the words of a command line mean, and what is said of those that mean nothing.

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "tests/support/rob_command.h"

using rob::test::contains;
using rob::test::ProcessResult;
using rob::test::RobCommand;
using rob::test::run_process;

namespace {

ProcessResult rob_with(std::vector<std::string> words) {
  words.insert(words.begin(), ROB_BINARY);
  return run_process(words);
}

/// What is said of a command line that is refused.
std::string refusal(const std::vector<std::string>& words) {
  const ProcessResult result = rob_with(words);
  CHECK(result.exit_code == 64);
  CHECK(result.out == "");
  return result.err.substr(0, result.err.find('\n'));
}

/// `rob WORDS < program`
ProcessResult with_input(const RobCommand& rob, const std::string& words) {
  return run_process(
      {"/bin/sh", "-c", "exec \"" ROB_BINARY "\" " + words + " < \"" + rob.program() + "\""});
}

}  // namespace

TEST_CASE("a mistyped command or option is told with the nearest one") {
  CHECK(refusal({"rnu", "a.rob"}) == "rob: there is no command 'rnu'; did you mean run?");
  CHECK(refusal({"--fsat"}) == "rob: there is no option --fsat; did you mean --fast?");
  CHECK(refusal({"run", "a.rob", "--fsat"}) ==
        "rob: there is no option --fsat of rob run; did you mean --fast?");
  CHECK(refusal({"check", "a.rob", "--jsno=1"}) ==
        "rob: there is no option --jsno of rob check; did you mean --json?");
  CHECK(refusal({"elephant"}) == "rob: there is no command 'elephant'");
  CHECK(refusal({"ports", "all"}) == "rob: rob ports takes no 'all'");
  CHECK(refusal({"robot"}) == "rob: rob robot takes a command; rob robot import");
  CHECK(refusal({"robot", "imprt"}) == "rob: rob robot takes no 'imprt'; did you mean import?");
  CHECK(refusal({"robot", "import", "a.urdf", "--tpi", "b", "-o", "c.toml"}) ==
        "rob: there is no option --tpi of rob robot import; did you mean --tip?");
}

TEST_CASE("a program is run without the word run") {
  const RobCommand rob("PRINT 6 * 7\n");
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{rob.program(), "--fast"},
        {"--fast", rob.program()},
        {"--robot", "gantry", "--override=50%", "--fast", rob.program()}}) {
    const ProcessResult result = rob_with(words);
    CHECK(result.exit_code == 0);
    CHECK(result.out.starts_with("42\n"));
  }
}

TEST_CASE("- is standard input") {
  const RobCommand rob("print 6*7\nMOVE(9000, 0, 0)\n");
  const ProcessResult run = with_input(rob, "run - --fast");
  CHECK(run.exit_code == 65);
  CHECK(run.err.starts_with("-:2:5: error[E401]"));
  CHECK(contains(run.err, "  MOVE(9000, 0, 0)\n"));
  CHECK(with_input(rob, "--fast -").exit_code == 65);

  const RobCommand sound("print 6*7\n");
  CHECK(with_input(sound, "run - --fast").out.starts_with("42\n"));
  CHECK(with_input(sound, "- --fast").out.starts_with("42\n"));
  CHECK(with_input(sound, "check -").exit_code == 0);
  CHECK(with_input(sound, "fmt -").out == "PRINT 6 * 7\n");
  CHECK(with_input(sound, "fmt - --check").exit_code == 65);
}

TEST_CASE("rob help lists the commands, as --help does") {
  const ProcessResult help = rob_with({"help"});
  CHECK(help.exit_code == 0);
  for (const char* const command : {"  run ", "  check ", "  robots ", "  fmt "})
    CHECK(contains(help.out, command));
  CHECK(rob_with({"--help"}).out == help.out);
}
