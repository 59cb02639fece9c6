#include "tests/lang/parsing.h"

using namespace rob::lang;

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

TEST_CASE("a character that can stand nowhere is reported once, behind the head of a block too") {
  CHECK(errors("LOOP \x04\nENDLOOP") ==
        Errors{"1:6 E106 the character U+0004 can stand in texts and comments only"});
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

TEST_CASE("a misspelt operator is named as well") {
  CHECK(only_error("v = a ADN b").help == "did you mean AND?");
  CHECK(only_error("IF a ADN b THEN\nENDIF").help == "did you mean AND?");
  CHECK(only_error("v = (7 DVI 2)").help == "did you mean DIV?");
}

TEST_CASE("one misspelt head or end of a block makes one message") {
  CHECK(errors("WHIEL a < 3 DO\n STOP\nENDWHILE\nSTOP") ==
        Errors{"1:1 E120 'WHIEL' is no statement"});
  CHECK(errors("IFF a THEN\n STOP\nELSE\nENDIF") == Errors{"1:1 E120 'IFF' is no statement"});
  CHECK(errors("IF a THEN\n STOP\nENDFI\nSTOP") == Errors{"3:1 E120 'ENDFI' is no statement"});
  CHECK(errors("IF a THEN\nELES\n STOP\nENDIF") == Errors{"2:1 E120 'ELES' is no statement"});
  CHECK(only_error("IF a THEN\n STOP\nENDI\nSTOP").help == "did you mean ENDIF?");
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
  CHECK(errors("STOP\nEND\nSTOP\nSTOP") == Errors{"3:1 E140 nothing may stand after END"});
  CHECK(errors("END STOP") == Errors{"1:5 E140 nothing may stand after END"});
}

TEST_CASE("the end of a block that was not opened is an error of one line") {
  CHECK(errors("ENDIF\nSTOP") == Errors{"1:1 E139 ENDIF without IF"});
  CHECK(errors("ELSE\nSTOP") == Errors{"1:1 E139 ELSE without IF"});
  CHECK(errors("WHILE a DO\nELSE\nENDWHILE") == Errors{"2:1 E139 ELSE without IF"});
  CHECK(errors("IF a THEN\nELSE\nELSE\nENDIF") ==
        Errors{"3:1 E139 ELSE after the ELSE of the IF of line 1"});
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
  CHECK(only_error("MOVE[40,40,0]").help == "MOVE(140, 40, 0)");
  CHECK(errors("MOVE") == Errors{"1:5 E127 a target expected after MOVE"});
  CHECK(errors("MOVE()") == Errors{"1:5 E124 there is nothing between the parentheses"});
  CHECK(only_error("MOVE(1,2,3) AT 50 mm/s").help ==
        "a unit follows its number without a blank: 50mm/s");
  CHECK(only_error("MOVE(140 mm, 3, 4)").help ==
        "a unit follows its number without a blank: 140mm");
  CHECK(only_error("MOVE(1,2,3) OVR 3s").help == "did you mean OVER?");
  CHECK(errors("MOVE(1,2,3) AT 5% OVER 1s AT 6%") == Errors{"1:27 E128 AT is given twice"});
  CHECK(only_error("MOVE(1,2,3)\n  AT 5%").help == "a clause stands on the line of its motion");
  CHECK(errors("MOVE(1,2,3) AT") == Errors{"1:15 E124 a value expected after 'AT'"});
}

TEST_CASE("a comma for a decimal point, and other signs out of place, are explained") {
  CHECK(only_error("x = 1,5").help == "the decimal sign is a point: 1.5");
  CHECK(only_error("x = 3 % 4").help == "the remainder is written x MOD y");
  CHECK(only_error("x = 3)").help == "no bracket is open here");
  CHECK(only_error("40, 40, 0").code == "E122");
  CHECK(only_error("THEN STOP").code == "E122");
}

TEST_CASE("fault 6: no spelling of a number can yield NaN or infinity") {
  for (const char* text : {"1e400", "1e312mm", "0x7FG", "1e", "1.INF", "1,5"}) {
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

TEST_CASE("what is wrong in a block is one error, and the block is read to its end") {
  CHECK(errors("WHEN a DO\n IF a THEN EXIT\n WHEN b DO\n nonsense here\n ENDWHEN\nENDWHEN\nSTOP")
            .size() == 1);
  CHECK(errors("TEST \"a\"\n MOVEL\nENDTEST\nSTOP").size() == 1);
  CHECK(errors("WHEN door DO\n BRAKE\nENDWHEN\nSTOP").empty());
}

TEST_CASE("the names that a later or a foreign statement declares are known") {
  const Parsed p = parsed("SIGNAL vacuum AOUT[1]");
  CHECK(p.statement<Declaration>(0).names[0].name == "vacuum");
  CHECK(p.statement<Declaration>(0).type == Type{});
  CHECK(parsed("INT n = 3").statement<Declaration>().names[0].name == "n");
}
