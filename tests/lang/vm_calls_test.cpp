#include <doctest/doctest.h>

#include "tests/lang/program_run.h"
#include "tests/support/no_allocation.h"

using namespace rob::lang;
using rob::test::ProgramRun;
using State = Vm::State;

TEST_CASE("an error inside routines tells the calls that led to it, the innermost first") {
  ProgramRun program(
      "outer(0)\nPROC outer(n: INT)\n  inner(n)\nENDPROC\n"
      "PROC inner(n: INT)\n  PRINT 1 DIV n\nENDPROC");
  CHECK(program.finish() == State::Failed);
  CHECK(program.vm().error().code == "E302");
  CHECK(program.vm().error().place.line == 6);
  CHECK(program.vm().error().calls ==
        std::vector<CallSite>{{.routine = "inner", .line = 3}, {.routine = "outer", .line = 1}});
}

TEST_CASE("a recursion gives up control when its budget is spent, and goes on where it was") {
  const char* const source =
      "PRINT fib(15)\nFUNC fib(n: INT): INT\n  IF n < 2 THEN RETURN n\n"
      "  RETURN fib(n - 1) + fib(n - 2)\nENDFUNC";
  ProgramRun whole(source);
  ProgramRun pieces(source);
  whole.finish();
  int runs = 0;
  while (pieces.vm().run(1) != State::Done) ++runs;
  CHECK(runs > 1000);
  CHECK(pieces.machine().texts() == std::vector<std::string>{"print 610", "end"});
  CHECK(pieces.vm().executed() == whole.vm().executed());
}

TEST_CASE("a routine called again sees the world of the next cycle, another that of the present") {
  ProgramRun two(
      "PRINT a()\nPRINT b()\nFUNC a(): BOOL\n  RETURN lift_up\nENDFUNC\n"
      "FUNC b(): BOOL\n  RETURN lift_up\nENDFUNC");
  CHECK(two.vm().run(1000) == State::Done);
  ProgramRun again("PRINT a()\nPRINT a()\nFUNC a(): BOOL\n  RETURN lift_up\nENDFUNC");
  CHECK(again.vm().run(1000) == State::NextCycle);
  CHECK(again.vm().run(1000) == State::Done);
  CHECK(again.machine().reads() == 2);
}

TEST_CASE("a recursion whose frames are large ends with the same error as a deep one") {
  std::string source = "deep(1)\nPROC deep(n: INT)\n";
  for (int i = 0; i < 200; ++i) source += "  VAR v" + std::to_string(i) + " = n\n";
  ProgramRun program(source + "  deep(n + 1)\nENDPROC");
  CHECK(program.finish() == State::Failed);
  CHECK(program.vm().error().code == "E321");
}

TEST_CASE("calls take no memory") {
  ProgramRun program(
      "VAR x = 0mm\nFOR i = 1 TO 100 DO\n  grow(x, i)\n  x = half(x)\nENDFOR\n"
      "PROC grow(REF v: LENGTH, n: INT = 2)\n  v = v + n * 1mm\nENDPROC\n"
      "FUNC half(v: LENGTH): LENGTH\n  RETURN v / 2\nENDFUNC");
  State state = State::Running;
  const rob::test::NoAllocation guard;
  while (program.vm().executed() < 1000) state = program.vm().run(10);
  const int taken = guard.count();
  CHECK(taken == 0);
  CHECK(state == State::Running);
}
