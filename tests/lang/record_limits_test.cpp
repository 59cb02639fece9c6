#include <doctest/doctest.h>

#include <string>

#include "tests/lang/program_run.h"

using rob::test::ProgramRun;

namespace {

/// Records r1 to rn, each of which holds the one before it.
std::string nested(int count) {
  std::string source = "RECORD r1\n  x: INT\nENDRECORD\n";
  for (int i = 2; i <= count; ++i) {
    source += "RECORD r" + std::to_string(i) + "\n  x: r" + std::to_string(i - 1) + "\nENDRECORD\n";
  }
  return source;
}

}  // namespace

TEST_CASE("records may hold each other 200 levels deep") {
  ProgramRun program(nested(200) + "VAR a, b: r200\nPRINT a == b\n");
  CHECK(program.printed() == "TRUE");
}

TEST_CASE("records that are nested deeper are an error of their own, and nothing else") {
  const ProgramRun program(nested(5000) + "VAR a: r5000\nPRINT a == a\n");
  CHECK_FALSE(program.compiled());
  CHECK(program.first_error().code == "E141");
  CHECK(program.first_error().place.line == 3 * 200 + 2);
}

TEST_CASE("records that double in size end where the memory does") {
  std::string source = "RECORD r1\n  x, y: INT\nENDRECORD\n";
  for (int i = 2; i <= 40; ++i) {
    source +=
        "RECORD r" + std::to_string(i) + "\n  x, y: r" + std::to_string(i - 1) + "\nENDRECORD\n";
  }
  const ProgramRun program(source + "VAR a: r40\nPRINT a\n");
  // r18 takes 2^18 numbers, which are all there are.
  CHECK(program.first_error().code == "E229");
  CHECK(program.first_error().place.line == 3 * 18 + 2);
}
