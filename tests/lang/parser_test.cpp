#include "lang/parser.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

using namespace rob::lang;

namespace {

struct Parsed {
  Program program;
  Diagnostics diagnostics;

  template <typename Node>
  const Node& statement(std::size_t index = 0) const {
    REQUIRE(index < program.statements.size());
    const Node* node = std::get_if<Node>(&program.statements[index].node);
    REQUIRE(node != nullptr);
    return *node;
  }
};

Parsed parsed(std::string_view source) {
  Parsed result;
  result.program = parse(source, result.diagnostics);
  return result;
}

Parsed sound(std::string_view source) {
  Parsed result = parsed(source);
  for (const Diagnostic& diagnostic : result.diagnostics.all()) {
    FAIL_CHECK(render(diagnostic, "test", source));
  }
  return result;
}

/// An expression with all its brackets, to see how it was read.
std::string shown(const ExprPtr& expr) {
  if (!expr) return "_";
  struct Show {
    std::string operator()(const NumberLiteral& n) const {
      return n.is_integer ? std::to_string(n.integer) : "real";
    }
    std::string operator()(const BoolLiteral& b) const { return b.value ? "TRUE" : "FALSE"; }
    std::string operator()(const StringLiteral& s) const { return "\"" + s.value + "\""; }
    std::string operator()(const Name& n) const { return n.text; }
    std::string operator()(const Unary& u) const {
      constexpr const char* kSigns[] = {"-", "+", "NOT "};
      return "(" + std::string(kSigns[static_cast<int>(u.op)]) + shown(u.operand) + ")";
    }
    std::string operator()(const Binary& b) const {
      constexpr const char* kSigns[] = {"OR", "XOR", "AND", "==", "<>", "<",   "<=",  ">",
                                        ">=", "+",   "-",   "*",  "/",  "DIV", "MOD", "^"};
      return "(" + shown(b.left) + " " + kSigns[static_cast<int>(b.op)] + " " + shown(b.right) +
             ")";
    }
    std::string operator()(const Call& c) const {
      std::string text = c.callee + "(";
      for (const ExprPtr& argument : c.arguments) text += shown(argument) + ";";
      return text + ")";
    }
    std::string operator()(const Tuple& t) const {
      std::string text = "<";
      for (const Tuple::Element& element : t.elements) {
        text += element.name + (element.name.empty() ? "" : ":") + shown(element.value) + ";";
      }
      return text + ">";
    }
  };
  return std::visit(Show{}, expr->node);
}

std::string expression(const std::string& text) {
  return shown(sound("v = " + text).statement<Assign>().value);
}

/// "line:column code message" of every error.
std::vector<std::string> errors(std::string_view source) {
  std::vector<std::string> result;
  const Parsed p = parsed(source);
  for (const Diagnostic& d : p.diagnostics.all()) {
    result.push_back(std::to_string(d.place.line) + ":" + std::to_string(d.place.column) + " " +
                     d.code + " " + d.message);
  }
  return result;
}

Diagnostic only_error(std::string_view source) {
  const Parsed p = parsed(source);
  REQUIRE_MESSAGE(p.diagnostics.all().size() == 1, source);
  return p.diagnostics.all().front();
}

using Errors = std::vector<std::string>;

}  // namespace

// ---------------------------------------------------------------- statements

TEST_CASE("the published gantry program is read as it stands") {
  const Parsed p = sound(
      "MOVE(40,40,0) // X = 40, Y = 40, theta = 0\n"
      "MOVE(140,40,0)\nMOVE(90,126,0)\nMOVE(40,40,0)\nSTOP\nEND\n");
  REQUIRE(p.program.statements.size() == 5);
  CHECK(shown(p.statement<Move>(2).target) == "<90;126;0;>");
  CHECK(p.program.statements[2].place == Place{3, 1, 4});
  CHECK(std::holds_alternative<Stop>(p.program.statements[4].node));
  CHECK(p.program.end == Place{6, 1, 3});
}

TEST_CASE("the components of a target may be left out or named") {
  CHECK(shown(sound("MOVE(140, , )").statement<Move>().target) == "<140;_;_;>");
  CHECK(shown(sound("MOVE(, 40)").statement<Move>().target) == "<_;40;>");
  CHECK(shown(sound("MOVE(x: 140mm, theta: a+1)").statement<Move>().target) ==
        "<x:real;theta:(a + 1);>");
  CHECK(shown(sound("MOVE(140)").statement<Move>().target) == "<140;>");
}

