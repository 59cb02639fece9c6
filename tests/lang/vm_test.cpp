#include "lang/vm/vm.h"

#include <limits>
#include <string>
#include <utility>

#include <doctest/doctest.h>

#include "tests/lang/program_run.h"
#include "tests/support/no_allocation.h"

using namespace rob::lang;
using rob::test::ProgramRun;
using State = Vm::State;

TEST_CASE("Fibonacci numbers come out as in C++") {
  std::int64_t a = 0;
  std::int64_t b = 1;
  for (int i = 0; i < 90; ++i) {
    const std::int64_t next = a + b;
    a = b;
    b = next;
  }
  CHECK(ProgramRun("VAR a = 0\nVAR b = 1\nFOR i = 1 TO 90 DO\n  VAR sum = a + b\n  a = b\n"
                   "  b = sum\nENDFOR\nPRINT a")
            .printed() == std::to_string(a));
}

TEST_CASE("primes are found as in C++") {
  int primes = 0;
  for (int n = 2; n <= 500; ++n) {
    bool prime = true;
    for (int d = 2; d * d <= n; ++d) prime = prime && n % d != 0;
    primes += prime ? 1 : 0;
  }
  CHECK(ProgramRun("VAR primes, n = 0\nn = 2\nWHILE n <= 500 DO\n  VAR prime = TRUE\n"
                   "  VAR d = 2\n  WHILE prime AND d * d <= n DO\n"
                   "    IF n MOD d == 0 THEN prime = FALSE\n    d = d + 1\n  ENDWHILE\n"
                   "  IF prime THEN primes = primes + 1\n  n = n + 1\nENDWHILE\nPRINT primes")
            .printed() == std::to_string(primes));
}

TEST_CASE("a FOR over reals multiplies its step and does not let errors add up") {
  CHECK(ProgramRun("VAR last = 0.0\nFOR x = 0 TO 1000 STEP 0.1 DO\n  last = x\nENDFOR\n"
                   "PRINT last == 10000 * 0.1")
            .printed() == "TRUE");
}

TEST_CASE("a FOR reaches both ends of INT without overflow") {
  CHECK(ProgramRun("VAR n = 0\nFOR i = 9223372036854775805 TO 9223372036854775807 DO\n"
                   "  n = n + 1\nENDFOR\nPRINT n")
            .printed() == "3");
}

TEST_CASE("a sum with a product fails where the one or the other does") {
  const auto failed_at = [](const std::string& values, const std::string& statement) {
    ProgramRun program(values + "\n" + statement + "\n");
    CHECK(program.finish() == State::Failed);
    return std::pair(program.vm().error().code, program.vm().error().place.column);
  };
  using Found = std::pair<std::string, unsigned>;
  const std::string whole = "VAR s, a, b = 4611686018427387904";  // 2^62
  CHECK(failed_at(whole, "s = s + a * b") == Found("E301", 11));
  CHECK(failed_at(whole, "s = s - a * b") == Found("E301", 11));
  CHECK(failed_at(whole + "\nVAR one = 1", "s = s + a * one") == Found("E301", 7));
  CHECK(failed_at(whole + "\nVAR one = 1", "s = a * one + b") == Found("E301", 13));
  CHECK(failed_at(whole + "\nVAR one = 3\ns = -s", "s = s - a * one") == Found("E301", 11));
  const std::string real = "VAR s, a, b = 1.5e308";
  CHECK(failed_at(real, "s = s + a * b") == Found("E303", 11));
  CHECK(failed_at(real, "s = s - a * b") == Found("E303", 11));
  CHECK(failed_at(real + "\nVAR one = 1.0", "s = s + a * one") == Found("E303", 7));
  CHECK(failed_at(real + "\nVAR one = 1.0", "s = a * one + b") == Found("E303", 13));
}

TEST_CASE("a sum with a product has no negative zero") {
  // -1 * 0 would be -0, and 1 / -0 minus infinity.
  ProgramRun program(
      "VAR a = -1.0\nVAR z = 0.0\nz = z + a * z\nz = a * z + z\nz = z - a * z\nPRINT z, \" \", "
      "z == 0");
  CHECK(program.printed() == "0 TRUE");
}

