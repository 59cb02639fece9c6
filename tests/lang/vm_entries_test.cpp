// Entries of the prompt: one after another in one Vm, each compiled behind what stays of those
// before.

#include <algorithm>
#include <deque>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "lang/compile/compile.h"
#include "lang/vm/printing_machine.h"
#include "lang/vm/vm.h"
#include "tests/support/gantry_signature.h"

using namespace rob::lang;
using State = Vm::State;

namespace {

/// As a prompt does it: what does not last leaves a blank line.
class Entries {
 public:
  /// The code of the first error; empty if it could be compiled.
  std::string enter(const std::string& text) {
    const std::string lines = text + "\n";
    const auto count = std::ranges::count(lines, '\n');
    Compilation one = compile(kept_ + lines, robot_, points_, {}, nullptr, line_);
    const bool stays = one.chunk && one.lasts;
    kept_ += stays ? lines : std::string(static_cast<std::size_t>(count), '\n');
    line_ += static_cast<std::uint32_t>(count);
    if (!one.chunk) return one.diagnostics.all().front().code;
    names_ = one.names;
    chunks_.push_back(std::move(*one.chunk));
    vm_.go_on_with(chunks_.back());
    while (vm_.run(1'000'000) != State::Done && vm_.state() != State::Failed) continue;
    if (vm_.state() == State::Done) return "";
    const std::string code = vm_.error().code;
    while (vm_.give_up_entry() != Reply::Done) continue;
    return code;
  }

  /// What the machine was told last.
  std::string last() const { return machine_.calls().empty() ? "" : machine_.calls().back().text; }
  const std::vector<DeclaredName>& names() const { return names_; }
  PointTable& points() { return points_; }

 private:
  RobotSignature robot_ = rob::test::gantry_signature();
  PointTable points_;
  PrintingMachine machine_{robot_};
  Vm vm_{machine_};
  std::deque<Chunk> chunks_;
  std::string kept_;
  std::uint32_t line_ = 1;
  std::vector<DeclaredName> names_;
};

}  // namespace

TEST_CASE("variables keep their values from one entry to the next") {
  Entries prompt;
  CHECK(prompt.enter("VAR n = 20") == "");
  CHECK(prompt.enter("VAR name = \"pin\"") == "");
  CHECK(prompt.enter("n = n + 1") == "");
  CHECK(prompt.enter("PRINT name, n") == "");
  CHECK(prompt.last() == "print pin21");
}

TEST_CASE("arrays and records stay where they are when entries bring further ones") {
  Entries prompt;
  CHECK(prompt.enter("VAR a: ARRAY[3] OF INT = [1, 2, 3]") == "");
  CHECK(prompt.enter("a[2] = 7") == "");
  CHECK(prompt.enter("VAR b: ARRAY[200] OF REAL") == "");
  CHECK(prompt.enter("FOR i = 1 TO 200 DO\n  b[i] = i / 2\nENDFOR") == "");
  CHECK(prompt.enter("PRINT a, b[199]") == "");
  CHECK(prompt.last() == "print [1, 7, 3]99.5");
}

TEST_CASE("a routine of an earlier entry can be called, and sees its globals") {
  Entries prompt;
  CHECK(prompt.enter("VAR n = 1") == "");
  CHECK(prompt.enter("FUNC twice(x: INT): INT\n  RETURN 2 * x + n\nENDFUNC") == "");
  CHECK(prompt.enter("n = 5") == "");
  CHECK(prompt.enter("PRINT twice(4)") == "");
  CHECK(prompt.last() == "print 13");
}

TEST_CASE("a name may be declared anew, with another type") {
  Entries prompt;
  CHECK(prompt.enter("VAR x = 1") == "");
  CHECK(prompt.enter("VAR y = 10mm") == "");
  CHECK(prompt.enter("VAR x = \"text\"") == "");
  CHECK(prompt.enter("PRINT x, y") == "");
  CHECK(prompt.last() == "print text10mm");
  REQUIRE(prompt.names().size() == 2);
  CHECK(prompt.names()[1].name == "x");
}

TEST_CASE("an entry that fails leaves the ones before as they were") {
  Entries prompt;
  CHECK(prompt.enter("VAR n = 3") == "");
  CHECK(prompt.enter("n = n / 0") != "");  // does not compile: a REAL is no INT
  CHECK(prompt.enter("n = n DIV (n - 3)") != "");
  CHECK(prompt.enter("PRINT n") == "");
  CHECK(prompt.last() == "print 3");
}

TEST_CASE("a point that an entry teaches has its value in the next one") {
  Entries prompt;
  CHECK(prompt.enter("POINT pick, place") == "");
  CHECK(prompt.enter("VAR n = 3") == "");
  CHECK(prompt.enter("TEACH pick") == "");
  CHECK(prompt.enter("PRINT n") == "");
  CHECK(prompt.last() == "print 3");
}

TEST_CASE("a program of the same text still refuses a second declaration") {
  const Compilation program = compile("VAR x = 1\nVAR x = 2\n", rob::test::gantry_signature());
  CHECK(!program.chunk);
}
