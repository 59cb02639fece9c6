#include <doctest/doctest.h>

#include <fmt/format.h>

#include <deque>
#include <optional>
#include <string>

#include "runtime/files/signal_script.h"
#include "runtime/run/foretell.h"
#include "runtime/run/run.h"
#include "runtime/run/test_runner.h"
#include "tests/support/stepped_run.h"

using namespace rob;
using runtime::ExitCode;
using runtime::RunOptions;
using runtime::RunResult;

namespace {

/// Answers with the lines that it is given, each at the third time of asking.
class Typist final : public runtime::Person {
 public:
  explicit Typist(std::deque<std::string> lines) : lines_(std::move(lines)) {}

  bool present() override { return !lines_.empty(); }
  void listen() override { ++heard; }
  std::optional<std::string> line() override {
    if (++asked_ % 3 != 0) return std::nullopt;
    std::string line = lines_.front();
    lines_.pop_front();
    return line;
  }

  int heard = 0;

 private:
  std::deque<std::string> lines_;
  int asked_ = 0;
};

const motion::RobotModel& gantry() {
  static const motion::RobotModel robot = motion::embedded_robot("gantry");
  return robot;
}

RunResult run_with(const std::string& text, const std::string& script,
                   runtime::Person* person = nullptr) {
  const auto program = runtime::compile_program("test.rob", text, gantry());
  REQUIRE(program.runnable());
  const auto signals = runtime::parse_signal_script("test.sig", script, gantry(),
                                                    program.compilation.chunk->named_signals);
  REQUIRE_FALSE(signals.diagnostics.has_errors());
  RunOptions options;
  options.fast = true;
  options.script = &signals;
  options.person = person;
  return runtime::run(program, gantry(), options, {});
}

std::string events_of(const RunResult& result) {
  std::string text;
  for (const auto& event : result.events) {
    text += fmt::format("{:.2f} {} {} {}\n", event.time, event.line, event.kind, event.text);
  }
  return text;
}

}  // namespace

TEST_CASE("a HALT stands at its target until the script says GO") {
  // t_acc = 1.375 s: the first line is over at 2.75 + 2.75 s, exactly.
  const RunResult result =
      run_with("MOVE(40, 0, 0)\nHALT \"go?\"\nMOVE(80, 0, 0)", "at 8s GO = ON");
  CHECK(result.exit_code == ExitCode::Done);
  REQUIRE(result.events.size() == 2);
  CHECK(result.events[0].kind == std::string("halt"));
  CHECK(result.events[0].text == "go?");
  CHECK(result.events[0].time >= 5.5);
  CHECK(result.events[0].time < 5.55);
  CHECK(result.events[1].kind == std::string("answer"));
  CHECK(result.events[1].time >= 8);
  CHECK(result.events[1].time < 8.05);
  CHECK(test::line(result, 1).measured == doctest::Approx(2.75));
  CHECK(test::line(result, 2).measured ==
        doctest::Approx(result.events[1].time - 2.75).epsilon(0.01));
  CHECK(test::line(result, 3).starts < 8.05);
  CHECK(result.final_joints[0] == 80);
}

TEST_CASE("a GO that comes early is for the next HALT, and for one alone") {
  const RunResult result =
      run_with("WAIT 2s\nHALT\nPRINT \"on\"\nHALT\nPRINT \"never\"", "at 1s GO = ON");
  CHECK(result.output == std::vector<std::string>{"on"});
  REQUIRE(result.error);
  CHECK(result.error->code == "E342");
  CHECK(result.error->place.line == 4);
  CHECK(result.exit_code == ExitCode::Fault);
  CHECK(result.measured < 2.1);
}

TEST_CASE("HALT and ASK with nobody there are errors that a TRY can catch") {
  const RunResult result = run_with(
      "VAR n = 3\nTRY\nHALT\nRESCUE why\nPRINT why\nENDTRY\nTRY\nASK \"n? \" INTO n\nRESCUE why\n"
      "PRINT why\nENDTRY\nPRINT n",
      "");
  REQUIRE(result.output.size() == 3);
  CHECK(result.output[0] == "E342: HALT waits for the operator, and nobody is there");
  CHECK(result.output[1] == "E342: ASK waits for the operator, and nobody is there");
  CHECK(result.output[2] == "3");
}

