// Entries of the prompt: one after another in one Vm, each compiled behind what stays of those
// before.

#include <algorithm>
#include <deque>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "lang/compile/entries.h"
#include "lang/vm/printing_machine.h"
#include "lang/vm/vm.h"
#include "tests/support/gantry_signature.h"
#include "tests/support/text_files.h"

using namespace rob::lang;
using State = Vm::State;

namespace {

/// As a prompt does it.
class Prompt {
 public:
  /// The code of the first error; empty if it could be carried out.
  std::string enter(const std::string& text) {
    const std::uint32_t first = entries_.line();
    Compilation one = entries_.compile(text, robot_, points_, {}, &files_);
    entries_.keep(text, one);
    warnings_ = one.diagnostics.all();
    if (!one.chunk) return one.diagnostics.all().front().code;
    chunks_.push_back(std::move(*one.chunk));
    vm_.go_on_with(chunks_.back());
    while (vm_.run(1'000'000) != State::Done && vm_.state() != State::Failed) continue;
    if (vm_.state() == State::Done) return "";
    const std::string code = vm_.error().code;
    while (vm_.give_up_entry() != Reply::Done) continue;
    entries_.forget(first, entries_.line() - 1);
    return code;
  }

  /// What the machine was told last.
  std::string last() const { return machine_.calls().empty() ? "" : machine_.calls().back().text; }
  Entries& entries() { return entries_; }
  PointTable& points() { return points_; }
  rob::test::TextFiles& files() { return files_; }
  const Chunk& chunk() const { return chunks_.back(); }
  const std::vector<Diagnostic>& warnings() const { return warnings_; }

 private:
  RobotSignature robot_ = rob::test::gantry_signature();
  PointTable points_;
  rob::test::TextFiles files_;
  PrintingMachine machine_{robot_};
  Vm vm_{machine_};
  std::deque<Chunk> chunks_;
  Entries entries_;
  std::vector<Diagnostic> warnings_;
};

}  // namespace

TEST_CASE("variables keep their values from one entry to the next") {
  Prompt prompt;
  CHECK(prompt.enter("VAR n = 20") == "");
  CHECK(prompt.enter("VAR name = \"pin\"") == "");
  CHECK(prompt.enter("n = n + 1") == "");
  CHECK(prompt.enter("PRINT name, n") == "");
  CHECK(prompt.last() == "print pin21");
}

TEST_CASE("an ENUM is known to later entries, and not declared anew") {
  Prompt prompt;
  CHECK(prompt.enter("ENUM colour: red, green, off") == "");
  CHECK(prompt.enter("VAR c: colour") == "");
  CHECK(prompt.enter("c = colour.off") == "");
  CHECK(prompt.enter("FUNC f(x: colour): INT\n  RETURN ORD(x)\nENDFUNC") == "");
  CHECK(prompt.enter("PRINT c, f(c)") == "");
  CHECK(prompt.last() == "print colour.off3");
  CHECK(prompt.enter("ENUM colour: black") == "E202");
  CHECK(prompt.enter("PRINT c == colour.red") == "");
  CHECK(prompt.last() == "print FALSE");
}

TEST_CASE("arrays and records stay where they are when entries bring further ones") {
  Prompt prompt;
  CHECK(prompt.enter("VAR a: ARRAY[3] OF INT = [1, 2, 3]") == "");
  CHECK(prompt.enter("a[2] = 7") == "");
  CHECK(prompt.enter("VAR b: ARRAY[200] OF REAL") == "");
  CHECK(prompt.enter("FOR i = 1 TO 200 DO\n  b[i] = i / 2\nENDFOR") == "");
  CHECK(prompt.enter("PRINT a, b[199]") == "");
  CHECK(prompt.last() == "print [1, 7, 3]99.5");
}

TEST_CASE("a routine of an earlier entry can be called, and sees its globals") {
  Prompt prompt;
  CHECK(prompt.enter("VAR n = 1") == "");
  CHECK(prompt.enter("FUNC twice(x: INT): INT\n  RETURN 2 * x + n\nENDFUNC") == "");
  CHECK(prompt.enter("n = 5") == "");
  CHECK(prompt.enter("PRINT twice(4)") == "");
  CHECK(prompt.last() == "print 13");
}

TEST_CASE("a name may be declared anew, with another type") {
  Prompt prompt;
  CHECK(prompt.enter("VAR x = 1") == "");
  CHECK(prompt.enter("VAR y = 10mm") == "");
  CHECK(prompt.enter("VAR x = \"text\"") == "");
  CHECK(prompt.enter("PRINT x, y") == "");
  CHECK(prompt.last() == "print text10mm");
  REQUIRE(prompt.entries().names().size() == 2);
  CHECK(prompt.entries().names()[1].name == "x");
}

