// `rob fmt` and `rob help WORD` from outside.
#include <doctest/doctest.h>

#include "tests/support/rob_command.h"

using rob::test::contains;
using rob::test::ProcessResult;
using rob::test::read_whole_file;
using rob::test::RobCommand;
using rob::test::run_process;

TEST_CASE("rob fmt reads what a file USEs: a name of it may look like a statement misspelt") {
  const RobCommand rob("USE hand\ntake(\"a cap\")\n");  // BRAKE is near
  CHECK(rob("fmt", {"--check"}).exit_code == 65);
  std::ofstream(rob.file("hand.rob")) << "PROC take(what: STRING)\nENDPROC\n";
  CHECK(rob("fmt", {"--check"}).exit_code == 0);
  const RobCommand alone("take(\"a cap\")\n");
  CHECK(alone("fmt", {"--check"}).exit_code == 65);
}

TEST_CASE("rob fmt leaves a file with any error as it is, formats the others and says why") {
  struct Wrong {
    const char* text;
    const char* code;
  };
  constexpr Wrong kWrong[] = {
      {"move(1,2\n", "E125"},                    // a bracket
      {"print  x\n", "E201"},                    // a name
      {"var x=1mm+1s\n", "E207"},                // dimensions
      {"var n:INT=2.5\n", "E206"},               // a type
      {"move(9000,40,0)\n", "E401"},             // a target
      {"use  nowhere\n", "E180"},                // a file
      {"robot \"nobody\"\nmove(1,2,3)\n", "E"},  // a robot
      {"func f():INT\nendfunc\n", "E244"},       // a RETURN
      {"for i=1 to 3 do\n", "E138"},             // a block
      {"const c=1/0\n", "E302"},                 // a value
      {"signal s=DIN[99]\n", "E226"},            // a channel
      {"move(1,2,3)accel 50mm/s^2\n", "E550"},   // what its law has not
  };
  for (const Wrong& wrong : kWrong) {
    CAPTURE(wrong.text);
    const RobCommand rob(wrong.text);
    std::ofstream(rob.file("before.rob")) << "stop";
    std::ofstream(rob.file("behind.rob")) << "stop";
    const ProcessResult result = run_process(
        {ROB_BINARY, "fmt", rob.file("before.rob"), rob.program(), rob.file("behind.rob")});
    CHECK(result.exit_code == 65);
    CHECK(contains(result.err, "test.rob:"));
    CHECK(contains(result.err, std::string("error[") + wrong.code));
    CHECK(read_whole_file(rob.program()) == wrong.text);
    CHECK(read_whole_file(rob.file("before.rob")) == "STOP\n");
    CHECK(read_whole_file(rob.file("behind.rob")) == "STOP\n");
    CHECK(rob("fmt", {"--check"}).exit_code == 65);
  }
}

TEST_CASE("rob fmt checks a file for the robot and the law that the command line names") {
  const RobCommand arm("move(350,0,400,180,0,180)\n");
  CHECK(arm("fmt").exit_code == 65);
  CHECK(arm("fmt", {"--robot", "irb120"}).exit_code == 0);
  CHECK(read_whole_file(arm.program()) == "MOVE(350, 0, 400, 180, 0, 180)\n");
  const RobCommand fast("move(40,40,0)accel 50mm/s^2\n");
  CHECK(fast("fmt").exit_code == 65);
  CHECK(fast("fmt", {"--law", "lookahead"}).exit_code == 0);
}

TEST_CASE("rob fmt leaves a file alone that USEs one with errors, and names that one") {
  const RobCommand rob("use tools\nstop\n");
  std::ofstream(rob.file("tools.rob")) << "const c=1mm+1s\n";
  const ProcessResult result = rob("fmt");
  CHECK(result.exit_code == 65);
  CHECK(contains(result.err, "tools.rob:1:"));
  CHECK(read_whole_file(rob.program()) == "use tools\nstop\n");
  CHECK(read_whole_file(rob.file("tools.rob")) == "const c=1mm+1s\n");
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
