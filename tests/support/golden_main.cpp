#include <cstdio>
#include <string>
#include <vector>

#include "lang/text/codes.h"
#include "lang/text/diagnostic.h"
#include "runtime/files/files.h"
#include "runtime/run/foretell.h"
#include "runtime/run/load.h"
#include "runtime/words/signature.h"
#include "tests/support/golden.h"

namespace {

using rob::test::Expectation;

/// What motion refuses of a program: targets that are known beforehand, or the one that ends it.
struct Refused {
  std::uint32_t line = 0;
  std::string message;
};

std::vector<Refused> refusals_of(const rob::runtime::LoadedProgram& program) {
  std::vector<Refused> refused;
  for (const rob::lang::Diagnostic& found : program.compilation.diagnostics.all()) {
    const bool unreachable = found.code == rob::lang::code::kUnreachable;
    if (unreachable || found.code.starts_with("E4") || found.code.starts_with("E55")) {
      refused.push_back({found.place.line, found.message});
    }
  }
  if (!program.runnable()) return refused;
  const rob::runtime::RunResult result = rob::runtime::foretell(program, program.robot);
  if (result.error) refused.push_back({result.error->place.line, result.error->message});
  return refused;
}

bool meets(const Refused& refused, const Expectation& expected) {
  return refused.line == static_cast<std::uint32_t>(expected.line) &&
         refused.message.find(expected.text) != std::string::npos;
}

}  // namespace

/// `golden FILE.rob`: checks one golden program, on the gantry if it names no other robot, as
/// support/golden.h says, and its
/// refusals against the planner. Exit code 0 or 1.
int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: golden FILE.rob\n", stderr);
    return 64;
  }
  const std::string source = rob::runtime::read_file(argv[1], std::size_t{64} << 20U);
  const auto program = rob::runtime::compile_program("", source, std::string());
  auto [differences, expected] =
      rob::test::check_golden(source, rob::runtime::signature_of(program.robot));
  const std::vector<Refused> refused = refusals_of(program);
  for (const Expectation& expectation : expected) {
    bool met = false;
    for (const Refused& one : refused) met = met || meets(one, expectation);
    if (met) continue;
    differences.push_back("line " + std::to_string(expectation.line) +
                          ": not refused with: " + expectation.text);
  }
  for (const std::string& difference : differences) {
    std::fprintf(stderr, "%s: %s\n", argv[1], difference.c_str());
  }
  return differences.empty() ? 0 : 1;
}
