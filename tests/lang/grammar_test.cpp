#include "tests/support/grammar.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include "lang/compile/compile.h"
#include "lang/syntax/parser.h"
#include "lang/text/codes.h"
#include "lang/vm/printing_machine.h"
#include "lang/vm/vm.h"
#include "tests/support/gantry_signature.h"
#include "tests/support/grammar_program.h"
#include "tests/support/process.h"
#include "tests/support/random_text.h"

using namespace rob::lang;
using rob::test::Choice;
using rob::test::Decisions;
using rob::test::Grammar;
using rob::test::tokens_of;

namespace {

const Grammar& grammar() {
  static const Grammar read(
      rob::test::read_whole_file(std::filesystem::path(ROB_SOURCE_DIR) / "docs/rob.ebnf"));
  return read;
}

class Seeded final : public Decisions {
 public:
  explicit Seeded(std::uint64_t seed) : choice_(seed) {}
  std::size_t below(std::size_t count) override {
    return static_cast<std::size_t>(choice_.below(static_cast<int>(count)));
  }

 private:
  Choice choice_;
};

/// What the grammar says in comments only: where something may stand, and how often.
bool is_side_condition(std::string_view code) {
  constexpr std::array kCodes{
      code::kDuplicateClause,  // each clause at most once
      code::kOnlyTopLevel,     // SIGNAL, POINT, … outside all blocks
      code::kMisplaced,        // PROC, FUNC, TASK and TEST too
      code::kHeaderTooLate,    // ROBOT, UNITS, LAW before the first statement
      code::kUnitOfNoTarget,   // UNITS of a length and of an angle
      code::kUnknownType,      // VEC OF a REAL
      code::kNameOfUsedFile,   // nothing else has its name
      code::kFineWithZone,     // one of the two
      code::kTooManyCapsules,  // three of a SHAPE
  };
  return std::ranges::find(kCodes, code) != kCodes.end();
}

/// `MOVE[40, 40, 0]`: a list is no target, and this is met as a beginner's mistake.
bool is_list_as_target(const Diagnostic& found, std::string_view text) {
  for (std::uint32_t line = 1; line < found.place.line; ++line) {
    text.remove_prefix(text.find('\n') + 1);
  }
  return found.code == code::kTargetExpected && text[found.place.column - 1] == '[';
}

/// Nor that JOINT and BY before a plus are names that something is added to.
bool is_sum_of_placed_word(const Diagnostic& found, std::string_view text) {
  for (std::uint32_t line = 1; line < found.place.line; ++line) {
    text.remove_prefix(text.find('\n') + 1);
  }
  text = text.substr(0, text.find('\n'));
  return text.find("MOVE JOINT +") != std::string_view::npos ||
         text.find(" BY +") != std::string_view::npos;
}

std::string refused(const std::string& text) {
  Diagnostics diagnostics;
  parse(text, diagnostics);
  for (const Diagnostic& found : diagnostics.all()) {
    const bool error = found.severity == Severity::Error;
    if (error && !is_side_condition(found.code) && !is_list_as_target(found, text) &&
        !is_sum_of_placed_word(found, text)) {
      return render(found, "sentence", text) + text;
    }
  }
  return "";
}

/// Empty if the text is derivable, otherwise the line behind which it is not.
std::string underivable(const std::string& text) {
  const std::vector<Token> tokens = tokens_of(text);
  std::size_t furthest = 0;
  if (grammar().derives("program", tokens, furthest)) return "";
  const std::size_t last = std::min(furthest, tokens.size() - 1);
  return "line " + std::to_string(tokens[last].place.line) + " at '" +
         std::string(tokens[last].text) + "'";
}

std::vector<std::filesystem::path> programs_below(const char* folder) {
  std::vector<std::filesystem::path> programs;
  const std::filesystem::path root(ROB_SOURCE_DIR);
  for (const auto& entry : std::filesystem::recursive_directory_iterator(root / folder)) {
    if (entry.path().extension() == ".rob") programs.push_back(entry.path());
  }
  std::ranges::sort(programs);
  return programs;
}

}  // namespace

TEST_CASE("the parser accepts every sentence of the grammar") {
  constexpr int kSentences = 2000;
  const std::vector<std::string> names{"alpha", "beta7", "_gamma", "Omega_"};
  for (int seed = 0; seed < kSentences; ++seed) {
    Seeded decisions(static_cast<std::uint64_t>(seed));
    const std::string text = grammar().sentence("program", decisions, names, {});
    CAPTURE(seed);
    CHECK(refused(text) == "");
    CHECK(underivable(text) == "");
  }
}

TEST_CASE("what the parser accepts of the programs at hand is derivable from the grammar") {
  int derived = 0;
  for (const char* const folder : {"examples", "tests/programs", "tests/fuzz/seeds"}) {
    for (const std::filesystem::path& path : programs_below(folder)) {
      const std::string text = rob::test::read_whole_file(path);
      Diagnostics diagnostics;
      parse(text, diagnostics);
      if (diagnostics.has_errors()) continue;
      CAPTURE(path.string());
      CHECK(underivable(text) == "");
      ++derived;
    }
  }
  CHECK(derived > 100);
}

TEST_CASE("programs of sentences that compile run to their end, or fail with a message") {
  const RobotSignature robot = rob::test::gantry_signature();
  int statements = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Seeded decisions(seed);
    int kept = 0;
    const std::string text = rob::test::compiling_program(grammar(), decisions, robot, 50, kept);
    statements += kept;
    CAPTURE(text);
    const Compilation compilation = compile(text, robot);
    REQUIRE(compilation.chunk.has_value());
    PrintingMachine machine(robot);
    Vm vm(*compilation.chunk, machine);
    for (int i = 0; i < 20 && vm.state() != Vm::State::Done && vm.state() != Vm::State::Failed;
         ++i) {
      vm.run(2000);  // an endless loop is legal
    }
    if (vm.state() == Vm::State::Failed) CHECK_FALSE(vm.error().message.empty());
  }
  CHECK(statements > 100);
}

TEST_CASE("a text that is no sentence is not derived, and the place is told") {
  CHECK(underivable("MOVE(1, 2, 3)\nSTOP\n") == "");
  CHECK(underivable("STOP\nSTOP STOP\n") == "line 2 at 'STOP'");
  CHECK(underivable("IF a THEN\nSTOP\n") == "line 2 at ''");
  CHECK(underivable("a = (1\n+ 2)\n") == "");
}

TEST_CASE("a text that is no grammar is refused") {
  CHECK_THROWS(Grammar("a = b ."));
  CHECK_THROWS(Grammar("a = \"b ."));
  CHECK_THROWS(Grammar("a = ( \"b\" ."));
  CHECK_THROWS(Grammar("a = \"b\" . a = \"c\" ."));
  CHECK_NOTHROW(Grammar("a = \"b\" | [ a ] NAME . (* done *)"));
}
