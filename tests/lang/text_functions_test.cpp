#include "lang/values/text_functions.h"

#include <doctest/doctest.h>

#include "tests/lang/program_run.h"

namespace rob::lang {
namespace {

using rob::test::ProgramRun;

std::string of(const std::string& expression) {
  return ProgramRun("PRINT " + expression).printed();
}

TEST_CASE("NUM reads what a program writes as a number, and nothing else") {
  for (const char* text : {"12mm", "", " ", "1,5", "0x10", "inf", "nan", "1e", ".5", "5.", "- 1",
                           "--1", "1 2", "1e+", "\xE2\x82\xAC"}) {
    ProgramRun run("PRINT NUM(\"" + std::string(text) + "\")");
    REQUIRE(run.compiled());
    INFO(text);
    CHECK(run.finish() == Vm::State::Failed);
    CHECK(run.vm().error().code == "E331");
  }
  CHECK(of("NUM(\"1e3\")") == "1000");
  CHECK(of("NUM(\"-1.25E-1\")") == "-0.125");
  CHECK(of("NUM(STR(0.1)) == 0.1") == "TRUE");
}

TEST_CASE("UPPER and LOWER undo each other over the letters of Latin-1") {
  CHECK(of("UPPER(\"\xC3\xA0\xC3\xBE\xC3\xB7\")") == "\xC3\x80\xC3\x9E\xC3\xB7");
  CHECK(of("LOWER(\"\xC3\x80\xC3\x9E\xC3\x97\")") == "\xC3\xA0\xC3\xBE\xC3\x97");
  CHECK(of("LOWER(\"\xC4\x80\")") == "\xC4\x80");  // beyond Latin-1
}

TEST_CASE("the parts that MID takes of a text make it again") {
  CHECK(of("MID(\"a\xC3\xA4\xE2\x82\xAC\", 1, 2) + MID(\"a\xC3\xA4\xE2\x82\xAC\", 3, 1)") ==
        "a\xC3\xA4\xE2\x82\xAC");
}

TEST_CASE("functions on texts take each other's results, in any order of numbers and texts") {
  CHECK(of("MID(STR(FIND(\"abc\", \"c\") * 111), LEN(\"x\"), LEN(\"xy\"))") == "33");
  CHECK(of("STR(LEN(\"abc\") * 1mm, \"mm\", LEN(\"ab\"))") == "3.00");
}

TEST_CASE("an expression that has to wait draws the same random numbers when it starts anew") {
  const std::string source = "IF RANDOM() >= 0 AND lift_up OR lift_down THEN STOP\nPRINT RANDOM()";
  ProgramRun straight(source);
  ProgramRun waiting(source);
  waiting.machine().answer_later(3);
  CHECK(straight.printed() == waiting.printed());
}

TEST_CASE("random numbers hang on the seed and on nothing else") {
  const ProgramRun program("PRINT RANDOM(1, 1000000)");
  const auto printed = [&](std::uint64_t seed) {
    const RobotSignature robot = rob::test::gantry_signature();
    PrintingMachine machine(robot);
    Vm vm(program.chunk(), machine, seed);
    while (vm.run(1000) != Vm::State::Done) {
    }
    return machine.calls().front().text;
  };
  CHECK(printed(7) == printed(7));
  CHECK(printed(7) != printed(8));
}

}  // namespace
}  // namespace rob::lang