TEST_CASE("what fails leaves its variable as it was") {
  CHECK(ProgramRun("VAR n = 9223372036854775807\nTRY\n  n = n + 1\nRESCUE\nENDTRY\nPRINT n")
            .printed() == "9223372036854775807");
  CHECK(ProgramRun("VAR x = 2.0\nVAR y = 1e308\nTRY\n  x = x * y\nRESCUE\nENDTRY\nPRINT x")
            .printed() == "2");
  CHECK(ProgramRun("VAR x = 1.0\nVAR y = 1e308\nTRY\n  x = x + y * y\nRESCUE\nENDTRY\nPRINT x")
            .printed() == "1");
}

TEST_CASE("an endless loop gives up control when its budget is spent") {
  ProgramRun program("WHILE TRUE DO\nENDWHILE");
  CHECK(program.vm().run(1000) == State::Running);
  const std::int64_t first = program.vm().executed();
  CHECK(first >= 1000);
  CHECK(first < 1000 + static_cast<std::int64_t>(program.chunk().code.size()));
  CHECK(program.vm().run(1000) == State::Running);
  CHECK(program.vm().executed() == 2 * first);
}

TEST_CASE("a run cut into small budgets does the same as one in one go") {
  const char* const source =
      "VAR n = 0\nFOR i = 1 TO 20 DO\n  n = n + i\n  MOVE(n, 0, 0)\nENDFOR\nPRINT n";
  ProgramRun whole(source);
  ProgramRun pieces(source);
  whole.finish();
  while (pieces.vm().run(1) != State::Done) {
  }
  CHECK(pieces.machine().texts() == whole.machine().texts());
  CHECK(pieces.vm().executed() == whole.vm().executed());
}

TEST_CASE("no budget is too large") {
  ProgramRun program("VAR sum = 0\nFOR i = 1 TO 1000 DO\n  sum = sum + i * i\nENDFOR\nPRINT sum");
  CHECK(program.vm().run(std::numeric_limits<std::int64_t>::max()) == State::Done);
  // n (n + 1) (2n + 1) / 6
  CHECK(program.machine().texts().front() == "print 333833500");
}

TEST_CASE("a call that must wait is given again, and happens once") {
  ProgramRun program("MOVE(1, 2, 3)\nPRINT \"a\"\n");
  program.machine().answer_later(2);
  CHECK(program.vm().run(100) == State::Waiting);
  CHECK(program.machine().calls().empty());
  CHECK(program.vm().run(100) == State::Waiting);
  CHECK(program.vm().run(100) == State::Done);
  CHECK(program.machine().texts() == std::vector<std::string>{"move 1 2 3", "print a", "end"});
}

TEST_CASE("a refused motion ends the program with the words of the refusal") {
  ProgramRun program("PRINT \"a\"\nMOVE(9000, 2, 3)\nPRINT \"b\"\n");
  program.machine().refuse_after(1, {.code = "E401", .message = "too far", .help = "nearer"});
  CHECK(program.vm().run(100) == State::Failed);
  CHECK(program.vm().error().code == "E401");
  CHECK(program.vm().error().message == "too far");
  CHECK(program.vm().error().help == "nearer");
  CHECK(program.vm().error().place.line == 2);
  CHECK(program.machine().texts() == std::vector<std::string>{"print a"});
}

TEST_CASE("waiting for an error to settle costs no instructions") {
  ProgramRun program("TRY\n  RAISE \"no\"\nRESCUE\nENDTRY\nPRINT 1");
  program.machine().answer_later(3);  // the settling
  CHECK(program.vm().run(1000) == State::Waiting);
  const std::int64_t before = program.vm().executed();
  CHECK(before < static_cast<std::int64_t>(program.chunk().code.size()));
  CHECK(program.vm().run(1000) == State::Waiting);
  CHECK(program.vm().run(1000) == State::Waiting);
  CHECK(program.vm().executed() == before);
  CHECK(program.vm().run(1000) == State::Done);
}

TEST_CASE("a program that is over stays over") {
  ProgramRun done("PRINT 1");
  CHECK(done.finish() == State::Done);
  CHECK(done.vm().run(100) == State::Done);
  CHECK(done.machine().calls().size() == 2);

  ProgramRun failed("VAR n = 0\nPRINT 1 DIV n");
  CHECK(failed.finish() == State::Failed);
  CHECK(failed.vm().run(100) == State::Failed);
  CHECK(failed.vm().error().code == "E302");
  CHECK(failed.vm().error().place.column == 9);
}