TEST_CASE("an ASK that cannot read its answer asks again") {
  const RunResult result = run_with("VAR way = 1mm\nASK \"way? \" INTO way\nPRINT way",
                                    "at 1s ANSWER = \"far\"\nat 2s ANSWER = \"25mm\"");
  CHECK(result.output == std::vector<std::string>{"25mm"});
  REQUIRE(result.events.size() == 4);
  CHECK(result.events[0].text == "way? ");
  CHECK(result.events[1].text == "far");
  CHECK(result.events[2].text == "'far' is not a length, such as 5mm; way? ");
  CHECK(result.events[3].text == "25mm");
}

TEST_CASE("what was commanded before has acted when the operator is asked") {
  const RunResult result = run_with("lift = ON\nPRINT \"before\"\nHALT\nlift = OFF",
                                    "when lift == ON after 1s : GO = ON");
  CHECK(result.exit_code == ExitCode::Done);
  REQUIRE(result.signals.size() == 2);
  CHECK(result.signals[1].time - result.signals[0].time == doctest::Approx(1).epsilon(0.05));
}

TEST_CASE("a person answers where no script does any more") {
  Typist typist({"", "7"});
  const RunResult result = run_with("VAR n = 0\nHALT\nHALT \"second\"\nASK \"n? \" INTO n\nPRINT n",
                                    "at 1s GO = ON", &typist);
  CHECK(result.output == std::vector<std::string>{"7"});
  CHECK(typist.heard == 3);
  CHECK_FALSE(typist.present());
}

TEST_CASE("a person who has gone leaves a HALT with nobody there") {
  Typist typist({""});
  const RunResult result = run_with("HALT\nHALT", "", &typist);
  REQUIRE(result.error);
  CHECK(result.error->code == "E342");
  CHECK(result.error->place.line == 2);
}

TEST_CASE("HALT and ASK are foretold as answered, with a finding each") {
  const auto program = runtime::compile_program(
      "test.rob", "VAR n = 4\nHALT \"go?\"\nASK \"n? \" INTO n\nMOVE(n * 10, 0, 0)\nHALT",
      gantry());
  REQUIRE(program.runnable());
  const RunResult result = runtime::foretell(program, gantry());
  CHECK(result.exit_code == ExitCode::Done);
  REQUIRE(result.findings.size() == 3);
  for (const auto& finding : result.findings) CHECK(finding.code == "N631");
  CHECK(result.findings[0].place.line == 2);
  CHECK(result.findings[0].message == "assumed: this HALT goes on at once");
  CHECK(result.final_joints[0] == 40);

  const auto script =
      runtime::parse_signal_script("a.sig", "at 9s GO = ON\nat 9s ANSWER = \"2\"", gantry(), {});
  const RunResult scripted = runtime::foretell(program, gantry(), {.seed = 1, .script = &script});
  CHECK(scripted.final_joints[0] == 20);
  CHECK(scripted.findings.size() == 1);
  CHECK(test::line(scripted, 4).starts > 9);
}

TEST_CASE("SIMULATE plays the operator in a TEST") {
  const auto program = runtime::compile_program(
      "test.rob",
      "VAR n = 0\n"
      "PROC fill()\nHALT \"fill\"\nASK \"n? \" INTO n\nENDPROC\n"
      "TEST \"filled\"\nSIMULATE GO = OFF\nSIMULATE GO = ON AFTER 2s\n"
      "SIMULATE ANSWER = STR(3 + 4) AFTER 3s\nfill()\nEXPECT n == 7\nEXPECT CLOCK >= 3s\nENDTEST\n"
      "TEST \"nobody\"\nfill()\nENDTEST\n",
      gantry());
  REQUIRE(program.runnable());
  const auto results = runtime::run_tests(program, gantry(), 1);
  REQUIRE(results.size() == 2);
  CHECK(results[0].failures.empty());
  CHECK_FALSE(results[0].error);
  CHECK(results[0].time == doctest::Approx(3).epsilon(0.05));
  REQUIRE(results[1].error);
  CHECK(results[1].error->code == "E342");
}

TEST_CASE("a run with an operator has the same bits every time") {
  const char* const text = "MOVE(40, 0, 0)\nHALT\nMOVE(0, 0, 0)";
  Typist quick({""});
  CHECK(events_of(run_with(text, "at 7s GO = ON")) == events_of(run_with(text, "at 7s GO = ON")));
  CHECK(run_with(text, "", &quick).exit_code == ExitCode::Done);
}
