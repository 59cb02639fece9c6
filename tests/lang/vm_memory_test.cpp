#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "lang/code/disassembler.h"
#include "tests/lang/program_run.h"
#include "tests/support/no_allocation.h"

using namespace rob::lang;
using rob::test::ProgramRun;
using State = Vm::State;

namespace {

/// Instructions that a program takes, to its end.
std::int64_t executed(const std::string& source) {
  ProgramRun program(source);
  CHECK(program.finish() == State::Done);
  return program.vm().executed();
}

}  // namespace

TEST_CASE("a sieve over an array finds the primes as in C++") {
  constexpr int kLast = 1000;
  std::vector<bool> composite(kLast + 1);
  int primes = 0;
  for (int i = 2; i <= kLast; ++i) {
    if (composite[static_cast<std::size_t>(i)]) continue;
    ++primes;
    for (int k = 2 * i; k <= kLast; k += i) composite[static_cast<std::size_t>(k)] = true;
  }
  ProgramRun program(
      "CONST n = 1000\nVAR composite: ARRAY[n] OF BOOL\nVAR count = 0\nFOR i = 2 TO n DO\n"
      "  IF NOT composite[i] THEN\n    count = count + 1\n"
      "    FOR k = 2 * i TO n STEP i DO\n      composite[k] = TRUE\n    ENDFOR\n  ENDIF\nENDFOR\n"
      "PRINT count\n");
  CHECK(program.printed() == std::to_string(primes));
}

TEST_CASE("long arrays cost an instruction for each 16 slots that are copied or compared") {
  const auto source = [](const std::string& length) {
    return "VAR a, b: ARRAY[" + length +
           "] OF INT\nFOR i = 1 TO 10 DO\n  b = a\n  IF a <> b THEN STOP\nENDFOR\n";
  };
  // Cleared once, copied 11 times, compared 10 times.
  CHECK(executed(source("16000")) - executed(source("16")) == 22 * (16000 - 16) / 16);
}

TEST_CASE("elements and copies of numbers take no memory") {
  ProgramRun program(
      "VAR a: ARRAY[100] OF LENGTH\nVAR b = a\nVAR v = [(1mm, 2mm, 3mm), (4mm, 5mm, 6mm)]\n"
      "LOOP\n  FOR i = 1 TO 100 DO\n    a[i] = a[i] + i * 1mm\n    v[1].x = v[2].y + b[i]\n"
      "  ENDFOR\n  b = grown(a)\nENDLOOP\n"
      "FUNC grown(a: ARRAY[100] OF LENGTH): ARRAY[100] OF LENGTH\n"
      "  a[1] = a[1] + 1mm\n  RETURN a\nENDFUNC\n");
  State state = State::Running;
  const rob::test::NoAllocation guard;
  while (program.vm().executed() < 10'000) state = program.vm().run(100);
  const int taken = guard.count();
  CHECK(taken == 0);
  CHECK(state == State::Running);
}

TEST_CASE("variables that registers have no room for are declared together with one value") {
  std::string source = "VAR n = 7\nVAR word = \"ab\"\n";
  for (int i = 0; i < kVariableRegisters; ++i) {
    source += "VAR n" + std::to_string(i) + " = 1\n";
    source += "VAR text" + std::to_string(i) + " = \"t\"\n";
  }
  source +=
      "VAR a, b, c = n * 3\nVAR d, e = word + \"c\"\nVAR u, v = [n, n + 0.5]\n"
      "a = 1\nd = word\nu[1] = 0.0\n"
      "PRINT a, \" \", b, \" \", c, \" \", d, \" \", e, \" \", u[1], \" \", v[1], \" \", v[2]\n";
  CHECK(ProgramRun(source).printed() == "1 21 21 ab abc 0 7 7.5");
}

TEST_CASE("what a routine had is free again, however it was left") {
  ProgramRun program(
      "VAR sum = 0\nFOR i = 1 TO 1000 DO\n  TRY\n    sum = sum + fill(i)\n  RESCUE\n"
      "    sum = sum + 1\n  ENDTRY\nENDFOR\nPRINT sum\n"
      "FUNC fill(n: INT): INT\n  VAR a: ARRAY[100000] OF INT\n  a[100000] = n\n"
      "  IF n MOD 2 == 0 THEN RAISE \"even\"\n  RETURN a[100000]\nENDFUNC\n");
  // 500 odd numbers, 250000 in all, and 500 even ones that count 1.
  CHECK(program.printed() == "250500");
}

TEST_CASE("a list whose inputs have to be waited for reads them all anew") {
  ProgramRun program("VAR a = [lift_up, lift_down]\nPRINT a\n");
  program.machine().answer_later(1);
  CHECK(program.vm().run(100) == State::Waiting);
  CHECK(program.printed() == "[FALSE, FALSE]");
}

TEST_CASE("a loop that fills an array costs what its turns cost, whatever the budgets") {
  const std::string filling =
      "VAR a: ARRAY[500] OF INT\nFOR i = 1 TO 499 STEP 2 DO\n  a[i] = 7\nENDFOR\nPRINT a[499], "
      "a[2]";
  ProgramRun whole(filling);
  ProgramRun pieces(filling);
  whole.finish();
  while (pieces.vm().run(1) != State::Done) {
  }
  CHECK(rob::lang::disassemble(whole.chunk()).find("fill_element_constant") != std::string::npos);
  CHECK(whole.machine().texts() == pieces.machine().texts());
  CHECK(whole.machine().texts().front() == "print 70");
  CHECK(whole.vm().executed() == pieces.vm().executed());
  const std::string shorter = filling.substr(0, filling.find("499 STEP")) + "497 STEP" +
                              filling.substr(filling.find(" 2 DO"));
  // A turn: the store of three words, the step and the jump.
  CHECK(executed(filling) - executed(shorter) == 5);
}

TEST_CASE("a recursion with arrays cut into small budgets does the same as in one go") {
  const char* const source =
      "PRINT sum([1, 2, 3, 4], 4)\nFUNC sum(a: ARRAY[4] OF INT, n: INT): INT\n"
      "  IF n == 0 THEN RETURN 0\n  VAR b = a\n  b[n] = b[n] * 10\n"
      "  RETURN sum(b, n - 1) + b[n]\nENDFUNC\n";
  ProgramRun whole(source);
  ProgramRun pieces(source);
  whole.finish();
  while (pieces.vm().run(1) != State::Done) {
  }
  CHECK(pieces.machine().texts() == std::vector<std::string>{"print 100", "end"});
  CHECK(pieces.vm().executed() == whole.vm().executed());
}
