#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "runtime/files/signal_script.h"
#include "runtime/run/foretell.h"
#include "runtime/run/run.h"
#include "tests/support/stepped_run.h"

/// What holds of the order and the times of a run as a whole; tests/programs/README.md has the
/// table. On the gantry: 2·t_acc = 2.75 s, cycles of 10 ms, 20 mm/s.

using namespace rob;
using runtime::RunResult;
using test::line;
using test::SteppedRun;

namespace {

RunResult run_rules(const std::string& text, const std::string& script = "") {
  const motion::RobotModel gantry = motion::embedded_robot("gantry");
  const auto program = runtime::compile_program("test.rob", text, gantry);
  REQUIRE(program.runnable());
  const auto signals = runtime::parse_signal_script("test.sig", script, gantry,
                                                    program.compilation.chunk->named_signals);
  REQUIRE_FALSE(signals.diagnostics.has_errors());
  runtime::RunOptions options;
  options.fast = true;
  options.script = &signals;
  return runtime::run(program, program.robot, options, {});
}

using Lines = std::vector<std::string>;

bool found(const RunResult& result, const std::string& code, const std::string& text) {
  return std::ranges::any_of(result.findings, [&](const lang::Diagnostic& one) {
    return one.code == code && one.message.find(text) != std::string::npos;
  });
}

}  // namespace

TEST_CASE("what is queued carries the values of its place in the program") {
  const RunResult result = run_rules(
      "VAR n = 1\nVAR up = TRUE\nMOVE(100, 0, 0)\nPRINT n\nlift = up\nn = 2\nup = FALSE\n"
      "MOVE(100, 100, 0)\nPRINT n\nlift = up\n");
  CHECK(result.output == Lines{"1", "2"});
  REQUIRE(result.signals.size() == 2);
  CHECK(result.signals[0].value == 1);
  CHECK(result.signals[1].value == 0);
  // In the middle of the corner, 5 s + t_acc, and where (100, 100) is reached.
  CHECK(result.signals[0].time == doctest::Approx(6.38));
  CHECK(result.signals[1].time == doctest::Approx(12.75));
}

TEST_CASE("of AT and OVER the slower one counts") {
  const RunResult result =
      run_rules("MOVE(100, 0, 0) AT 10mm/s OVER 20s FINE\nMOVE(0, 0, 0) AT 5mm/s OVER 1s FINE\n");
  CHECK(line(result, 1).measured == doctest::Approx(20 + 2.75));
  CHECK(line(result, 2).measured == doctest::Approx(20 + 2.75));
}

TEST_CASE("durations are exact, and the cycles are those that have begun") {
  const RunResult result = run_rules("WAIT 0.333s\n");
  CHECK(result.measured == doctest::Approx(0.333).epsilon(1e-12));
  CHECK(result.cycles == 34);
  CHECK(run_rules("MOVE(100, 0, 0)\n").cycles ==
        775);  // 5 s + 2.75 s, no cycle is begun at the end
}

TEST_CASE(
    "within one cycle come WHENs, then what is queued; a TASK's output acts in the next one") {
  const RunResult result = run_rules(
      "TASK beside\nWAIT DIN[1]\nDOUT[3] = ON\nENDTASK\nSTART beside\n"
      "WHEN DIN[1] : DOUT[1] = ON\nWAIT 1s\nDOUT[2] = ON\nDOUT[1] = OFF\nWAIT 1s\n",
      "at 1s DIN[1] = ON");
  const double times[] = {1, 1, 1, 1.01};
  const char* const names[] = {"DOUT[1]", "DOUT[2]", "DOUT[1]", "DOUT[3]"};
  REQUIRE(result.signals.size() == 4);
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(result.signals[i].name == names[i]);
    CHECK(result.signals[i].time == doctest::Approx(times[i]));
  }
  CHECK(result.signals[2].value == 0);
}

TEST_CASE("UNTIL ends its motion before what is queued behind it is looked at") {
  // The place and the end of the guard come in one cycle: what is behind the end is dropped.
  const RunResult result =
      run_rules("MOVE(100, 0, 0) UNTIL DIN[1] DO\nAFTER 50mm : DOUT[1] = ON\nENDMOVE\nPRINT HIT\n",
                "at 1s DIN[1] = ON");
  CHECK(result.signals.empty());
  CHECK(result.output == Lines{"TRUE"});
}

