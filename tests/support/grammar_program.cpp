#include "tests/support/grammar_program.h"

#include "lang/compile/compile.h"

namespace rob::test {
namespace {

constexpr const char* kDeclarations = R"(SIGNAL part = DIN[1]
SIGNAL valve = DOUT[1]
VAR n = 1
VAR r = 2.5
VAR d = 20mm
VAR b = TRUE
VAR s = "text"
VAR v = (1mm, 2mm, 3mm)
VAR p = POSE(40mm, 40mm, 0mm)
PROC act(k: INT = 1)
  n = n + k
ENDPROC
FUNC twice(k: INT): INT
  RETURN 2 * k
ENDFUNC
)";

/// What is declared above, some built-in names, fields and coordinates, and three that are free.
const std::vector<std::string> kNames{
    "part", "valve", "n",     "r",    "d",   "b",   "s",   "v",   "p",   "act", "twice", "x",
    "y",    "k",     "CLOCK", "HERE", "HIT", "ABS", "MAX", "STR", "LEN", "one", "two",   "three"};

/// [choice] long enough for a block with a statement, short enough to be of one type by chance.
constexpr Grammar::Shape kShape{.longest = 60, .one_of = 6};

/// Statements on one line more often than the rest.
const std::vector<std::string> kRules{"simple",    "simple",      "simple",
                                      "statement", "declaration", "routine"};

}  // namespace

std::string compiling_program(const Grammar& grammar, Decisions& decisions,
                              const lang::RobotSignature& robot, int tries, int& kept) {
  std::string program = kDeclarations;
  kept = 0;
  for (int i = 0; i < tries; ++i) {
    std::string longer = program;
    const std::string& rule = kRules[decisions.below(kRules.size())];
    longer += grammar.sentence(rule, decisions, kNames, kShape) + "\n";
    if (!lang::compile(longer, robot).chunk) continue;
    program = std::move(longer);
    ++kept;
  }
  return program;
}

}  // namespace rob::test
