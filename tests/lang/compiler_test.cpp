#include "lang/compile/compiler.h"

#include <doctest/doctest.h>

#include "lang/code/disassembler.h"
#include "lang/syntax/parser.h"
#include "tests/lang/program_run.h"
#include "tests/support/text_files.h"

using namespace rob::lang;
using rob::test::ProgramRun;

TEST_CASE("a variable can be computed from itself in place") {
  CHECK(ProgramRun("VAR a = TRUE\nVAR b = FALSE\nb = a AND NOT b\nPRINT b").printed() == "TRUE");
  CHECK(ProgramRun("VAR a = TRUE\nVAR b = TRUE\na = b XOR a\nPRINT a").printed() == "FALSE");
  CHECK(ProgramRun("VAR x = 3\nx = (x + 1) * x - x\nPRINT x").printed() == "9");
  CHECK(ProgramRun("VAR s = \"a\"\nVAR t = \"b\"\ns = t + s\nPRINT s").printed() == "ba");
  CHECK(ProgramRun("VAR s = \"a\"\ns = s + s + s\nPRINT s").printed() == "aaa");
  CHECK(ProgramRun("VAR s = \"a\"\ns = STR(s) + STR(s == \"a\")\nPRINT s").printed() == "aTRUE");
}

TEST_CASE("more constants than 16 bits can number are still told apart") {
  // 70,000 constants of their own, beyond what load_int can carry.
  std::string source = "VAR sum = 0\n";
  std::int64_t sum = 0;
  for (std::int64_t i = 0; i < 70'000; ++i) {
    source += "sum = sum + " + std::to_string(100'000 + 3 * i) + "\n";
    sum += 100'000 + 3 * i;
  }
  ProgramRun program(source + "PRINT sum\n");
  REQUIRE(program.compiled());
  CHECK(program.chunk().constants.size() == 70'000);
  CHECK(program.printed() == std::to_string(sum));
}

TEST_CASE("a loop may be longer than 16 bits can jump") {
  std::string source = "VAR n = 0\nFOR i = 1 TO 2 DO\n";
  for (int i = 0; i < 40'000; ++i) source += "n = n + 1\n";
  ProgramRun program(source + "ENDFOR\nPRINT n\n");
  CHECK(program.printed() == "80000");
}

TEST_CASE("variables that find no register lie in memory") {
  std::string source;
  for (int i = 0; i < 300; ++i) source += "VAR v" + std::to_string(i) + " = 1\n";
  ProgramRun program(source + "v299 = v299 + v0 + 5\nPRINT v299, v298\n");
  REQUIRE(program.compiled());
  CHECK(program.chunk().registers <= kVariableRegisters + 8);
  // Two registers hold the places of the memory.
  CHECK(program.chunk().memory == Slots{.numbers = 300 - (kVariableRegisters - 2), .texts = 0});
  CHECK(program.printed() == "71");
}

TEST_CASE("names of USEd files count, and after one too many nothing else is reported") {
  rob::test::TextFiles files;
  std::string& used = files.texts["used"];
  for (std::size_t i = 0; i < kMaxNames - 1; ++i) used += "CONST c" + std::to_string(i) + " = 1\n";
  const auto compiled = [&](const std::string& source) {
    return compile(source, rob::test::gantry_signature(), {}, {}, &files);
  };
  CHECK_FALSE(compiled("USE used\nVAR n = c7\n").diagnostics.has_errors());
  const Compilation beyond = compiled("USE used\nVAR n = c7\nVAR m = 1\nn = later()\n");
  REQUIRE(beyond.diagnostics.all().size() == 1);
  CHECK(beyond.diagnostics.all().front().code == "E142");
  CHECK(beyond.diagnostics.all().front().place.line == 3);
}

TEST_CASE("more intermediate values than there are registers is an error of its own") {
  // Each FOR around the others keeps three values in registers.
  std::string source;
  for (int i = 0; i < 90; ++i) source += "FOR i" + std::to_string(i) + " = 1 TO 2 DO\n";
  for (int i = 0; i < 90; ++i) source += "ENDFOR\n";
  const ProgramRun program(source);
  CHECK_FALSE(program.compiled());
  CHECK(program.first_error().code == "E220");
  CHECK(program.first_error().place.line == 85);
}

TEST_CASE("registers are given back at the end of a block, and constants take none") {
  std::string source;
  for (int i = 0; i < 1000; ++i) {
    const std::string name = std::to_string(i);
    source += "CONST c" + name + " = " + name + "\nIF TRUE THEN\n  VAR v = c" + name + "\nENDIF\n";
  }
  const ProgramRun program(source);
  REQUIRE(program.compiled());
  CHECK(program.chunk().registers == 1);
}

TEST_CASE("every instruction knows the line that it comes from") {
  const ProgramRun program("VAR n = 1\n\nMOVE(n, 2, 3)\n\nEND\n");
  REQUIRE(program.compiled());
  const Chunk& chunk = program.chunk();
  REQUIRE(chunk.places.size() == chunk.code.size());
  for (std::size_t word = 0; word < chunk.places.size(); ++word) {
    const std::uint32_t line = chunk.places[word].line;
    const bool named = line == 1 || line == 3 || line == 5;
    CHECK(named);
  }
  CHECK(chunk.places.back().line == 5);
}

TEST_CASE("an expression that reads two signals is latched, one that reads one is not") {
  const auto latches = [](std::string_view source) {
    const ProgramRun program(source);
    int count = 0;
    for (const Instruction& instruction : program.chunk().code) {
      count += instruction.opcode() == Opcode::latch ? 1 : 0;
    }
    return count;
  };
  CHECK(latches("PRINT lift_up") == 0);
  CHECK(latches("PRINT lift_up AND lift_down") == 1);
  CHECK(latches("PRINT lift_up, lift_down") == 0);
}

TEST_CASE("sums with a product and elements with a constant take one instruction") {
  const ProgramRun program(
      "VAR a: ARRAY[9] OF BOOL\nVAR s, i = 2\nVAR x, y = 0.5\ns = s + s * i\ns = s * i - i\n"
      "s = s * i + i\nx = x - x * y\nx = i * y + x\na[i] = TRUE\nPRINT s, x\n");
  const std::string listing = rob::lang::disassemble(program.chunk());
  const auto shows = [&](const std::string& part) {
    return listing.find(part) != std::string::npos;
  };
  CHECK(shows("add_product_int    r2(s) r2(s) r2(s) r3(i)"));
  CHECK(shows("add_product_int    r2(s) r3(i) r2(s) r3(i)"));
  CHECK(shows("sub_product_real   r4(x) r4(x) r4(x) r5(y)"));
  CHECK(shows("add_product_real   r4(x) r4(x)"));
  CHECK(shows("sub_int"));  // a product less something is two
  CHECK(shows("store_element_constant"));
  CHECK(shows("of 9 // TRUE"));
}

TEST_CASE("a field of an element, and an element of an element, take one instruction") {
  ProgramRun program(
      "RECORD part\n  size: REAL\n  marks: ARRAY[3] OF INT\nENDRECORD\n"
      "VAR parts: ARRAY[4] OF part\nVAR grid: ARRAY[2] OF ARRAY[5] OF INT\nVAR i, j = 2\n"
      "parts[i].size = 1.5\nparts[i].size = parts[i].size * 3\n"
      "parts[i].marks[j] = 7 * i\ngrid[i][j + 1] = 8 * i\ngrid[i][j] = parts[i].marks[j] + 1\n"
      "PRINT parts[2].size, \" \", parts[2].marks[2], \" \", grid[2][2], \" \", grid[2][3]\n");
  const std::string listing = rob::lang::disassemble(program.chunk());
  const auto shows = [&](const std::string& part) {
    return listing.find(part) != std::string::npos;
  };
  // parts take 4 slots each, the marks lie 1 after the beginning; grid lies after 16 slots.
  CHECK(shows("r2(i) r0 +0 of 4 +4"));
  CHECK(shows("load_cell"));
  CHECK(shows("r2(i) r0 +1 of 4 +4 r3(j) of 3"));
  CHECK(shows("r2(i) r0 +16 of 2 +5 r3(j) of 5"));
  CHECK(shows("store_field"));
  CHECK(shows("store_element"));  // its index is computed after the check of the first one
  CHECK(shows("load_slot"));
  CHECK(program.printed() == "4.5 14 15 16");
}

TEST_CASE("texts are read where they lie, and grow where they are") {
  ProgramRun program(
      "VAR s = \"größer\"\nVAR n = LEN(s)\nVAR at = FIND(s, \"ß\")\nVAR m = MID(s, 2, n - 3)\n"
      "s += STR(n)\ns += \"|\"\ns = s + m + \"|\" + STR(at)\n"
      "IF m == \"röß\" AND m <> s THEN s = \"<\" + s\ns = s + s\nPRINT s\n");
  const std::string listing = rob::lang::disassemble(program.chunk());
  for (const char* name : {"text_length", "text_find", "text_middle", "append_int", "take_text",
                           "append_constant", "equal_text_constant"}) {
    CAPTURE(name);
    CHECK(listing.find(name) != std::string::npos);
  }
  CHECK(listing.find("call_text") == std::string::npos);
  CHECK(program.printed() == "<größer6|röß|4<größer6|röß|4");
}

TEST_CASE("a text is cut as a routine in an argument finds it") {
  // cut() shortens the text after MID's first argument was read, before the others are.
  ProgramRun program(
      "VAR s = \"abcdef\"\nFUNC cut(): INT\n  s = \"xy\"\n  RETURN 2\nENDFUNC\n"
      "PRINT MID(s, cut(), 3) + MID(s, 1, cut()) + STR(FIND(s, \"y\"))\n");
  CHECK(program.printed() == "bcdxy2");
}

TEST_CASE("long texts are cut at characters of any length") {
  std::string text;
  for (int i = 0; i < 40; ++i) text += i % 3 == 0 ? "ä" : i % 3 == 1 ? "€" : "z";
  for (int from = 1; from <= 40; ++from) {
    ProgramRun program("VAR s = \"" + text + "\"\nPRINT MID(s, " + std::to_string(from) +
                       ", 20), LEN(MID(s, 1, " + std::to_string(from) + "))\n");
    std::string expected;
    for (int i = from - 1; i < std::min(from + 19, 40); ++i) {
      expected += i % 3 == 0 ? "ä" : i % 3 == 1 ? "€" : "z";
    }
    CHECK(program.printed() == expected + std::to_string(from));
  }
}

TEST_CASE("sums of two products, and of three terms, take one instruction") {
  ProgramRun program(
      "VAR a = 3.0\nVAR b = 5.0\nVAR c = 7.0\nVAR d = 11.0\nVAR i = -7\n"
      "PRINT a * b + c * d, \" \", a * b - c * d, \" \", a + b + c, \" \", a + b - c, \" \","
      " a - b + c, \" \", a - b - c, \" \", i DIV 2, \" \", i MOD 4\n");
  const std::string listing = rob::lang::disassemble(program.chunk());
  for (const char* name :
       {"add_products_real", "sub_products_real", "add_add_real", "add_sub_real", "sub_add_real",
        "sub_sub_real", "div_int_constant", "mod_int_constant"}) {
    CAPTURE(name);
    CHECK(listing.find(name) != std::string::npos);
  }
  CHECK(program.printed() == "92 -62 15 1 5 -9 -4 1");
}

TEST_CASE("a sum in one instruction fails at the part that fails, and is never -0") {
  const std::string begin = "VAR a = 1e200\nVAR b = 1e200\nVAR c = 1.5e308\nVAR x = 1.0\n";
  const auto column = [&](const std::string& line) {
    ProgramRun program(begin + line);
    CHECK(program.finish() == rob::lang::Vm::State::Failed);
    CHECK(program.vm().error().place.line == 5);
    return program.vm().error().place.column;
  };
  // The same where each operation is a statement's only one.
  const int product = column("x = a * b\n");
  const int sum = column("x = c + c\n");
  CHECK(product == sum);
  CHECK(column("x = a * b + x * x\n") == product);
  CHECK(column("x = x * x + a * b\n") == product + 8);
  CHECK(column("x = c * x + c * x\n") == product + 4);
  CHECK(column("x = c + c - x\n") == sum);
  CHECK(column("x = x + c + c\n") == sum + 4);
  ProgramRun tiny("VAR a = 1e-200\nVAR b = -1e-200\nPRINT a * b + a * b, \" \", b * a - a * a\n");
  CHECK(tiny.printed() == "0 0");
}

TEST_CASE("both indices of an element of an element are checked, the left one first") {
  const std::string begin = "VAR grid: ARRAY[2] OF ARRAY[5] OF INT\nVAR i, j = 2\n";
  const auto error = [&](const std::string& rest) {
    ProgramRun program(begin + rest);
    program.finish();
    return program.vm().error().message;
  };
  CHECK(error("j = 6\nPRINT grid[i][j]\n") == "there is no element 6: they count from 1 to 5");
  CHECK(error("i = 3\nj = 6\nPRINT grid[i][j]\n") ==
        "there is no element 3: they count from 1 to 2");
  CHECK(error("j = 0\ngrid[i][j] = i\n") == "there is no element 0: they count from 1 to 5");
  CHECK(error("i = 0\ngrid[i][j] = i\n") == "there is no element 0: they count from 1 to 2");
}

TEST_CASE("a product takes its factors as they are when it is computed") {
  // twice() changes g after the left factor was read, before the right one is.
  ProgramRun program(
      "VAR g = 3\nVAR s = 100\nFUNC twice(): INT\n  g = 2 * g\n  RETURN g\nENDFUNC\n"
      "s = s + g * twice()\nPRINT s, \" \", twice() * g + g\n");
  CHECK(program.printed() == "118 156");  // 100 + 3 * 6; 12 * 12 + 12
}

TEST_CASE("an IF without ELSE has no jump at its end") {
  const ProgramRun program("VAR n = 1\nIF n == 1 THEN\n  n = 2\nENDIF\nPRINT n\n");
  const std::string listing = rob::lang::disassemble(program.chunk());
  CHECK(listing.find("jump") == listing.rfind("jump"));
}
