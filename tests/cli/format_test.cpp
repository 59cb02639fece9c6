// `rob fmt` and `rob help WORD` from outside.
#include <doctest/doctest.h>

#include "tests/support/rob_command.h"

using rob::test::contains;
using rob::test::ProcessResult;
using rob::test::read_whole_file;
using rob::test::RobCommand;
using rob::test::run_process;

TEST_CASE(
    "rob fmt does not read what a file USEs: a name of it may look like a statement misspelt") {
  const RobCommand rob("USE hand\ntake(\"a cap\")\n");  // BRAKE is near
  CHECK(rob("fmt", {"--check"}).exit_code == 0);
  const RobCommand alone("take(\"a cap\")\n");
  CHECK(alone("fmt", {"--check"}).exit_code == 65);
}

TEST_CASE("rob fmt gives a file its layout, once and for all") {
  const RobCommand rob("move(1,2,3)at 50%\r\n\r\n\r\nstop");
  const ProcessResult check = rob("fmt", {"--check"});
  CHECK(check.exit_code == 65);
  CHECK(check.out == rob.program() + "\n");
  CHECK(read_whole_file(rob.program()) == "move(1,2,3)at 50%\r\n\r\n\r\nstop");
  const ProcessResult done = rob("fmt");
  CHECK(done.exit_code == 0);
  CHECK(done.out.empty());
  CHECK(read_whole_file(rob.program()) == "MOVE(1, 2, 3) AT 50%\n\nSTOP\n");
  CHECK(rob("fmt", {"--check"}).exit_code == 0);
}

TEST_CASE("a file with errors is left as it is and does not keep others from being done") {
  const RobCommand rob("move(1,2\n");
  std::ofstream(rob.file("good.rob")) << "stop";
  const ProcessResult result = rob("fmt", {rob.file("none.rob"), rob.file("good.rob")});
  CHECK(result.exit_code == 65);
  CHECK(contains(result.err, "test.rob:1:9: error[E125]"));
  CHECK(contains(result.err, "cannot read '" + rob.file("none.rob") + "'"));
  CHECK(read_whole_file(rob.program()) == "move(1,2\n");
  CHECK(read_whole_file(rob.file("good.rob")) == "STOP\n");
}

TEST_CASE("rob help explains commands, words and codes, and knows misspelt ones") {
  const auto help = [](const std::string& word) { return run_process({ROB_BINARY, "help", word}); };
  CHECK(contains(help("fmt").out, "--check"));
  CHECK(contains(help("move").out, "MOVE(140, 40, 0)"));
  CHECK(contains(help("E207").out, "E207: a quantity of the wrong dimension"));
  CHECK(contains(help("e502").out, "an axis is too far from its reference"));
  const ProcessResult unknown = help("MOOVE");
  CHECK(unknown.exit_code == 64);
  CHECK(contains(unknown.err, "did you mean MOVE?"));
}