TEST_CASE("UNTIL concerns its motion, not the stop that another tool makes before it") {
  for (const char* law : {"LAW PAUL\n", "LAW LOOKAHEAD\n"}) {
    CAPTURE(law);
    const RunResult result = run_rules(std::string(law) +
                                           "TOOL pen = POSE(30mm, 0mm, 0mm)\nMOVE(100, 0, 0)\n"
                                           "WITH pen DO\nMOVE(200, 0, 0) UNTIL DIN[1]\nPRINT HIT\n"
                                           "ENDWITH\nMOVE(50, 0, 0) UNTIL DIN[2]\nPRINT HIT\n",
                                       "at 8.5s DIN[1] = ON");
    CHECK(result.output == Lines{"TRUE", "FALSE"});
  }
}

TEST_CASE("under the look-ahead law a corner is half of the line before it, half of that behind") {
  SteppedRun both("LAW LOOKAHEAD\nMOVE(100, 0, 0) ZONE 5mm\nMOVE(100, 100, 0)\n");
  const RunResult result = both.run();
  // Both legs and axes are alike: the first begins, and the second ends, at rest.
  CHECK(line(result, 2).measured == doctest::Approx(line(result, 3).measured).epsilon(0.003));
  CHECK(line(result, 3).starts == doctest::Approx(line(result, 2).measured));
  for (const runtime::Snapshot& row : both.rows) {
    const auto& [time, q, qd, qdd] = row.sample.reference;
    if (std::fabs(time - line(result, 3).starts) > 0.0051) continue;
    CHECK(std::fabs((0.1 - q[0]) - q[1]) < 0.02 * 0.01);  // on the bisector, to a cycle's way
    CHECK(q[1] > 0.0005);
  }
}

TEST_CASE("a LEAD longer than the way from standstill to its place is a finding, under both laws") {
  for (const char* law : {"LAW PAUL\n", "LAW LOOKAHEAD\n"}) {
    const std::string head = std::string(law) + "MOVE(100, 0, 0) DO\n";
    const RunResult early = run_rules(head + "AFTER 0.01mm LEAD 0.5s : DOUT[1] = ON\nENDMOVE\n");
    CHECK(found(early, "W646", "as the motion begins"));
    REQUIRE(early.signals.size() == 1);
    CHECK(early.signals[0].time == doctest::Approx(0));
    const RunResult kept = run_rules(head + "AFTER 50mm LEAD 0.5s : DOUT[1] = ON\nENDMOVE\n");
    CHECK(kept.findings.empty());
  }
}

TEST_CASE("a warning of a corner names both its lines") {
  const RunResult cut = run_rules("LAW LOOKAHEAD\nMOVE(100, 0, 0) ZONE 80mm\nMOVE(100, 100, 0)\n");
  CHECK(found(cut, "W644", "lines 2 and 3, which meet here,"));
  const RunResult same = run_rules(
      "LAW LOOKAHEAD\nFOR i = 1 TO 2 DO\nMOVE BY (20, 0, 0) ZONE 80mm\nMOVE BY (0, 20, "
      "0)\nENDFOR\n");
  CHECK(found(same, "W644", "lines 3 and 4, which meet here,"));
  const RunResult exact = runtime::foretell(
      runtime::compile_program("test.rob",
                               "ROBOT \"irb120\"\nMOVE(302, 0, 558, 180, 0, 180)\n"
                               "MOVEL BY (0, 150mm, 0) AT 400mm/s ZONE 0.01mm\n"
                               "MOVEL BY (-150mm, 0, 0) AT 400mm/s\n",
                               motion::embedded_robot("irb120")),
      motion::embedded_robot("irb120"));
  CHECK(found(exact, "W641", "lines 3 and 4, which meet here,"));
  const RunResult tool =
      run_rules("TOOL pen = POSE(30mm, 0mm, 0mm)\nMOVE(100, 0, 0)\nMOVE(200, 0, 0) WITH pen\n");
  CHECK(found(tool, "W511", "the target of line 2 is reached exactly"));
}
