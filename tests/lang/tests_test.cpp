#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "tests/lang/program_run.h"

using rob::lang::Vm;
using rob::test::ProgramRun;

namespace {

using Texts = std::vector<std::string>;

/// What TEST number `test` asks of the machine.
Texts calls_of(const std::string& source, std::size_t test = 0) {
  ProgramRun run(source);
  REQUIRE(run.compiled());
  run.vm().choose_test(test);
  run.finish();
  return run.machine().texts();
}

}  // namespace

TEST_CASE("a TEST executes the declarations of the program, and none of its statements") {
  CHECK(calls_of("VAR n = 2\nPRINT 1\nn = 5\nCONST m = n + 1\nTEST \"a\"\nPRINT n, m\nENDTEST") ==
        Texts{"print 23", "end"});
}

TEST_CASE("each TEST can be chosen, and sees the routines") {
  const std::string source =
      "VAR s = \"x\"\nTEST \"a\"\nshow(1)\nENDTEST\nPROC show(n: INT)\nPRINT s, n\nENDPROC\n"
      "TEST \"b\"\nVAR t = \"y\"\nshow(2)\nPRINT t\nENDTEST";
  CHECK(calls_of(source, 0) == Texts{"print x1", "end"});
  CHECK(calls_of(source, 1) == Texts{"print x2", "print y", "end"});
}

TEST_CASE("an EXPECT that does not hold tells both sides, and the TEST goes on") {
  CHECK(
      calls_of("VAR n = 2\nVAR s = \"a\"\nTEST \"a\"\nEXPECT n == 3\nEXPECT n == 2\n"
               "EXPECT 3mm > n * 2mm\nEXPECT s <> \"a\"\nEXPECT n > 1 AND lift_up\nEXPECT lift_up\n"
               "EXPECT n >= 2.5\nENDTEST") ==
      Texts{"failed n == 3 does not hold: left 2, right 3",
            "failed 3mm > n * 2mm does not hold: left 3mm, right 4mm",
            "failed s <> \"a\" does not hold: left a, right a",
            "failed n > 1 AND lift_up does not hold", "failed lift_up does not hold",
            "failed n >= 2.5 does not hold: left 2, right 2.5", "end"});
}

TEST_CASE("an EXPECT of compound values is compared as a whole") {
  CHECK(calls_of("VAR v = (1mm, 2mm, 3mm)\nTEST \"a\"\nVAR w = v\nEXPECT v == w\n"
                 "EXPECT v == w + w\nENDTEST") == Texts{"failed v == w + w does not hold", "end"});
}

TEST_CASE("SIMULATE hands an input its value and its delay") {
  CHECK(
      calls_of("VAR t = 2s\nTEST \"a\"\nSIMULATE lift_up = t > 1s AFTER t\nSIMULATE DIN[1] = OFF\n"
               "SIMULATE AIN[1] = 2.5V AFTER 0.5s\nENDTEST") ==
      Texts{"simulate lift_up 1 after 2s", "simulate DIN[1] 0 after 0s",
            "simulate AIN[1] 2.5 after 0.5s", "end"});
}

TEST_CASE("SIMULATE sets one part of what a force sensor feels") {
  rob::lang::RobotSignature robot = rob::test::gantry_signature();
  robot.force_sensor = true;
  ProgramRun run(
      "TEST \"a\"\nSIMULATE force.z = 2 * 2.5N AFTER 2s\nSIMULATE Torque.X = 1Nm\n"
      "ZERO force\nENDTEST",
      robot);
  REQUIRE(run.compiled());
  run.vm().choose_test(0);
  run.finish();
  CHECK(run.machine().texts() == Texts{"simulate force.z 5N after 2s",
                                       "simulate torque.x 1Nm after 0s", "zero force", "end"});
}

TEST_CASE("SIMULATE of the past is an error of the TEST") {
  ProgramRun run("VAR t = 2s\nTEST \"a\"\nSIMULATE lift_up = ON AFTER t - 3s\nENDTEST");
  REQUIRE(run.compiled());
  run.vm().choose_test(0);
  CHECK(run.finish() == Vm::State::Failed);
  CHECK(run.vm().error().code == "E351");
  CHECK(run.vm().error().message == "AFTER turned out to be -1s");
}

TEST_CASE("RETURN leaves a TEST") {
  CHECK(calls_of("TEST \"a\"\nIF TRUE THEN RETURN\nPRINT 1\nENDTEST") == Texts{"end"});
}