TEST_CASE("a loop that reads the world reads it once a cycle") {
  ProgramRun program("WHILE NOT lift_up DO\nENDWHILE");
  program.machine().script(2, {false, false, true});
  CHECK(program.vm().run(100) == State::NextCycle);
  CHECK(program.machine().reads() == 1);
  CHECK(program.vm().run(100) == State::NextCycle);
  CHECK(program.machine().reads() == 2);
  CHECK(program.vm().run(100) == State::Done);
  CHECK(program.machine().reads() == 3);
}

TEST_CASE("the first observation is answered in the present cycle, whatever loops ran before") {
  ProgramRun program("VAR n = 0\nFOR i = 1 TO 10 DO\n  n = n + i\nENDFOR\nPRINT lift_up");
  CHECK(program.vm().run(1000) == State::Done);
}

TEST_CASE("observations that no loop parts are answered in one cycle") {
  ProgramRun program("PRINT lift_up\nPRINT lift_down\nIF lift_up OR lift_down THEN STOP\n");
  CHECK(program.vm().run(1000) == State::Done);
}

TEST_CASE("after a wait time has passed, so a loop may observe at once") {
  ProgramRun program("WHILE NOT lift_up DO\n  PRINT 1\nENDWHILE");
  program.machine().script(2, {false, true});
  REQUIRE(program.vm().run(0) == State::Running);  // has observed, printed and turned
  program.machine().answer_later(1);
  REQUIRE(program.vm().run(100) == State::NextCycle);
  CHECK(program.vm().run(100) == State::Waiting);
  CHECK(program.vm().run(100) == State::Done);
}

namespace {

/// A machine whose inputs change with every cycle, and which makes a program wait in the middle of
/// an expression.
class ChangingMachine : public PrintingMachine {
 public:
  using PrintingMachine::PrintingMachine;

  Reply read_signal(int, int signal, bool& value) override {
    if (signal == 3 && !waited_) {
      waited_ = true;
      ++cycle_;
      return Reply::Later;
    }
    cycles_seen_.push_back(cycle_);
    value = true;
    return Reply::Done;
  }
  const std::vector<int>& cycles_seen() const { return cycles_seen_; }

 private:
  bool waited_ = false;
  int cycle_ = 0;
  std::vector<int> cycles_seen_;
};

}  // namespace

TEST_CASE("an expression that has to wait in its middle reads all its inputs anew") {
  const RobotSignature robot = rob::test::gantry_signature();
  const Compilation compilation = compile("PRINT lift_up AND lift_down", robot);
  REQUIRE(compilation.chunk);
  ChangingMachine machine(robot);
  Vm vm(*compilation.chunk, machine);
  CHECK(vm.run(100) == State::Waiting);
  CHECK(vm.run(100) == State::Done);
  // lift_up in cycle 0, the wait, then both in cycle 1.
  CHECK(machine.cycles_seen() == std::vector<int>{0, 1, 1});
}

TEST_CASE("a text is refused from its 65537th byte on") {
  const auto grown = [](int turns) {
    ProgramRun program("VAR s = \"x\"\nFOR i = 1 TO " + std::to_string(turns) +
                       " DO\n  s = s + \"0123456789\"\nENDFOR");
    program.finish();
    return program.vm().error().code;
  };
  CHECK(grown(6553) == "");  // 1 + 65530 bytes
  CHECK(grown(6554) == "E312");
}

TEST_CASE("arithmetic, loops, motions and observations take no memory") {
  class SilentMachine : public PrintingMachine {
   public:
    using PrintingMachine::PrintingMachine;
    Reply move(int, const MoveCommand&) override { return Reply::Done; }
    Reply read_signal(int, int, bool& value) override {
      value = false;
      return Reply::Done;
    }
    Reply end(int) override { return Reply::Done; }
  };
  const RobotSignature robot = rob::test::gantry_signature();
  const Compilation compilation = compile(
      "VAR v = 0mm\nFOR i = 1 TO 100 DO\n  v = MAX(v, i * 2mm) * SIN(30deg) + 1mm\n"
      "  IF lift_up AND lift_down OR i MOD 7 == 3 THEN v = -v\n"
      "  MOVE(v, i, 0) AT 20mm/s OVER 2s\nENDFOR",
      robot);
  REQUIRE(compilation.chunk);
  SilentMachine machine(robot);
  Vm vm(*compilation.chunk, machine);
  State state = State::Running;
  const rob::test::NoAllocation guard;
  while (state != State::Done && state != State::Failed) state = vm.run(50);
  const int taken = guard.count();
  CHECK(taken == 0);
  CHECK(state == State::Done);
}
