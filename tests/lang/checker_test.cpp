#include "lang/check/checker.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "tests/lang/program_run.h"

using namespace rob::lang;
using rob::test::ProgramRun;

TEST_CASE("a message points at the expression that is wrong") {
  const ProgramRun program("VAR x = 1mm\nMOVE(1, 2s, 3)\n");
  CHECK(program.first_error().code == "E207");
  CHECK(program.first_error().place == Place{.line = 2, .column = 9, .length = 2});
}

TEST_CASE("a program with errors has no code") {
  CHECK_FALSE(ProgramRun("MOVE(1, 2)").compiled());
  CHECK(ProgramRun("MOVE(1, 2, 3)").compiled());
}

TEST_CASE("constant targets are known before the program runs, also in branches never entered") {
  const ProgramRun program(
      "VAR v = 7mm\n"
      "MOVE(40, v, 90)\n"
      "IF FALSE THEN\n"
      "  MOVE(9000, , ) AT 50% OVER 2s\n"
      "ENDIF\n"
      "MOVE(v, v, )\n"
      "MOVE( , , )\n");
  const auto& targets = program.targets();
  REQUIRE(targets.size() == 2);

  CHECK(targets[0].count == 3);
  CHECK(targets[0].given == 0b101);
  CHECK(targets[0].target[0] == 0.04);
  CHECK(targets[0].target[2] == doctest::Approx(std::numbers::pi / 2));

  CHECK(targets[1].given == 0b001);
  CHECK(targets[1].target[0] == 9.0);
}

TEST_CASE("a place left out in a watched condition is one error") {
  for (const char* const statement : {"MOVE(1, 2, 3) UNTIL (1mm, , 2mm) == (1mm, 2mm, 3mm)\n",
                                      "WHEN (1mm, , 2mm) <> (1mm, 2mm, 3mm) : lift = OFF\n"}) {
    const ProgramRun program(statement);
    CHECK(program.first_error().code == "E216");
    CHECK(program.first_error().place.column < 25);
  }
}

TEST_CASE("a target that the robot refuses is an error at its place") {
  const auto refuse = [](const MoveCommand&) { return std::optional(Refusal{"E401", "no", "so"}); };
  const Compilation compilation = compile("MOVE(1, 2, 3)\nMOVEL ((4), 5, 6)\nMOVE( , , )\n",
                                          rob::test::gantry_signature(), {}, refuse);
  REQUIRE(compilation.diagnostics.all().size() == 2);
  CHECK(compilation.diagnostics.all()[0].place == Place{.line = 1, .column = 5, .length = 1});
  CHECK(compilation.diagnostics.all()[1].place == Place{.line = 2, .column = 7, .length = 1});
  CHECK(compilation.diagnostics.all()[1].code == "E401");
  CHECK(compilation.diagnostics.all()[1].help == "so");
  CHECK_FALSE(compilation.chunk.has_value());
}

TEST_CASE("constants count as constant in a target, variables do not") {
  const ProgramRun program("CONST a = 2 * 20mm\nVAR b = 3mm\nMOVE(a, b, 10 + 20)\n");
  const auto& targets = program.targets();
  REQUIRE(targets.size() == 1);
  CHECK(targets[0].given == 0b101);
  CHECK(targets[0].target[0] == 0.04);
}

TEST_CASE("a bare literal is the same bits as the literal with its unit") {
  for (const char* const number : {"0.3", "9", "126.6", "0.1", "1e-3", "399.9"}) {
    const std::string text(number);
    const ProgramRun program("MOVE(" + text + ", " + text + "mm, " + text + ")\nMOVE(-" + text +
                             ", -" + text + "mm, " + text + "deg)\n");
    const auto& targets = program.targets();
    REQUIRE(targets.size() == 2);
    CHECK(targets[0].target[0] == targets[0].target[1]);
    CHECK(targets[1].target[0] == targets[1].target[1]);
    CHECK(targets[0].target[2] == targets[1].target[2]);
  }
}

TEST_CASE("six axes may be given by place alone, and keep the orientation") {
  RobotSignature arm{.name = "arm", .coordinates = {}, .axes = {}, .signals = {}};
  for (const char* const name : {"x", "y", "z"}) arm.coordinates.push_back({name, kLength});
  for (const char* const name : {"a", "b", "c"}) arm.coordinates.push_back({name, kAngle});
  CHECK(compile("MOVE(1, 2, 3)", arm).chunk.has_value());
  CHECK(compile("MOVE(1, 2, 3, 4, 5, 6)", arm).chunk.has_value());
  CHECK(compile("MOVE(z: 1)", arm).chunk.has_value());
  CHECK_FALSE(compile("MOVE(1, 2, 3, 4)", arm).chunk.has_value());
}

TEST_CASE("a name that is reported once is not reported again where it is used") {
  const ProgramRun program("VAR a = b\nPRINT a\nVAR c = a + 1mm\nMOVE(c, a, a)\n");
  CHECK(program.compilation().diagnostics.error_count() == 1);
}

TEST_CASE("thousands of unknown names are counted without a search for each") {
  std::string source;
  for (int i = 0; i < 5000; ++i) source += "PRINT q" + std::to_string(i) + "\n";
  const ProgramRun program(source);
  CHECK(program.compilation().diagnostics.error_count() == 5000);
  CHECK(program.compilation().diagnostics.all().size() == Diagnostics::kMost);
}

TEST_CASE("a message that quotes a name stays short however long the name is") {
  const std::string name(60'000, 'a');
  for (const std::string& source :
       {"PRINT " + name, "PRINT " + name + "(1)", name + " = 1",
        "VAR " + name + " = 1\nVAR " + name + " = 1", "MOVE(" + name + ": 1)",
        "CONST " + name + " = 1\n" + name + " = 2", "VAR " + name + ": LENGTH = 1",
        "VAR " + name + " = 1mm\n" + name + " = 1"}) {
    const ProgramRun program(source);
    REQUIRE_FALSE(program.compiled());
    for (const Diagnostic& diagnostic : program.compilation().diagnostics.all()) {
      CHECK(diagnostic.message.size() + diagnostic.help.size() < 300);
    }
  }
}
