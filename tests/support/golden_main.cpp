#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>

#include "tests/support/gantry_signature.h"
#include "tests/support/golden.h"

/// `golden FILE.rob`: checks one golden program, as support/golden.h says. Exit code 0 or 1.
int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: golden FILE.rob\n", stderr);
    return 64;
  }
  std::ifstream file(argv[1], std::ios::binary);
  if (!file) {
    std::fprintf(stderr, "%s: cannot be read\n", argv[1]);
    return 74;
  }
  const std::string source{std::istreambuf_iterator<char>(file), {}};
  rob::test::GoldenResult result = rob::test::check_golden(source, rob::test::gantry_signature());
  for (const auto& refusal : result.refusals) {
    result.differences.push_back("line " + std::to_string(refusal.line) +
                                 ": a refusal needs the planner: " + refusal.text);
  }
  for (const std::string& difference : result.differences) {
    std::fprintf(stderr, "%s: %s\n", argv[1], difference.c_str());
  }
  return result.differences.empty() ? 0 : 1;
}