TEST_CASE("an entry that fails leaves the ones before as they were") {
  Prompt prompt;
  CHECK(prompt.enter("VAR n = 3") == "");
  CHECK(prompt.enter("n = n / 0") != "");  // does not compile: a REAL is no INT
  CHECK(prompt.enter("n = n DIV (n - 3)") != "");
  CHECK(prompt.enter("PRINT n") == "");
  CHECK(prompt.last() == "print 3");
}

TEST_CASE("a point that an entry teaches has its value in the next one") {
  Prompt prompt;
  CHECK(prompt.enter("POINT pick, place") == "");
  CHECK(prompt.enter("VAR n = 3") == "");
  CHECK(prompt.enter("TEACH pick") == "");
  CHECK(prompt.enter("PRINT n") == "");
  CHECK(prompt.last() == "print 3");
}

TEST_CASE("of an entry's text only what it names is compiled again") {
  Prompt prompt;
  for (int i = 0; i < 50; ++i) {
    const std::string n = std::to_string(i);
    CHECK(prompt.enter("VAR v" + n + " = " + n) == "");
    CHECK(prompt.enter("FUNC f" + n + "(): INT\n  RETURN v" + n + "\nENDFUNC") == "");
    CHECK(prompt.enter("FUNC g" + n + "(): INT\n  RETURN f" + n + "() + 1\nENDFUNC") == "");
  }
  CHECK(prompt.enter("PRINT g7(), v3") == "");
  CHECK(prompt.last() == "print 83");
  CHECK(prompt.chunk().routines.size() == 2);  // g7, f7
  CHECK(prompt.enter("v7 = 20") == "");
  CHECK(prompt.chunk().routines.empty());
  CHECK(prompt.enter("PRINT g7()") == "");
  CHECK(prompt.last() == "print 21");
}

TEST_CASE("a routine does not use what its parameters are called like") {
  Prompt prompt;
  CHECK(prompt.enter("FUNC half(n: REAL): REAL\n  RETURN n / 2\nENDFUNC") == "");
  CHECK(prompt.enter("VAR n = \"text\"") == "");
  CHECK(prompt.chunk().routines.empty());
  CHECK(prompt.enter("PRINT half(3), n") == "");
  CHECK(prompt.last() == "print 1.5text");
}

TEST_CASE("a routine that uses what is declared anew has to fit to it") {
  Prompt prompt;
  CHECK(prompt.enter("VAR x = 1") == "");
  CHECK(prompt.enter("FUNC more(): INT\n  RETURN x + 1\nENDFUNC") == "");
  CHECK(prompt.enter("FUNC most(): INT\n  RETURN 2 * more()\nENDFUNC") == "");
  CHECK(prompt.enter("VAR x = \"text\"") != "");
  CHECK(prompt.warnings().front().place.line == 3);  // RETURN x + 1
  CHECK(prompt.enter("PRINT most()") == "");
  CHECK(prompt.last() == "print 4");
  CHECK(prompt.enter("VAR x = 5") == "");
  CHECK(prompt.enter("PRINT most(), x") == "");
  CHECK(prompt.last() == "print 125");
  CHECK(prompt.enter("FUNC more(): INT\n  RETURN 10\nENDFUNC") == "");
  CHECK(prompt.enter("PRINT most()") == "");
  CHECK(prompt.last() == "print 20");
  CHECK(prompt.enter("FUNC more(n: INT): INT\n  RETURN n\nENDFUNC") != "");
}

TEST_CASE("declarations keep what they were worth when they were typed") {
  Prompt prompt;
  CHECK(prompt.enter("CONST n = 9") == "");
  CHECK(prompt.enter("CONST twice = 2 * n") == "");
  CHECK(prompt.enter("VAR a: ARRAY[n] OF INT") == "");
  CHECK(prompt.enter("SIGNAL up = DIN[n]") == "");
  CHECK(prompt.enter("CONST n = 1") == "");
  CHECK(prompt.enter("PRINT n, twice, LEN(a)") == "");
  CHECK(prompt.last() == "print 1189");
  CHECK(prompt.enter("PRINT up == DIN[9]") == "");
  CHECK(prompt.last() == "print TRUE");
}