TEST_CASE("AT and OVER stand in any order behind the target, or not at all") {
  const Parsed p = sound(
      "MOVE(1, 2, 3) AT v\nMOVE(1, 2, 3) OVER t\nMOVE(1, 2, 3) AT v OVER t\n"
      "move (1, 2, 3) over t at v\nMOVE(1, 2, 3)");
  for (const int both : {2, 3}) {
    CHECK(shown(p.statement<Move>(static_cast<std::size_t>(both)).at) == "v");
    CHECK(shown(p.statement<Move>(static_cast<std::size_t>(both)).over) == "t");
  }
  CHECK(p.statement<Move>(0).over == nullptr);
  CHECK(p.statement<Move>(1).at == nullptr);
  CHECK(p.statement<Move>(4).at == nullptr);
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
  CHECK(p.statement<Assign>().target.text == "lift");
  CHECK(p.statement<Assign>().target_place == Place{1, 3, 4});
  CHECK(shown(p.statement<Assign>().value) == "TRUE");
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

// --------------------------------------------------------------- expressions

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

// -------------------------------------------------------------------- errors

TEST_CASE("a missing bracket is reported behind the last token before it") {
  const Errors expected{"1:12 E125 ')' expected after the target"};
  CHECK(errors("MOVE(140,40\n") == expected);
  CHECK(errors("MOVE(140,40") == expected);
  CHECK(errors("MOVE(140,40    // comment\nSTOP\nMOVE(1,2,3)\n") == expected);
  CHECK(errors("MOVE(140,40\nlift = ON\n") == expected);
  CHECK(errors("MOVE(140,40 AT 5mm/s\nSTOP") == expected);
  CHECK(errors("MOVE(140,40\n\n\nIF a THEN\nENDIF") == expected);
  CHECK(errors("MOVE(140,40]\nSTOP") == expected);
  CHECK(errors("MOVE(140,\nSTOP") == Errors{"1:10 E125 ')' expected after the target"});
  CHECK(errors("v = MAX(1, 2\nSTOP") ==
        Errors{"1:13 E125 ')' expected after the arguments of MAX"});
  CHECK(errors("v = (1 + 2\nSTOP") == Errors{"1:11 E125 ')' expected after the expression"});
}

TEST_CASE("what follows an error inside brackets is not taken for statements") {
  CHECK(errors("MOVE(140\n  40,\n  0)\nSTOP").size() == 1);
  CHECK(errors("MOVE(140, 40 40,\n  0)\nSTOP") == Errors{"1:14 E126 ',' expected before '40'"});
}

TEST_CASE("all errors of a file are found, in their order, and the sound lines are kept") {
  const Parsed p = parsed("MOV(1,2,3)\nSTOP\nx = = 3\nPRINT\nMOVE(4,5,6)\nVAR\n");
  REQUIRE(p.diagnostics.all().size() == 4);
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(p.diagnostics.all()[i].place.line == std::vector<std::uint32_t>{1, 3, 4, 6}[i]);
  }
  CHECK(p.program.statements.size() == 3);
}

TEST_CASE("a misspelt word is read as the word that was meant") {
  for (const auto& [misspelt, right] : {std::pair{"MOV(1,2,3)", "MOVE"},
                                        {"MOEV(1,2,3)", "MOVE"},
                                        {"PRNT \"a\"", "PRINT"},
                                        {"STPO", "STOP"},
                                        {"CONTS c = 3mm", "CONST"},
                                        {"WAITT 0.2s", "WAIT"}}) {
    const std::string wrong = misspelt;
    CAPTURE(wrong);
    const Diagnostic error = only_error(wrong);
    CHECK(error.code == "E120");
    CHECK(error.place.column == 1);
    CHECK(error.help == "did you mean " + std::string(right) + "?");
  }
  CHECK(parsed("MOV(1,2,3)").program.statements.size() == 1);
  CHECK(only_error("gripper 3").help ==
        "a line begins with a statement's word, or with a name and '='");
  CHECK(only_error("INT n = 3").help == "a variable is declared so: VAR n: INT");
}

