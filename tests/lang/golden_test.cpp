#include "tests/support/golden.h"

#include <doctest/doctest.h>

#include "tests/support/gantry_signature.h"

using rob::test::check_golden;
using rob::test::gantry_signature;

namespace {

std::size_t differences(std::string_view source) {
  return check_golden(source, gantry_signature()).differences.size();
}

}  // namespace

TEST_CASE("a golden program whose expectations are met has no differences") {
  CHECK(differences("MOVE(1,2,3)  // expect: move 1 2 3\n") == 0);
  CHECK(differences("MOVE(1,2)  // expect error: components\n") == 0);
  CHECK(differences("VAR n = 0\nPRINT 1/n  // expect failure: division\n") == 0);
  CHECK(differences("VAR abs = 0  // expect warning: hides\n") == 0);
}

TEST_CASE("what comes unexpectedly, and what does not come, is a difference") {
  CHECK(differences("MOVE(1,2,3)\nSTOP  // expect: stop\n") == 1);
  CHECK(differences("MOVE(1,2,3)  // expect: move 1 2 4\n") == 1);
  CHECK(differences("STOP  // expect: stop\n  // expect: stop\n") == 1);
  CHECK(differences("STOP\n// expect: stop\nMOVE(1,2)\n") == 2);
  CHECK(differences("MOVE(1,2)  // expect error: something else\n") == 2);
  CHECK(differences("VAR n = 0\nPRINT 1/n  // expect error: division\n") == 2);
  CHECK(differences("VAR abs = 0  // expect error: hides\n") == 2);
}

TEST_CASE("a golden program must expect something, in words that can be read") {
  CHECK(differences("VAR n = 1\n") == 1);
  CHECK(differences("STOP  // expect: stop\n// expects: stop\n") == 1);
  CHECK(differences("STOP  // expect: stop\n// given lift_up: MAYBE\n") == 1);
  CHECK(differences("STOP  // expect: stop\n// given lft_up: ON\n") == 1);
}

TEST_CASE("an endless golden program is a difference") {
  CHECK(differences("STOP  // expect: stop\nWHILE TRUE DO\nENDWHILE\n") == 1);
}

TEST_CASE("refusals are handed on") {
  const auto result =
      check_golden("STOP  // expect: stop\n// expect refusal: beyond\n", gantry_signature());
  CHECK(result.differences.empty());
  REQUIRE(result.refusals.size() == 1);
  CHECK(result.refusals[0].line == 1);
  CHECK(result.refusals[0].text == "beyond");
}
