#include "tests/lang/parsing.h"

using namespace rob::lang;

TEST_CASE("the published gantry program is read as it stands") {
  const Parsed p = sound(
      "MOVE(40,40,0) // X = 40, Y = 40, theta = 0\n"
      "MOVE(140,40,0)\nMOVE(90,126,0)\nMOVE(40,40,0)\nSTOP\nEND\n");
  REQUIRE(p.program.statements.size() == 2);
  const PlainMotions& plain = p.statement<PlainMotions>(0);
  REQUIRE(plain.motions.size() == 4);
  CHECK(plain.place(plain.motions[2]) == Place{3, 1, 4});
  CHECK(std::holds_alternative<Stop>(p.program.statements[1].node));
  CHECK(p.program.end == Place{6, 1, 3});
}

TEST_CASE("the components of a target may be left out or named") {
  CHECK(shown(sound("MOVE(140, , ) FINE").statement<Move>().target) == "<140;_;_;>");
  CHECK(shown(sound("MOVE(, 40) FINE").statement<Move>().target) == "<_;40;>");
  CHECK(shown(sound("MOVE(x: 140mm, theta: a+1)").statement<Move>().target) ==
        "<x:real;theta:(a + 1);>");
  CHECK(shown(sound("MOVE(140) FINE").statement<Move>().target) == "<140;>");
  // What goes on behind the parentheses is a value.
  CHECK(shown(sound("MOVE (a) + b").statement<Move>().target) == "(a + b)");
  CHECK(shown(sound("MOVE p AT 5%").statement<Move>().target) == "p");
}

TEST_CASE("AT and OVER stand in any order behind the target, or not at all") {
  const Parsed p = sound(
      "MOVE(1, 2, 3) AT v\nMOVE(1, 2, 3) OVER t\nMOVE(1, 2, 3) AT v OVER t\n"
      "move (1, 2, 3) over t at v\nMOVE(a, 2, 3)");
  for (const int both : {2, 3}) {
    CHECK(shown(p.statement<Move>(static_cast<std::size_t>(both)).clauses[Clause::At]) == "v");
    CHECK(shown(p.statement<Move>(static_cast<std::size_t>(both)).clauses[Clause::Over]) == "t");
  }
  CHECK(p.statement<Move>(0).clauses[Clause::Over] == nullptr);
  CHECK(p.statement<Move>(1).clauses[Clause::At] == nullptr);
  CHECK(p.statement<Move>(4).clauses[Clause::At] == nullptr);
}

TEST_CASE("variables and constants are declared with a type, a value, or both") {
  const Parsed p = sound(
      "VAR a, b = 10mm\nVAR c: SPEED\nconst d: int = 3\nVAR e: [N/mm]\nVAR f: [1/s]\n"
      "VAR g: [ in ] = 3in\nVAR h: [%]");
  const auto& first = p.statement<Declaration>(0);
  REQUIRE(first.names.size() == 2);
  CHECK(first.names[1].name == "b");
  CHECK(first.names[1].place == Place{1, 8, 1});
  CHECK_FALSE(first.constant);
  CHECK_FALSE(first.type);
  CHECK(p.statement<Declaration>(1).type == Type::real(kSpeed));
  CHECK(p.statement<Declaration>(1).value == nullptr);
  CHECK(p.statement<Declaration>(2).constant);
  CHECK(p.statement<Declaration>(2).type == Type::integer());
  CHECK(p.statement<Declaration>(3).type == Type::real({.mass = 1, .time = -2}));
  CHECK(p.statement<Declaration>(4).type == Type::real(kFrequency));
  CHECK(p.statement<Declaration>(5).type == Type::real(kLength));
  CHECK(p.statement<Declaration>(6).type == Type::real());
}

TEST_CASE("every type of this version is known by its name") {
  const std::pair<const char*, Type> types[] = {{"BOOL", Type::boolean()},
                                                {"INT", Type::integer()},
                                                {"REAL", Type::real()},
                                                {"STRING", Type::string()},
                                                {"LENGTH", Type::real(kLength)},
                                                {"ANGLE", Type::real(kAngle)},
                                                {"TIME", Type::real(kTime)},
                                                {"SPEED", Type::real(kSpeed)},
                                                {"ANGULAR_SPEED", Type::real(kAngularSpeed)},
                                                {"ACCELERATION", Type::real(kAcceleration)},
                                                {"FORCE", Type::real(kForce)},
                                                {"TORQUE", Type::real(kTorque)},
                                                {"MASS", Type::real(kMass)},
                                                {"FREQUENCY", Type::real(kFrequency)},
                                                {"VOLTAGE", Type::real(kVoltage)}};
  for (const auto& [name, type] : types) {
    CHECK(sound("VAR x: " + std::string(name)).statement<Declaration>().type == type);
  }
}

TEST_CASE("an assignment names its target and keeps its place") {
  const Parsed p = sound("  lift = ON");
  CHECK(shown(p.statement<Assign>().target) == "lift");
  CHECK(p.statement<Assign>().target->place == Place{1, 3, 4});
  CHECK(shown(p.statement<Assign>().value) == "TRUE");
}

TEST_CASE("fields and indices follow a value in any number, and an assignment's target") {
  CHECK(expression("v.x") == "v.x");
  CHECK(expression("-a[i + 1].x ^ 2") == "(-(a[(i + 1)].x ^ 2))");
  CHECK(expression("f(1)[2][3]") == "f(1;)[2][3]");
  CHECK(shown(sound("a[i].x = 1").statement<Assign>().target) == "a[i].x");
}