TEST_CASE("one misspelt head or end of a block makes one message") {
  CHECK(errors("WHIEL a < 3 DO\n STOP\nENDWHILE\nSTOP") ==
        Errors{"1:1 E120 'WHIEL' is no statement"});
  CHECK(errors("IFF a THEN\n STOP\nELSE\nENDIF") == Errors{"1:1 E120 'IFF' is no statement"});
  CHECK(errors("IF a THEN\n STOP\nENDFI\nSTOP") == Errors{"3:1 E120 'ENDFI' is no statement"});
  CHECK(errors("IF a THEN\nELES\n STOP\nENDIF") == Errors{"2:1 E120 'ELES' is no statement"});
  CHECK(errors("FOE 3\nSTOP") == Errors{"1:1 E120 'FOE' is no statement"});  // opens nothing
}

TEST_CASE("a block that is not closed names the line in which it was opened") {
  CHECK(errors("STOP\nIF a THEN\n STOP\n") == Errors{"2:1 E138 the IF of line 2 is not closed"});
  CHECK(errors("WHILE a DO\n STOP\nEND\n") == Errors{"1:1 E138 the WHILE of line 1 is not closed"});
  CHECK(errors("FOR i = 1 TO 3 DO\n") == Errors{"1:1 E138 the FOR of line 1 is not closed"});
  CHECK(errors("WHILE a DO\nIF b THEN\nENDWHILE") ==
        Errors{"3:1 E138 ENDIF expected before ENDWHILE: the IF of line 2 is still open"});
  CHECK(errors("IF a THEN\nENDWHILE\nSTOP") ==
        Errors{"2:1 E138 ENDIF expected before ENDWHILE: the IF of line 1 is still open"});
}

TEST_CASE("END closes the program, not a block") {
  CHECK(errors("IF a THEN\n STOP\nEND\nSTOP") ==
        Errors{"3:1 E138 the IF of line 1 is closed by ENDIF"});
  CHECK(errors("IF a THEN\n STOP\nEND IF\nSTOP") ==
        Errors{"3:1 E138 the IF of line 1 is closed by ENDIF"});
  CHECK(errors("STOP\nEND\nSTOP\nSTOP") == Errors{"3:1 E140 nothing may stand behind END"});
  CHECK(errors("END STOP") == Errors{"1:5 E140 nothing may stand behind END"});
}

TEST_CASE("the end of a block that was not opened is an error of one line") {
  CHECK(errors("ENDIF\nSTOP") == Errors{"1:1 E139 ENDIF without IF"});
  CHECK(errors("ELSE\nSTOP") == Errors{"1:1 E139 ELSE without IF"});
  CHECK(errors("WHILE a DO\nELSE\nENDWHILE") == Errors{"2:1 E139 ELSE without IF"});
  CHECK(errors("IF a THEN\nENDLOOP\nENDIF") == Errors{"2:1 E139 ENDLOOP without LOOP"});
  CHECK(errors("IF a THEN\nELSE\nELSE\nENDIF") ==
        Errors{"3:1 E139 ELSE behind the ELSE of the IF of line 1"});
}

TEST_CASE("a faulty head does not hide the errors of its block") {
  const Parsed p = parsed("IF a = THEN\n x = = 1\nENDIF\nWHILE ) DO\n PRNT x\nENDWHILE\nSTOP");
  REQUIRE(p.diagnostics.all().size() == 5);
  CHECK(p.diagnostics.all()[2].place.line == 2);
  CHECK(p.diagnostics.all()[3].place.line == 4);
  CHECK(p.diagnostics.all()[4].place.line == 5);
  REQUIRE(p.program.statements.size() == 3);
  CHECK(p.statement<If>(0).branches[0].condition != nullptr);
  CHECK(p.statement<While>(1).condition != nullptr);
}

