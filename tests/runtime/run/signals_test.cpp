#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "tests/support/stepped_run.h"

using rob::runtime::RunResult;
using rob::runtime::SignalChange;
using rob::test::SteppedRun;

// Every short motion and every stop of the gantry takes 2.75 s; a control cycle 10 ms.

namespace {

/// "0.05 lift on", one for each change.
std::vector<std::string> changes(const RunResult& result) {
  std::vector<std::string> texts;
  for (const SignalChange& change : result.signals) {
    char text[80];
    std::snprintf(text, sizeof text, "%.2f %s %s", change.time, change.name.c_str(),
                  change.value ? "on" : "off");
    texts.emplace_back(text);
  }
  return texts;
}

using Texts = std::vector<std::string>;

}  // namespace

TEST_CASE("an analog output carries its share of 10 V, in motion order") {
  auto backend = rob::test::simulated(rob::motion::embedded_robot("gantry"));
  auto* const gantry = dynamic_cast<rob::drivers::SimGantry*>(backend.get());
  REQUIRE(gantry != nullptr);
  SteppedRun run(
      "SIGNAL wire: SPEED = AOUT[2] SCALE 0mm/s TO 300mm/s\n"
      "MOVE(40,0,0)\nSTOP\nwire = 150mm/s\nPRINT wire",
      std::move(backend));
  const RunResult result = run.run();
  REQUIRE(result.signals.size() == 1);
  CHECK(result.signals[0].name == "wire");
  CHECK(result.signals[0].number == 150);
  CHECK(result.signals[0].unit == "mm/s");
  CHECK(result.signals[0].time == doctest::Approx(5.5));
  CHECK(gantry->analog_output(1) == 5);
  CHECK(gantry->analog_output(0) == 0);
  REQUIRE(result.output.size() == 1);
  CHECK(result.output[0] == "150mm/s");
}

TEST_CASE("what an analog output cannot carry is cut, with a warning") {
  SteppedRun run("AOUT[1] = 12V\nAOUT[1] = 10V\nWAIT 0s\nPRINT AOUT[1]");
  const RunResult result = run.run();
  REQUIRE(result.signals.size() == 2);
  CHECK(result.signals[0].name == "AOUT[1]");
  CHECK(result.signals[0].number == 10);
  REQUIRE(result.events.size() == 1);
  CHECK(result.events[0].kind == "warning");
  CHECK(result.events[0].text ==
        "AOUT[1]: 12V is beyond what the channel carries; it is set to 10V");
  REQUIRE(result.findings.size() == 1);
  CHECK(result.findings[0].code == "W630");
  CHECK(result.findings[0].place.line == 1);
  REQUIRE(result.output.size() == 1);
  CHECK(result.output[0] == "10V");
}

TEST_CASE("an analog input to which nothing is wired reads 0 V") {
  SteppedRun run("SIGNAL level = AIN[1] SCALE -1mm TO 1mm\nPRINT AIN[4], \" \", level");
  const RunResult result = run.run();
  REQUIRE(result.output.size() == 1);
  CHECK(result.output[0] == "0V -1mm");
}

TEST_CASE("the report calls an output as the program does") {
  SteppedRun run("SIGNAL hoist = DOUT[9]\nlift = ON\nDOUT[10] = ON\nDOUT[1] = ON");
  CHECK(changes(run.run()) == Texts{"0.00 hoist on", "0.00 gripper on", "0.00 DOUT[1] on"});
}

TEST_CASE("a PULSE is on for its time, in motion order, whatever the program does") {
  SteppedRun run("MOVE(40,0,0)\nSTOP\nPULSE lift 50ms\nMOVE(0,0,0)\nWAIT 0.1s");
  const RunResult result = run.run();
  CHECK(changes(result) == Texts{"5.50 lift on", "5.55 lift off"});
  CHECK(result.measured == doctest::Approx(4 * 2.75 + 0.1));
}

TEST_CASE("an override does not stretch a PULSE") {
  SteppedRun run("MOVE(40,0,0)\nPULSE lift 50ms\nMOVE(0,0,0)", nullptr, 0.5);
  const RunResult result = run.run();
  REQUIRE(result.signals.size() == 2);
  CHECK(result.signals[1].time - result.signals[0].time == doctest::Approx(0.05));
}

TEST_CASE("a second PULSE prolongs the first, and never shortens it") {
  SteppedRun longer("PULSE lift 50ms\nWAIT 0.03s\nPULSE lift 50ms");
  CHECK(changes(longer.run()) == Texts{"0.00 lift on", "0.03 lift on", "0.08 lift off"});
  SteppedRun shorter("PULSE lift 90ms\nWAIT 0.03s\nPULSE lift 20ms");
  CHECK(changes(shorter.run()) == Texts{"0.00 lift on", "0.03 lift on", "0.09 lift off"});
}

TEST_CASE("an assignment takes the place of a PULSE that is under way") {
  SteppedRun on("PULSE lift 50ms\nWAIT 0.02s\nlift = ON\nWAIT 0.1s");
  CHECK(changes(on.run()) == Texts{"0.00 lift on", "0.02 lift on"});
  SteppedRun off("PULSE lift 50ms\nWAIT 0.02s\nlift = OFF\nWAIT 0.1s");
  CHECK(changes(off.run()) == Texts{"0.00 lift on", "0.02 lift off"});
}

TEST_CASE("the end of the program waits for its pulses, and takes no time of its own") {
  SteppedRun run("PULSE lift 300ms\nPULSE gripper 100ms");
  const RunResult result = run.run();
  CHECK(changes(result) ==
        Texts{"0.00 lift on", "0.00 gripper on", "0.10 gripper off", "0.30 lift off"});
  CHECK(result.measured == 0);
}

TEST_CASE("an interruption ends the pulses at once") {
  SteppedRun run("PULSE lift 100s\nMOVE(40,0,0)\nSTOP");
  run.each_cycle = [&](double time) {
    if (time > 1) run.controller.request_hold();
  };
  const RunResult result = run.run();
  REQUIRE(result.signals.size() == 2);
  CHECK_FALSE(result.signals[1].value);
  CHECK(result.signals[1].time < 2);
}