TEST_CASE("clause words and the words of a line's beginning stay usable as names") {
  const Parsed p = sound("at = 1\nOVER = at + to\nzone = step\ntool = 3\npath = over");
  CHECK(p.program.statements.size() == 5);
  CHECK(shown(p.statement<Assign>(1).value) == "(at + to)");
}

TEST_CASE("PRINT takes a list of values") {
  const Parsed p = sound("PRINT \"x = \", x, 3");
  const auto& print = p.statement<Print>();
  REQUIRE(print.values.size() == 3);
  CHECK(shown(print.values[0]) == "\"x = \"");
}

TEST_CASE("IF stands on one line, or has branches") {
  const Parsed p = sound(
      "IF a THEN STOP\n"
      "IF a THEN\n STOP\nELSIF b THEN\nELSIF c THEN\n STOP\n STOP\nELSE\n STOP\nENDIF\n"
      "IF a THEN\nENDIF");
  const auto& one_line = p.statement<If>(0);
  REQUIRE(one_line.branches.size() == 1);
  CHECK(one_line.branches[0].body.size() == 1);
  const auto& block = p.statement<If>(1);
  REQUIRE(block.branches.size() == 3);
  CHECK(shown(block.branches[1].condition) == "b");
  CHECK(block.branches[1].body.empty());
  CHECK(block.branches[2].body.size() == 2);
  CHECK(block.otherwise.size() == 1);
  CHECK(p.statement<If>(2).otherwise.empty());
}

TEST_CASE("loops hold their blocks, blocks within blocks") {
  const Parsed p = sound(
      "WHILE a < 3 DO\n FOR i = 1 TO n STEP 2 DO\n  PRINT i\n ENDFOR\n STOP\nENDWHILE\n"
      "FOR k = 0mm TO 9mm DO\nENDFOR");
  const auto& loop = p.statement<While>(0);
  CHECK(shown(loop.condition) == "(a < 3)");
  REQUIRE(loop.body.size() == 2);
  const auto& inner = std::get<For>(loop.body[0].node);
  CHECK(inner.variable == "i");
  CHECK(inner.variable_place == Place{2, 6, 1});
  CHECK(shown(inner.from) == "1");
  CHECK(shown(inner.to) == "n");
  CHECK(shown(inner.step) == "2");
  CHECK(inner.body.size() == 1);
  CHECK(p.statement<For>(1).step == nullptr);
}

TEST_CASE("a program ends with its file where END is left out") {
  CHECK(sound("STOP\n").program.end == Place{2, 1, 0});
  CHECK(sound("STOP\nEND // done\n\n").program.end == Place{2, 1, 3});
}

TEST_CASE("operators bind as in mathematics") {
  CHECK(expression("1 + 2 * 3") == "(1 + (2 * 3))");
  CHECK(expression("1 - 2 - 3") == "((1 - 2) - 3)");
  CHECK(expression("8 / 4 / 2 DIV 3 MOD 5") == "((((8 / 4) / 2) DIV 3) MOD 5)");
  CHECK(expression("(1 + 2) * 3") == "((1 + 2) * 3)");
  CHECK(expression("-2 ^ 2") == "(-(2 ^ 2))");
  CHECK(expression("2 ^ -3 ^ 2") == "(2 ^ (-(3 ^ 2)))");
  CHECK(expression("2 * -3") == "(2 * (-3))");
  CHECK(expression("+a - -b") == "((+a) - (-b))");
  CHECK(expression("a < b + 1 AND NOT c == d OR e") == "(((a < (b + 1)) AND (NOT (c == d))) OR e)");
  CHECK(expression("a OR b XOR c AND d") == "((a OR b) XOR (c AND d))");
  CHECK(expression("NOT NOT a") == "(NOT (NOT a))");
}

TEST_CASE("functions take arguments, and a single value in parentheses is a group") {
  CHECK(expression("MAX(1, a, MIN(b, 2))") == "MAX(1;a;MIN(b;2;);)");
  CHECK(expression("RANDOM()") == "RANDOM()");
  CHECK(expression("((a))") == "a");
  CHECK(expression("(1, 2, 3)") == "<1;2;3;>");
  CHECK(expression("(x: 1)") == "<x:1;>");
}

TEST_CASE("TRUE and ON are one value, FALSE and OFF the other") {
  CHECK(expression("ON") == "TRUE");
  CHECK(expression("true") == "TRUE");
  CHECK(expression("OFF") == "FALSE");
  CHECK(expression("FALSE") == "FALSE");
}

TEST_CASE("line ends do not count inside brackets") {
  CHECK(expression("(1 +\n\n  2 // two\n) * MAX(\n3\n,\n4)") == "((1 + 2) * MAX(3;4;))");
  CHECK(expression("(a\n AND b\n OR NOT c)") == "((a AND b) OR (NOT c))");
  CHECK(shown(sound("MOVE(140,\n     40,\n     0) AT v").statement<Move>().target) ==
        "<140;40;0;>");
}

TEST_CASE("a message about an operation points at its sign") {
  const Parsed p = sound("v = aa + bb");
  CHECK(p.statement<Assign>().value->place == Place{1, 8, 1});
}
