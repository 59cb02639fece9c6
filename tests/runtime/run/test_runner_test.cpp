#include "runtime/run/test_runner.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "motion/robots/robot_library.h"
#include "runtime/run/test_report.h"

using rob::runtime::TestResult;

// A short motion and a stop of the gantry take 2.75 s each, its lift 0.5 s.

namespace {

using Texts = std::vector<std::string>;

std::vector<TestResult> tests_of(const std::string& source) {
  const auto robot = rob::motion::embedded_robot("gantry");
  const auto program = rob::runtime::compile_program("t.rob", source, robot);
  REQUIRE(program.runnable());
  return rob::runtime::run_tests(program, robot);
}

}  // namespace

TEST_CASE("every TEST has a fresh robot, fresh variables, and begins at 0 s") {
  const auto results = tests_of(
      "VAR n = 1\nTEST \"first\"\nn = 2\nlift = ON\nMOVE(40,0,0)\nSTOP\nENDTEST\n"
      "TEST \"second\"\nEXPECT n == 1\nEXPECT lift_down AND NOT lift\nENDTEST");
  REQUIRE(results.size() == 2);
  CHECK(results[0].name == "first");
  CHECK(results[0].passed());
  CHECK(results[0].time == doctest::Approx(5.5));
  CHECK(results[1].passed());
  CHECK(results[1].time == doctest::Approx(0).epsilon(0.001));
}

TEST_CASE(
    "SIMULATE counts from its place in motion order, and drives what the machine drives too") {
  const auto results = tests_of(
      "TEST \"later\"\nMOVE(40,0,0)\nSTOP\nSIMULATE DIN[1] = ON AFTER 1s\nEXPECT NOT DIN[1]\n"
      "WAIT DIN[1] TIMEOUT 1.1s\nENDTEST\n"
      "TEST \"at once\"\nSIMULATE DIN[1] = ON\nEXPECT DIN[1]\nENDTEST\n"
      "TEST \"stuck\"\nSIMULATE lift_up = OFF\nlift = ON\nWAIT lift_up TIMEOUT 2s\nENDTEST\n"
      "TEST \"analog\"\nSIMULATE AIN[2] = 5V\nEXPECT AIN[2] == 5V\nENDTEST");
  REQUIRE(results.size() == 4);
  CHECK(results[0].passed());
  CHECK(results[0].time == doctest::Approx(6.5).epsilon(0.01));
  CHECK(results[1].passed());
  REQUIRE(results[2].error);
  CHECK(results[2].error->code == "E313");
  CHECK(results[3].passed());
}

TEST_CASE("what fails is told with its line, and what was printed with it") {
  const auto results = tests_of(
      "VAR n = 2\nTEST \"a\"\nPRINT \"here\"\nEXPECT n == 3\nASSERT n == 4\nENDTEST\n"
      "TEST \"b\"\nEXPECT TRUE\nENDTEST");
  REQUIRE(results.size() == 2);
  CHECK_FALSE(results[0].passed());
  CHECK(results[0].output == Texts{"here"});
  CHECK(rob::runtime::test_text("t.rob", results) ==
        "FAILED  a (0.00 s)\n"
        "        t.rob:4: EXPECT n == 3 does not hold: left 2, right 3\n"
        "        t.rob:5: error[E320]: ASSERT n == 4 does not hold\n"
        "        printed: here\n"
        "ok      b (0.00 s)\n"
        "t.rob: 1 ok, 1 failed\n");
  const auto json = rob::runtime::test_json("t.rob", results);
  CHECK(json["status"] == "failed");
  CHECK(json["file"] == "t.rob");
  CHECK(json["ok"] == 1);
  CHECK(json["failed"] == 1);
  CHECK(json["tests"][0]["name"] == "a");
  CHECK(json["tests"][0]["line"] == 2);
  CHECK(json["tests"][0]["status"] == "failed");
  CHECK(json["tests"][0]["output"] == Texts{"here"});
  CHECK(json["tests"][0]["failures"][0]["line"] == 4);
  CHECK(json["tests"][1]["line"] == 7);
  CHECK(json["tests"][1]["status"] == "ok");
  const auto timed = tests_of("TEST \"c\"\nWAIT 1.5s\nENDTEST");
  CHECK(rob::runtime::test_json("t.rob", timed)["tests"][0]["measured_s"] == doctest::Approx(1.5));
}

TEST_CASE("an error in a TEST tells the calls that led to it, which the TEST is not") {
  const auto results = tests_of(
      "VAR n = 0\nPROC deep()\nPRINT 1 / n\nENDPROC\nTEST \"a\"\ndeep()\nENDTEST\n"
      "TEST \"b\"\nPRINT 1 / n\nENDTEST");
  const std::string text = rob::runtime::test_text("t.rob", results);
  CHECK(text.find("        in deep, called in line 6\n") != std::string::npos);
  REQUIRE(results.size() == 2);
  CHECK(results[0].error.value().calls.size() == 1);
  CHECK(results[1].error.value().calls.empty());
}

TEST_CASE("a TEST that waits for ever has failed") {
  const auto results = tests_of("TEST \"a\"\nWAIT DIN[1]\nENDTEST");
  REQUIRE(results.size() == 1);
  REQUIRE(results[0].error);
  CHECK(results[0].error->code == "E545");
}

TEST_CASE("too many SIMULATEs that wait are refused, and those that have acted make room") {
  const auto many = tests_of(
      "TEST \"a\"\nFOR i = 1 TO 257 DO\nSIMULATE DIN[1] = ON AFTER 100s\nENDFOR\nENDTEST\n"
      "TEST \"b\"\nFOR i = 1 TO 500 DO\nSIMULATE DIN[1] = ON AFTER 10ms\nWAIT "
      "20ms\nENDFOR\nENDTEST");
  REQUIRE(many.size() == 2);
  REQUIRE(many[0].error);
  CHECK(many[0].error->code == "E544");
  CHECK(many[1].passed());
}

TEST_CASE("a loop of failed EXPECTs keeps the first hundred") {
  const auto results = tests_of("TEST \"a\"\nFOR i = 1 TO 1000 DO\nEXPECT i < 1\nENDFOR\nENDTEST");
  REQUIRE(results.size() == 1);
  CHECK(results[0].failures.size() == 100);
  CHECK(results[0].failures_left_out == 900);
}