TEST_CASE("types, frames, tools and points of earlier entries are known") {
  Prompt prompt;
  CHECK(prompt.enter("RECORD part\n  width: LENGTH\n  places: ARRAY[2] OF VEC\nENDRECORD") == "");
  CHECK(prompt.enter("VAR p = part(width: 20mm)") == "");
  CHECK(prompt.enter("VAR q: part") == "");
  CHECK(prompt.enter("q = p") == "");
  CHECK(prompt.enter("q.places[1] = (1mm, 2mm, 3mm)") == "");
  CHECK(prompt.enter("PRINT q.width, q.places[1].y") == "");
  CHECK(prompt.last() == "print 20mm2mm");
  CHECK(prompt.enter("PROC widen(REF one: part)\n  one.width = one.width + 1mm\nENDPROC") == "");
  CHECK(prompt.enter("widen(q)") == "");
  CHECK(prompt.enter("PRINT q.width, p.width") == "");
  CHECK(prompt.last() == "print 21mm20mm");
  CHECK(prompt.enter("RECORD part\n  width: LENGTH\nENDRECORD") != "");

  CHECK(prompt.enter("FRAME pallet = POSE(100mm, 0mm, 0mm)") == "");
  CHECK(prompt.enter("VAR here: POSE IN pallet = POSE(1mm, 0mm, 0mm)") == "");
  CHECK(prompt.enter("VAR there: POSE = here") == "");
  CHECK(prompt.enter("PRINT there.x") == "");
  CHECK(prompt.last() == "print 101mm");
  CHECK(prompt.enter("here = POSE(5mm, 0mm, 0mm)") == "");
  CHECK(prompt.enter("PRINT (here * (0mm, 0mm, 0mm)).x, here.x") == "");

  CHECK(prompt.enter("VAR j = JOINTS(1mm, 2mm, 3deg)") == "");
  CHECK(prompt.enter("VAR k = j + j") == "");
  CHECK(prompt.enter("PRINT k[2], k == 2 * j") == "");
  CHECK(prompt.last() == "print 4mmTRUE");

  prompt.points().points.push_back({"spot", "pallet", {{0.001, 0, 0}, {1, 0, 0, 0}}});
  CHECK(prompt.enter("POINT spot") == "");
  CHECK(prompt.enter("PRINT spot.x") == "");
  CHECK(prompt.last() == "print 1mm");
  CHECK(prompt.enter("there = spot") == "");
  CHECK(prompt.enter("PRINT there.x") == "");
  CHECK(prompt.last() == "print 101mm");
}

TEST_CASE("what a file that an earlier entry USEs declares keeps its value and its type") {
  Prompt prompt;
  prompt.files().texts["tools"] =
      "RECORD grip\n  width: LENGTH\nENDRECORD\nVAR opened = 0\nVAR last = grip(width: 5mm)\n"
      "FRAME bench = POSE(10mm, 0mm, 0mm)\n"
      "PROC open(g: grip)\n  opened = opened + 1\n  last = g\nENDPROC\n";
  prompt.files().texts["more"] = "VAR further = 3\n";
  CHECK(prompt.enter("VAR before = 1") == "");
  CHECK(prompt.enter("USE tools") == "");
  CHECK(prompt.enter("VAR after = 2") == "");
  CHECK(prompt.enter("VAR g: grip = grip(width: 7mm)") == "");
  CHECK(prompt.enter("open(g)") == "");
  CHECK(prompt.enter("tools.open(tools.last)") == "");
  CHECK(prompt.enter("VAR p: POSE IN bench = POSE(1mm, 0mm, 0mm)") == "");
  CHECK(prompt.enter("USE more") == "");
  CHECK(prompt.enter("further = further + 1") == "");
  CHECK(prompt.enter("VAR w: POSE = p") == "");
  CHECK(prompt.enter("PRINT before, opened, after, last.width, further, w.x") == "");
  CHECK(prompt.last() == "print 1227mm411mm");
}

TEST_CASE("what is forgotten is unknown, and what it hid is known again") {
  Prompt prompt;
  CHECK(prompt.enter("VAR n = 1") == "");
  CHECK(prompt.enter("VAR n = 1 DIV (n - 1)") != "");  // fails while it runs
  CHECK(prompt.enter("PRINT n") == "");
  CHECK(prompt.last() == "print 1");
  CHECK(prompt.enter("VAR m = n") == "");
  CHECK(prompt.entries().forget("n"));
  CHECK(prompt.enter("PRINT n") == "E201");
  CHECK(prompt.enter("PRINT m") == "");
  CHECK(prompt.enter("FUNC f(): INT\n  RETURN m\nENDFUNC") == "");
  CHECK_FALSE(prompt.entries().forget("M"));
  for (int i = 0; i < 300; ++i) CHECK(prompt.enter("VAR x = 1 DIV (m - 1)") != "");
  CHECK(prompt.enter("VAR y = 4") == "");
  CHECK(prompt.chunk().memory == Slots{});  // those that failed take no room
}

TEST_CASE("SAFE values of earlier entries stay, and are not given twice") {
  Prompt prompt;
  CHECK(prompt.enter("SIGNAL valve = DOUT[1] SAFE ON") == "");
  CHECK(prompt.enter("VAR n = 1") == "");
  REQUIRE(prompt.chunk().safe_values.size() == 1);
  CHECK(prompt.chunk().safe_values.front().value == 1);
  CHECK(prompt.enter("SIGNAL other = DOUT[1] SAFE OFF") == "E276");
}

TEST_CASE("a program of the same text still refuses a second declaration") {
  const Compilation program = compile("VAR x = 1\nVAR x = 2\n", rob::test::gantry_signature());
  CHECK(!program.chunk);
}