TEST_CASE("THEN, DO and TO are asked for where they are missing") {
  CHECK(errors("IF a\n STOP\nENDIF") == Errors{"1:5 E137 THEN expected after the condition"});
  CHECK(errors("IF a STOP") == Errors{"1:5 E137 THEN expected after the condition"});
  CHECK(errors("WHILE a\nENDWHILE") == Errors{"1:8 E137 DO expected after the condition"});
  CHECK(errors("WHILE a THEN\nENDWHILE") == Errors{"1:8 E137 DO expected after the condition"});
  CHECK(errors("IF a b THEN\nENDIF") == Errors{"1:5 E137 THEN expected after the condition"});
  CHECK(errors("FOR i = 1, 3 DO\nENDFOR") ==
        Errors{"1:10 E137 TO expected after the first value of FOR"});
  CHECK(errors("FOR i = 1 TO 3\nENDFOR") ==
        Errors{"1:15 E137 DO expected after the values of FOR"});
}

TEST_CASE("ELSE needs a block, and ELSE IF is one word") {
  CHECK(errors("IF a THEN STOP ELSE STOP") ==
        Errors{"1:16 E123 an IF with ELSE takes several lines"});
  CHECK(only_error("IF a THEN\nELSE IF b THEN\nENDIF").help == "write ELSIF");
  CHECK(errors("IF a THEN IF b THEN STOP") ==
        Errors{"1:11 E123 IF cannot stand on the line of THEN"});
  CHECK(errors("IF a THEN STOP ENDIF") == Errors{"1:16 E123 an IF on one line has no ENDIF"});
}

TEST_CASE("'=' in an expression is an error that shows '=='") {
  const Parsed p = parsed("IF a = 3 THEN STOP");
  REQUIRE(p.diagnostics.all().size() == 1);
  CHECK(p.diagnostics.all()[0].code == "E135");
  CHECK(p.diagnostics.all()[0].place == Place{1, 6, 1});
  CHECK(p.diagnostics.all()[0].help == "write ==");
  CHECK(shown(p.statement<If>().branches[0].condition) == "(a == 3)");
  CHECK(only_error("x == 3").help == "write =");
  CHECK(only_error("MOVE(x = 3)").help == "write x:");
  CHECK(only_error("v = a < b < c").code == "E136");
}

TEST_CASE("beginners' mistakes with MOVE are answered with the right form") {
  CHECK(only_error("MOVE 40,40,0").help == "MOVE(40,40,0)");
  CHECK(only_error("MOVE 40, 40, 0 OVER 2s").help == "MOVE(40, 40, 0)");
  CHECK(errors("MOVE") == Errors{"1:5 E127 a target expected after MOVE"});
  CHECK(errors("MOVE()") == Errors{"1:5 E124 there is nothing between the parentheses"});
  CHECK(only_error("MOVE(1,2,3) AT 50 mm/s").help ==
        "a unit follows its number without a blank: 50mm/s");
  CHECK(only_error("MOVE(140 mm, 3, 4)").help ==
        "a unit follows its number without a blank: 140mm");
  CHECK(only_error("MOVE(1,2,3) OVR 3s").help == "did you mean OVER?");
  CHECK(errors("MOVE(1,2,3) AT 5% OVER 1s AT 6%") == Errors{"1:27 E128 AT is given twice"});
  CHECK(errors("MOVE(1,2,3) AT") == Errors{"1:15 E124 a value expected after 'AT'"});
}

TEST_CASE("a comma for a decimal point, and other signs out of place, are explained") {
  CHECK(only_error("x = 1,5").help == "the decimal sign is a point: 1.5");
  CHECK(only_error("x = 3 % 4").help == "the remainder is written x MOD y");
  CHECK(only_error("x = 3)").help == "no bracket is open here");
  CHECK(only_error("40, 40, 0").code == "E122");
  CHECK(only_error("THEN STOP").code == "E122");
}

TEST_CASE("no spelling of a number can yield NaN or infinity") {
  for (const char* text : {"1e400", "1e312mm", "0x7FF", "1e", "1.INF", "1,5"}) {
    CAPTURE(text);
    CHECK(parsed("x = " + std::string(text)).diagnostics.error_count() == 1);
  }
  for (const char* text : {"NaN", "inf", "infinity"}) CHECK(expression(text) == text);  // names
}

