// `rob` as a filter: statements from standard input, on the virtual clock.

#include <doctest/doctest.h>

#include <string>

#include "tests/support/rob_command.h"

using rob::test::ProcessResult;
using rob::test::RobCommand;
using rob::test::run_process;

namespace {

/// In a folder of its own: that is where TEACH keeps points.
ProcessResult piped(const std::string& text, const std::string& options = "--fast") {
  const RobCommand command(text);
  return run_process(
      {"/bin/sh", "-c",
       "cd \"" + command.file("") + "\" && exec \"" ROB_BINARY "\" " + options + " < test.rob"});
}

}  // namespace

TEST_CASE("statements of a pipe are carried out, and its end is the end of the program") {
  const ProcessResult result = piped("MOVE(40,40,0)\nSTOP\nPRINT HERE\nMOVE(0,0,0)");
  CHECK(result.exit_code == 0);
  CHECK(result.out == "POSE(40mm, 40mm, 0mm, 0deg, 0deg, 0deg)\n");
  CHECK(result.err == "");
}

TEST_CASE("a pipe ends at its first error, and the exit code says of which kind it was") {
  constexpr const char* kRest = "what follows in the input is not executed";
  const ProcessResult wrong = piped("PRINT 1\nMOVE(9000,0,0)\nPRINT 2\n");
  CHECK(wrong.exit_code == 65);
  CHECK(wrong.out == "1\n");
  CHECK(wrong.err.find("E401") != std::string::npos);
  CHECK(wrong.err.find(kRest) != std::string::npos);
  CHECK(wrong.err.find('\x1b') == std::string::npos);  // no colours

  const ProcessResult failed = piped("RAISE \"enough\"\nPRINT 2\n");
  CHECK(failed.exit_code == 70);
  CHECK(failed.out == "");
  const ProcessResult command = piped(":nonsense\nPRINT 2\n");
  CHECK(command.exit_code == 65);
  CHECK(command.out == "");
  const ProcessResult file = piped(":load missing.rob\nPRINT 2\n");
  CHECK(file.exit_code == 74);
  CHECK(file.out == "");
  CHECK(piped("FOR i = 1 TO 2 DO\n:nonsense\n  PRINT i\nENDFOR\n").out == "");
  CHECK(piped("PRINT 1\nMOOVE").err.find(kRest) == std::string::npos);  // nothing follows
}

TEST_CASE("what was commanded before the error of a pipe is carried out to its end") {
  CHECK(piped("MOVE(40,0,0)\nSTOP\nPRINT HERE\nMOOVE\n", "").out ==
        "POSE(40mm, 0mm, 0mm, 0deg, 0deg, 0deg)\n");
}

TEST_CASE("with --keep-going a pipe is carried out to its end") {
  const std::string options = "--fast --keep-going";
  const ProcessResult wrong = piped("MOVE(9000,0,0)\nPRINT 1\n", options);
  CHECK(wrong.exit_code == 65);
  CHECK(wrong.out == "1\n");
  const ProcessResult failed = piped("RAISE \"enough\"\nPRINT 2\n", options);
  CHECK(failed.exit_code == 70);
  CHECK(failed.out == "2\n");
  CHECK(piped(":nonsense\nPRINT 1\n", options).exit_code == 64);
  CHECK(piped(":nonsense\nMOOVE\n", options).exit_code == 65);
  CHECK(piped("MOOVE\nRAISE \"x\"\n:nonsense\n", options).exit_code == 70);
}

TEST_CASE("a :stop in a pipe is no error, and what follows comes when the robot stands") {
  const ProcessResult result = piped("MOVE(400,0,0)\n:stop\nPRINT 3\n");
  CHECK(result.exit_code == 0);
  CHECK(result.out == "3\n");
}

TEST_CASE("a block that a pipe leaves open is an error") {
  const ProcessResult result = piped("FOR i = 1 TO 3 DO\n  PRINT i\n");
  CHECK(result.exit_code == 65);
  CHECK(result.out == "");
  CHECK(result.err.find("the FOR of line 1 is not closed") != std::string::npos);
}

TEST_CASE("END in a pipe is STOP, and :quit leaves the rest unread") {
  CHECK(piped("MOVE(40,0,0)\nEND\nPRINT 1\n:quit\nPRINT 2\n").out == "1\n");
}

TEST_CASE("what is no text of statements is refused, and ends nothing but the prompt") {
  const ProcessResult endless =
      run_process({"/bin/sh", "-c", "exec \"" ROB_BINARY "\" --fast < /dev/zero"});
  CHECK(endless.exit_code == 74);
  CHECK(endless.err == "error: a line of more than 67108864 bytes; at most 1048576 are read\n");
  for (const std::size_t size : {std::size_t{1'048'577}, std::size_t{3'000'000}}) {
    const ProcessResult longer = piped("PRINT 1\n" + std::string(size, ' ') + "\nPRINT 2\n");
    CHECK(longer.exit_code == 74);
    CHECK(longer.out == "1\n");
    CHECK(longer.err.find("a line of " + std::to_string(size) + " bytes") != std::string::npos);
  }
  const ProcessResult folder = run_process({"/bin/sh", "-c", "exec \"" ROB_BINARY "\" --fast < /"});
  CHECK(folder.exit_code == 74);
  CHECK(folder.err.starts_with("error: standard input cannot be read: "));
  const ProcessResult unanswered = piped("HALT \"go on?\"\n");
  CHECK(unanswered.exit_code == 70);
}

TEST_CASE("a pipe runs under the robot and the law that it is given") {
  const ProcessResult result = piped(":robot\n", "--fast --robot irb120");
  CHECK(result.out == "irb120, law paul\n");
  CHECK(piped(":law lookahead\n:robot\n").out == "gantry, law lookahead\n");
  // The same robot stands where it stood.
  const ProcessResult law = piped("VAR n = 1\nMOVE(40,40,0)\n:law lookahead\nPRINT HERE\n");
  CHECK(law.out == "POSE(40mm, 40mm, 0mm, 0deg, 0deg, 0deg)\n");
  CHECK(law.err == "what was declared at the prompt is gone\n");
  CHECK(piped("PRINT 1\n", "--fast --robot nobody").exit_code == 65);
  const ProcessResult other = piped(":robot nobody\nPRINT 1\n", "--fast --keep-going");
  CHECK(other.out == "1\n");
  CHECK(other.err.starts_with("error: "));
}

TEST_CASE("a command acts while a block is open, and the block goes on") {
  const ProcessResult result = piped("FOR i = 1 TO 2 DO\n:Law\n  PRINT i\n:LAW\nENDFOR\n");
  CHECK(result.exit_code == 0);
  CHECK(result.out == "paul\npaul\n1\n2\n");
}

TEST_CASE("an input that ends while the robot is held is an error, and the process ends") {
  for (const std::string text : {"MOVE(10,0,0)\n:hold\n", "MOVE(10,0,0)\n:hold\n:quit\n",
                                 ":insert 1 MOVE(9,0,0)\n:insert 2 MOVE(9,9,0)\n:step\n:back\n"}) {
    for (const std::string options : {"--fast", "--fast --law lookahead", ""}) {
      CAPTURE(text);
      CAPTURE(options);
      const ProcessResult result = piped(text, options);
      CHECK(result.exit_code == 70);
      CHECK(result.err.find("the robot is held") != std::string::npos);
    }
  }
  CHECK(piped(":hold\n").exit_code == 0);  // nothing is under way
}
