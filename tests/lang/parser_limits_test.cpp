#include "tests/lang/parsing.h"

using namespace rob::lang;

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
    for (int i = 0; i < operators; ++i) text += "\n*1";
    return text + ")";
  };
  CHECK(sound(chain(199)).statement<Assign>().value->height == 200);
  CHECK(only_error(chain(200)).code == "E141");
  CHECK(errors(chain(100000) + "\nMOV(1,2,3)").size() == 2);
}

TEST_CASE("a sum is long, not deep: its tree ends at 100 terms") {
  std::string text = "v = (1";
  for (int i = 1; i < 100000; ++i) text += "\n+1";
  CHECK(sound(text + ")").statement<Assign>().value->height == 101);
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
  for (std::size_t i = 0; i <= kMaxNodes / 5; ++i) text += "PRINT 1, 2, 3, 4\n";  // five nodes each
  const Diagnostic error = only_error(text);
  CHECK(error.code == "E142");
  CHECK(error.place.line == kMaxNodes / 5 + 1);
}

TEST_CASE("a program that declares more names than it may is refused at the first one too many") {
  const auto names = [](const char* head, const char* tail, std::size_t count) {
    std::string text;
    for (std::size_t i = 0; i < count; ++i) text += head + std::to_string(i) + tail;
    return text;
  };
  for (const auto& [begins, tail] : {std::pair{"VAR v", ": INT\n"},
                                     {"CONST c", " = 1\n"},
                                     {"POINT p", "\n"},
                                     {"PROC p", "()\nENDPROC\n"}}) {
    const char* const head = begins;
    CAPTURE(head);
    sound(names(head, tail, kMaxNames));
    const Diagnostic error = only_error(names(head, tail, 2 * kMaxNames));
    CHECK(error.code == "E142");
    CHECK(error.message == "the program is too large: it declares more than 65536 names");
    const auto lines_each = std::string(tail).find("ENDPROC") == std::string::npos ? 1U : 2U;
    CHECK(error.place.line == lines_each * kMaxNames + 1);
  }
  const std::string fields = names("f", ": INT\n", kMaxNames);
  CHECK(only_error("RECORD r\n" + fields + "ENDRECORD\n").code == "E142");
  const std::string parameters = names("p", ",\n", kMaxNames);
  CHECK(only_error("PROC p(" + parameters + "last: INT)\nENDPROC\n").code == "E142");
}

TEST_CASE("motions in numbers alone may be as many as the text holds") {
  std::string text;
  for (std::size_t i = 0; i <= kMaxNodes; ++i) text += "MOVE(1,2,3)\n";
  const Parsed p = sound(text);
  REQUIRE(p.program.statements.size() == 1);
  CHECK(p.statement<PlainMotions>().motions.size() == kMaxNodes + 1);
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