TEST_CASE("a declaration says what it lacks, and its names are known all the same") {
  CHECK(errors("VAR x") == Errors{"1:6 E133 a variable needs a type or a value"});
  CHECK(errors("CONST x: INT") == Errors{"1:13 E133 a constant needs a value"});
  CHECK(only_error("VAR x: LENGHT").help == "did you mean LENGTH?");
  CHECK(only_error("VAR x: mm").help == "a unit as a type stands in brackets: [mm]");
  CHECK(only_error("VAR x: [mmm]").help == "did you mean mm?");
  CHECK(only_error("VAR x: [mm\nSTOP").message == "']' expected after the unit");
  CHECK(only_error("VAR move = 3").code == "E131");
  CHECK(only_error("STOP = 3").code == "E131");
  CHECK(only_error("VAR 3 = 3").code == "E130");
  CHECK(only_error("VAR x 5").code == "E134");
  for (const char* faulty :
       {"VAR x", "VAR x = ", "VAR x: LENGHT = 3mm", "CONST x = 5qq", "VAR x, 5"}) {
    CAPTURE(faulty);
    const Parsed p = parsed(faulty);
    CHECK(p.statement<Declaration>().names.front().name == "x");
    CHECK(p.statement<Declaration>().type == Type{});
    CHECK(p.statement<Declaration>().value == nullptr);
  }
}

TEST_CASE("what a later version will have is named once, and skipped with all that it holds") {
  CHECK(errors("MOVEL(1,2,3) AT 5mm/s\nWAIT 0.2s\nHALT") ==
        Errors{"1:1 E121 MOVEL is not in this version of Rob yet",
               "2:1 E121 WAIT is not in this version of Rob yet",
               "3:1 E121 HALT is not in this version of Rob yet"});
  CHECK(errors("LOOP\n IF a THEN EXIT\n LOOP\n nonsense here\n ENDLOOP\nENDLOOP\nSTOP").size() ==
        1);
  CHECK(errors("PROC pick(a: POSE)\n MOVEL a\nENDPROC\nSTOP").size() == 1);
  CHECK(errors("PATH AT 8mm/s DO\n AFTER 2mm : torch = ON\nENDPATH\nSTOP").size() == 1);
  CHECK(errors("WHEN door : RAISE \"open\"\nSTOP").size() == 1);
  CHECK(errors("WHEN door DO\n BRAKE\nENDWHEN\nSTOP").size() == 1);
  CHECK(errors("MOVEL a DO\n BEFORE 3mm : torch = OFF\nENDMOVE\nSTOP").size() == 1);
  CHECK(errors("MOVE(1,2,3) ZONE 5mm DO\n AFTER 3mm : torch = ON\nENDMOVE\nSTOP") ==
        Errors{"1:13 E121 ZONE behind a motion is not in this version of Rob yet"});
  CHECK(errors("ROBOT \"lwa4p\"\nSTOP").size() == 1);
  CHECK(errors("MOVE JOINT 6 TO 2rad") ==
        Errors{"1:6 E121 MOVE JOINT is not in this version of Rob yet"});
  CHECK(errors("VAR p: POSE").front() ==
        "1:8 E121 the type POSE is not in this version of Rob yet");
  CHECK(errors("v = p.x") ==
        Errors{"1:6 E121 the field of a value is not in this version of Rob yet"});
  CHECK(errors("v = DIN[1]").size() == 1);
  CHECK(errors("MOVE(1,2,3) AT LIVE 5%").size() == 1);
}

TEST_CASE("the names that a later or a foreign statement declares are known") {
  const Parsed p = parsed("SIGNAL vacuum = DOUT[1]\nPOINT pick, place");
  CHECK(p.statement<Declaration>(0).names[0].name == "vacuum");
  CHECK(p.statement<Declaration>(1).names[1].name == "place");
  CHECK(p.statement<Declaration>(1).type == Type{});
  CHECK(parsed("INT n = 3").statement<Declaration>().names[0].name == "n");
}

// ------------------------------------------------------------- hostile input

TEST_CASE("brackets are nested 200 deep and no deeper") {
  const auto nested = [](int depth) {
    const auto count = static_cast<std::size_t>(depth);
    return "v = " + std::string(count, '(') + "1" + std::string(count, ')');
  };
  sound(nested(200));
  CHECK(errors(nested(201)) ==
        Errors{"1:205 E141 the expression is nested too deep: at most 200 levels"});
  CHECK(only_error(nested(10000)).code == "E141");
  std::string lines = "v = ";
  for (int i = 0; i < 100000; ++i) lines += "(\n";
  CHECK(only_error(lines).code == "E141");
}

