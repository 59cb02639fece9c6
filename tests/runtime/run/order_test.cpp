#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "runtime/files/signal_script.h"
#include "runtime/run/run.h"
#include "tests/support/stepped_run.h"

using namespace rob;
using runtime::RunResult;

// On the gantry: 2·t_acc = 2.75 s, cycles of 10 ms, 20 mm/s.

namespace {

RunResult run(const std::string& text, const std::string& script = "") {
  const motion::RobotModel gantry = motion::embedded_robot("gantry");
  const auto program = runtime::compile_program("test.rob", text, gantry);
  REQUIRE(program.runnable());
  const auto signals = runtime::parse_signal_script("test.sig", script, gantry,
                                                    program.compilation.chunk->named_signals);
  REQUIRE_FALSE(signals.diagnostics.has_errors());
  runtime::RunOptions options;
  options.fast = true;
  options.script = &signals;
  return runtime::run(program, gantry, options, {});
}

std::vector<std::string> switched(const RunResult& result) {
  std::vector<std::string> all;
  for (const runtime::SignalChange& one : result.signals) {
    all.push_back(one.name + (one.value ? " ON" : " OFF"));
  }
  return all;
}

using Lines = std::vector<std::string>;

}  // namespace

TEST_CASE("what goes wrong behind the decision point of a TRY's last motion is not its own") {
  const std::string program =
      "TRY\nTRY\nWHEN DIN[1] : RAISE \"x\"\nMOVE(100, 0, 0)\n"
      "RESCUE why\nPRINT \"inner \", why\nENDTRY\nMOVE(100, 100, 0)\n"
      "RESCUE why\nPRINT \"outer \", why\nENDTRY\n";
  // 100 mm take 5 s, and that is the decision point; the corner's middle is 1.375 s behind it.
  CHECK(run(program, "at 4.9s DIN[1] = ON").output == Lines{"inner x"});
  CHECK(run(program, "at 5.5s DIN[1] = ON").output == Lines{"outer x"});
  CHECK(run(program, "at 6.2s DIN[1] = ON").output == Lines{"outer x"});
  CHECK(run(program, "at 6.5s DIN[1] = ON").output.empty());
}

TEST_CASE("a repeated call reads the world again in the next cycle, a statement behind does not") {
  const RunResult result =
      run("FUNC now(): TIME\nRETURN CLOCK\nENDFUNC\n"
          "WAIT 0.1s\nVAR a = CLOCK\nVAR b = CLOCK\nPRINT b - a\n"
          "VAR c = now()\nVAR d = now()\nPRINT ROUND((d - c) / 1ms)\n");
  CHECK(result.output == Lines{"0s", "10"});
}

TEST_CASE("readings at one standstill belong to one cycle, prints between them or not") {
  const RunResult result =
      run("MOVE(10,0,0)\nSTOP\nVAR t = CLOCK\nPRINT CLOCK == t\nPRINT CLOCK == t\n"
          "DOUT[1] = ON\nPRINT CLOCK > t\nWAIT 0s\nPRINT CLOCK == t");
  CHECK(result.output == Lines{"TRUE", "TRUE", "TRUE", "FALSE"});
}

TEST_CASE("a million instructions without a wait take a cycle of virtual time") {
  const auto clock_behind = [](const std::string& turns) {
    const RunResult result = run("VAR n = 0\nFOR i = 1 TO " + turns +
                                 " DO\nn = n + i\nENDFOR\nPRINT ROUND(CLOCK / 1ms)\n");
    return std::stoi(result.output.at(0));
  };
  CHECK(clock_behind("1000") == 0);
  // A turn is one instruction at least, and five at most.
  CHECK(clock_behind("4000000") >= 30);
  CHECK(clock_behind("4000000") <= 200);
}

TEST_CASE("a written MOVE of no length always takes its time, a further STOP, FINE or END none") {
  const RunResult result = run(
      "MOVE(20, 0, 0)\nMOVE(20, 0, 0)\nMOVE(20, 0, 0)\nSTOP\nSTOP\nMOVE(20, 0, 0) FINE\nSTOP\n");
  CHECK(result.measured == doctest::Approx(4 * 2.75).epsilon(1e-9));
}

TEST_CASE("in one cycle WHENs act in the order in which they were armed, and a RAISE ends them") {
  const std::string behind = "lift = ON\nWAIT 1s\n";
  CHECK(switched(run("WHEN lift_up : DOUT[1] = ON\nWHEN lift_up : DOUT[2] = ON\n"
                     "WHEN lift_up : DOUT[1] = OFF\n" +
                     behind)) == Lines{"lift ON", "DOUT[1] ON", "DOUT[2] ON", "DOUT[1] OFF"});
  // What was not asked for that reason is asked in the next cycle, beside the braking.
  const RunResult raised =
      run("WHEN lift_up : DOUT[1] = ON\nWHEN lift_up : RAISE \"x\"\n"
          "WHEN lift_up : DOUT[2] = ON\n" +
          behind);
  REQUIRE(switched(raised) == Lines{"lift ON", "DOUT[1] ON", "DOUT[2] ON"});
  CHECK(raised.signals[2].time - raised.signals[1].time == doctest::Approx(0.01));
}

TEST_CASE("effects have room of their own; where it is full the blend is lost and told") {
  const auto with_effects = [](const std::string& count) {
    return run("MOVE(100, 0, 0)\nFOR i = 1 TO " + count +
               " DO\nlift = ON\nENDFOR\nMOVE(200, 0, 0)\n");
  };
  const RunResult fits = with_effects("1000");
  CHECK(fits.starved == 0);
  CHECK(fits.measured == doctest::Approx(12.75).epsilon(1e-9));
  const RunResult too_many = with_effects("1100");
  CHECK(too_many.starved == 1);
  CHECK(too_many.measured > 15.5 - 1e-9);  // an exact stop more
  CHECK(std::ranges::any_of(too_many.events,
                            [](const auto& one) { return one.kind == "late-decision"; }));
}