TEST_CASE("signs, NOTs, powers and calls are nested 200 deep and no deeper") {
  const auto repeated = [](const std::string& part, int count, const std::string& end) {
    std::string text = "v = ";
    for (int i = 0; i < count; ++i) text += part;
    return text + end;
  };
  sound(repeated("-", 199, "1"));
  for (const auto& [part, end] :
       {std::pair{"-", "1"}, {"NOT ", "a"}, {"1^", "1"}, {"f(", "1"}, {"(1,", "1"}}) {
    CHECK(only_error(repeated(part, 10000, end)).code == "E141");
  }
}

TEST_CASE("a long chain of operators is refused, since its tree is as high as it is long") {
  const auto chain = [](int operators) {
    std::string text = "v = (1";
    for (int i = 0; i < operators; ++i) text += "\n+1";
    return text + ")";
  };
  CHECK(sound(chain(199)).statement<Assign>().value->height == 200);
  CHECK(only_error(chain(200)).code == "E141");
  CHECK(errors(chain(100000) + "\nMOV(1,2,3)").size() == 2);
}

TEST_CASE("heights add up where chains stand inside chains") {
  std::string text = "1";
  for (int i = 0; i < 150; ++i) text = "(" + text + ")+1+1";
  CHECK(only_error("v = " + text).code == "E141");
}

TEST_CASE("blocks are nested 200 deep and no deeper") {
  const auto nested = [](int depth) {
    std::string text;
    for (int i = 0; i < depth; ++i) text += "IF a THEN\n";
    for (int i = 0; i < depth; ++i) text += "ENDIF\n";
    return text;
  };
  sound(nested(200));
  CHECK(errors(nested(201)) ==
        Errors{"201:1 E141 the blocks are nested too deep: at most 200 levels"});
  CHECK(only_error(nested(100000)).code == "E141");
}

TEST_CASE("a program of more than a million values is refused") {
  std::string text;
  for (std::size_t i = 0; i <= kMaxNodes / 5; ++i) text += "MOVE(1,2,3)\n";  // five nodes each
  const Diagnostic error = only_error(text);
  CHECK(error.code == "E142");
  CHECK(error.place.line == kMaxNodes / 5 + 1);
}

TEST_CASE("a file of nothing but errors is given up") {
  std::string text;
  for (int i = 0; i < 100000; ++i) text += "foo bar\n";
  const Parsed p = parsed(text);
  CHECK(p.diagnostics.error_count() == kMaxSyntaxErrors);
  CHECK(p.diagnostics.all().size() == Diagnostics::kMost);
}

TEST_CASE("what is no text is not parsed") {
  CHECK(only_error(std::string_view("MOV(1\0,2)", 9)).code == "E103");
  CHECK(only_error(std::string(100000, '(')).code == "E102");
}

TEST_CASE("an empty program draws a warning") {
  for (const char* empty : {"", "\n\n", "// nothing\n", "END"}) {
    const Parsed p = parsed(empty);
    REQUIRE(p.diagnostics.all().size() == 1);
    CHECK(p.diagnostics.all()[0].code == "W501");
    CHECK_FALSE(p.diagnostics.has_errors());
  }
}

TEST_CASE("messages stay short and free of control characters, whatever they quote") {
  const std::string longest(60000, 'a');
  const std::string digits(60000, '1');
  for (const std::string& source :
       {longest, longest + " = ", "CONST " + longest, "VAR " + longest, "v = " + longest + "(1",
        "INT " + longest, "MOVE(" + longest + " = 1)", "FOR " + longest + " 1",
        "v = 1." + digits + " mm", "v = 1." + digits + "," + digits, "v = 1" + longest,
        "MOVE 1," + longest, "VAR x: " + longest, std::string("MOVE 40,\x02\x02 0"),
        std::string("MOVE 40,\t0"), std::string("\x1b[2J")}) {
    const Parsed p = parsed(source);
    for (const Diagnostic& d : p.diagnostics.all()) {
      CHECK(d.message.size() + d.help.size() < 300);
      for (const char c : d.message + d.help) CHECK(static_cast<unsigned char>(c) >= 0x20);
    }
  }
}
