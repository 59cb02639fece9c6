#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "runtime/files/signal_script.h"
#include "runtime/run/foretell.h"
#include "runtime/run/run.h"
#include "runtime/run/test_runner.h"
#include "tests/support/stepped_run.h"

using namespace rob;
using runtime::ExitCode;
using runtime::RunResult;

namespace {

const motion::RobotModel& gantry() {
  static const motion::RobotModel robot = motion::embedded_robot("gantry");
  return robot;
}

RunResult run_tasks(const std::string& text, const std::string& script = "") {
  const auto program = runtime::compile_program("test.rob", text, gantry());
  for (const auto& found : program.compilation.diagnostics.all()) MESSAGE(found.message);
  REQUIRE(program.runnable());
  const auto signals = runtime::parse_signal_script("test.sig", script, gantry(),
                                                    program.compilation.chunk->named_signals);
  REQUIRE_FALSE(signals.diagnostics.has_errors());
  runtime::RunOptions options;
  options.fast = true;
  options.script = &signals;
  return runtime::run(program, gantry(), options, {});
}

}  // namespace

TEST_CASE("a TASK goes on beside a motion, and ends with the program") {
  // The motion takes 2.75 s; the output changes at 0 s, 1 s and 2 s, a cycle later each.
  const RunResult result = run_tasks(
      "TASK blink\nLOOP\ngripper = NOT gripper\nWAIT 1s\nENDLOOP\nENDTASK\n"
      "START blink\nMOVE(20, 0, 0)\nSTOP\n");
  CHECK(result.exit_code == ExitCode::Done);
  CHECK(result.measured == doctest::Approx(5.5));
  REQUIRE(result.signals.size() == 6);
  CHECK(result.signals[0].value);
  CHECK_FALSE(result.signals[1].value);
  CHECK(result.signals[1].line == 3);
  for (std::size_t i = 1; i < result.signals.size(); ++i) {
    CHECK(result.signals[i].time - result.signals[i - 1].time == doctest::Approx(1));
  }
  CHECK(result.dropped_effects == 0);
}

TEST_CASE("START takes effect in motion order") {
  // Behind a blended motion: in the middle of its corner, 2.75 s.
  const RunResult result = run_tasks(
      "TASK mark\nPRINT \"at \", CLOCK\nENDTASK\n"
      "MOVE(40, 0, 0)\nSTART mark\nMOVE(40, 40, 0)\n");
  REQUIRE(result.output.size() == 1);
  CHECK(result.output[0] == "at 4.13s");  // 2.75 s + t_acc of 1.375 s, and the next cycle's begin
}

TEST_CASE("what the program gives a global is seen by a TASK in motion order") {
  const RunResult result = run_tasks(
      "VAR phase = 1\nVAR name = \"one\"\nVAR p: VEC = VEC(1mm, 1mm, 1mm)\n"
      "TASK watch\nVAR last = 0\nLOOP\n"
      "IF phase <> last THEN\nPRINT name, \" \", p.y, \" \", CLOCK < 3s\nlast = phase\nENDIF\n"
      "WAIT 0.01s\nENDLOOP\nENDTASK\n"
      "START watch\nMOVE(40, 0, 0)\nSTOP\nname = \"two\"\np.y = 7mm\nphase = 2\nMOVE(0, 0, 0)\n");
  REQUIRE(result.output.size() == 2);
  CHECK(result.output[0] == "one 1mm TRUE");
  CHECK(result.output[1] == "two 7mm FALSE");
}

TEST_CASE("what a TASK gives a global is read by the program at its decision point") {
  // Counted once a cycle from cycle 0 on: at t s about 100 t.
  const RunResult result = run_tasks(
      "VAR count = 0\nTASK counter\nLOOP\ncount = count + 1\nWAIT 0.01s\nENDLOOP\nENDTASK\n"
      "START counter\nMOVE(40, 0, 0)\nVAR seen = count\nPRINT seen >= 274 AND seen <= 276\n"
      "MOVE(80, 0, 0)\nSTOP\nPRINT count >= 820 AND count <= 830\n");
  CHECK(result.output == std::vector<std::string>{"TRUE", "TRUE"});
  CHECK(result.starved == 0);
}

TEST_CASE("a WAIT of the program can wait for what a TASK changes") {
  const RunResult result = run_tasks(
      "VAR ready = FALSE\nTASK prepare\nlift = ON\nWAIT lift_up\nready = TRUE\nENDTASK\n"
      "START prepare\nWAIT ready\nPRINT lift_up, CLOCK < 1s\n");
  CHECK(result.output == std::vector<std::string>{"TRUETRUE"});
}

TEST_CASE("a WAIT of a TASK can wait for what the program changes") {
  const RunResult result = run_tasks(
      "VAR ready = FALSE\nTASK follow\nWAIT ready TIMEOUT 100s\nPRINT \"followed \", CLOCK > 5.4s\n"
      "ENDTASK\nSTART follow\nMOVE(40, 0, 0)\nSTOP\nready = TRUE\nMOVE(0, 0, 0)\n");
  CHECK(result.output == std::vector<std::string>{"followed TRUE"});
}

TEST_CASE("TASKs run in the order of their START, each cycle") {
  const RunResult result = run_tasks(
      "VAR mark = 0\n"
      "TASK a\nmark = mark * 10 + 1\nENDTASK\nTASK b\nmark = mark * 10 + 2\nENDTASK\n"
      "START b\nSTART a\nWAIT 0.1s\nPRINT mark\n");
  CHECK(result.output == std::vector<std::string>{"21"});
}

TEST_CASE("a TASK that has ended may be started again, one that runs may not") {
  const RunResult again = run_tasks(
      "VAR n = 0\nTASK once\nn = n + 1\nWAIT 0.5s\nENDTASK\n"
      "START once\nWAIT 1s\nSTART once\nWAIT 1s\nPRINT n\n");
  CHECK(again.output == std::vector<std::string>{"2"});
  const RunResult twice =
      run_tasks("TASK once\nWAIT 0.5s\nENDTASK\nSTART once\nSTART once\nWAIT 2s\n");
  REQUIRE(twice.error);
  CHECK(twice.error->code == "E343");
  CHECK(twice.error->place.line == 5);
  CHECK(twice.exit_code == ExitCode::Fault);
}

TEST_CASE("a START of a running TASK is an error also where nothing comes behind it") {
  const std::string task =
      "SIGNAL torch = DOUT[1] SAFE OFF\nTASK long\nWAIT 100s\nENDTASK\ntorch = ON\nSTART long\n";
  for (const std::string way : {"", "MOVE(20, 0, 0)\n"}) {
    CAPTURE(way);
    const RunResult result = run_tasks(task + way + "START long");
    REQUIRE(result.error);
    CHECK(result.error->code == "E343");
    CHECK(result.final_joints[0] == (way.empty() ? 0 : 20));
    REQUIRE(result.signals.size() == 2);
    CHECK_FALSE(result.signals[1].value);  // its SAFE value
  }
}

TEST_CASE("what stands behind a START of a running TASK is not commanded") {
  const RunResult result = run_tasks(
      "TASK long\nWAIT 100s\nENDTASK\nSTART long\n"
      "TRY\nMOVE(40, 0, 0)\nPRINT \"before\"\nSTART long\nPRINT \"behind\"\n"
      "MOVE(100, 0, 0)\nRESCUE why\nPRINT why, HERE.x\nENDTRY\n");
  CHECK(result.output == std::vector<std::string>{"before", "E343: TASK long runs already40mm"});
  CHECK(result.final_joints[0] == 40);
}

TEST_CASE("a START of a TASK that has ended keeps the blend") {
  const std::string task = "TASK once\nWAIT 0.1s\nENDTASK\nSTART once\n";
  const std::string way = "MOVE(40, 40, 0)\nMOVE(140, 40, 0)\n";
  const RunResult with = run_tasks(task + way + "START once\nMOVE(90, 126, 0)\n");
  CHECK(with.exit_code == ExitCode::Done);
  CHECK(with.measured == run_tasks(way + "MOVE(90, 126, 0)\n").measured);
}

TEST_CASE("an error of a TASK is one of the program, and a TRY can catch it") {
  const std::string task =
      "SIGNAL torch = DOUT[1] SAFE OFF\nTASK guard\nWAIT DIN[1]\nRAISE \"open\"\nENDTASK\n"
      "START guard\ntorch = ON\n";
  const RunResult caught = run_tasks(
      task + "TRY\nMOVE(100, 0, 0)\nMOVE(200, 0, 0)\nWAIT DIN[2]\nRESCUE why\nPRINT why\nENDTRY\n",
      "at 3s DIN[1] = ON");
  CHECK(caught.exit_code == ExitCode::Done);
  CHECK(caught.output == std::vector<std::string>{"open"});
  // What was commanded before is finished.
  CHECK(caught.final_joints[0] == 200);

  const RunResult fatal = run_tasks(task + "MOVE(100, 0, 0)\nWAIT DIN[2]\n", "at 1s DIN[1] = ON");
  REQUIRE(fatal.error);
  CHECK(fatal.error->message == "open");
  CHECK(fatal.error->place.line == 4);
  CHECK(fatal.final_joints[0] == 100);
  CHECK(fatal.measured < 10);
  REQUIRE(fatal.signals.size() == 2);
  CHECK_FALSE(fatal.signals[1].value);
}

TEST_CASE("an error of a TASK tells where it was started") {
  const RunResult result = run_tasks(
      "PROC check(n: INT)\nASSERT n < 2\nENDPROC\n"
      "TASK count\ncheck(1)\ncheck(2)\nENDTASK\n"
      "MOVE(20, 0, 0)\nSTART count\nMOVE(40, 0, 0)\n");
  REQUIRE(result.error);
  CHECK(result.error->place.line == 2);
  CHECK(result.error->calls ==
        std::vector<lang::CallSite>{{"check", 6}, {"count", 9, rob::lang::CallSite::By::Start}});
}

TEST_CASE("an error of a TASK ends a WAIT, and a motion under guard leaves nothing behind") {
  const RunResult result = run_tasks(
      "TASK guard\nWAIT 1s\nRAISE \"late\"\nENDTASK\n"
      "START guard\nTRY\nMOVE(100, 0, 0) UNTIL DIN[1]\nRESCUE why\nPRINT why\nENDTRY\n"
      "MOVE(50, 0, 0) UNTIL DIN[2]\nPRINT HIT\n",
      "at 2s DIN[1] = ON\nat 9s DIN[2] = ON");
  CHECK(result.exit_code == ExitCode::Done);
  CHECK(result.output.size() == 2);
}

TEST_CASE("a TASK without WAIT or reading is stopped by its budget, not for ever") {
  const RunResult result = run_tasks(
      "VAR n = 0\nTASK busy\nLOOP\nn = n + 1\nENDLOOP\nENDTASK\n"
      "START busy\nWAIT 1s\nPRINT n > 50000 AND n < 200000\n");
  CHECK(result.exit_code == ExitCode::Done);
  CHECK(result.output == std::vector<std::string>{"TRUE"});
}

TEST_CASE("a run with TASKs has the same bits every time, and can be foretold and tested") {
  const std::string text =
      "VAR n = 0.0\nTASK draw\nLOOP\nn = RANDOM()\nWAIT 0.1s\nENDLOOP\nENDTASK\n"
      "TEST \"draws\"\nSTART draw\nWAIT 1s\nEXPECT n > 0\nENDTEST\n"
      "START draw\nMOVE(40, 0, 0)\nPRINT n\nMOVE(80, 0, 0)\nSTOP\nPRINT n\n";
  const RunResult one = run_tasks(text);
  CHECK(one.output == run_tasks(text).output);
  CHECK(one.output[0] != one.output[1]);
  const auto program = runtime::compile_program("test.rob", text, gantry());
  CHECK(runtime::foretell(program, gantry()).exit_code == ExitCode::Done);
  const auto tests = runtime::run_tests(program, gantry(), 1);
  REQUIRE(tests.size() == 1);
  CHECK(tests[0].failures.empty());
  CHECK_FALSE(tests[0].error);
}

TEST_CASE("arrays and records are shared as all else, and a TASK has memory of its own") {
  const RunResult result = run_tasks(R"(RECORD part
  name: STRING
  at: ARRAY[2] OF INT
ENDRECORD
VAR parts = [part(name: "a"), part(name: "b")]
VAR counts: ARRAY[3] OF INT
PROC note(i: INT, list: ARRAY[3] OF INT)
  VAR own = list
  own[i] = own[i] + 10
  parts[2].at = [own[1], own[i]]
ENDPROC
TASK fill
  VAR mine = [5, 6, 7]
  PRINT parts[2].at
  FOR i = 1 TO 3 DO
    counts[i] = counts[i] + mine[i]
  ENDFOR
  note(2, counts)
  parts[1].name = parts[1].name + "!"
ENDTASK
PROC set(i: INT)
  counts[i] = 1
  parts[i].at[1] = i
ENDPROC
counts[2] = 100
parts[1].name = "z"
START fill
WAIT 0.1s
PRINT counts
PRINT parts[1].name, parts[2].at
set(2)
START fill
WAIT 0.1s
PRINT counts
PRINT parts[1].name, parts[2].at
)");
  // First 0 + 5, 100 + 6, 0 + 7; then 5 + 5, 1 + 6, 7 + 7. note() adds 10 to the second.
  CHECK(result.output == std::vector<std::string>{"[0, 0]", "[5, 106, 7]", "z![5, 116]", "[2, 116]",
                                                  "[10, 7, 14]", "z!![10, 17]"});
}

TEST_CASE("a WAIT of the program can wait for an element that a TASK changes") {
  const RunResult result = run_tasks(
      "VAR done: ARRAY[2] OF BOOL\nTASK work\nWAIT 0.5s\ndone[2] = TRUE\nENDTASK\n"
      "START work\nWAIT done[2]\nPRINT CLOCK >= 0.5s AND CLOCK < 0.6s\n");
  CHECK(result.output == std::vector<std::string>{"TRUE"});
}

TEST_CASE("globals that registers have no room for are shared, too") {
  std::string text;
  for (int i = 1; i <= 200; ++i) {
    text += "VAR v" + std::to_string(i) + " = 0.5\nVAR t" + std::to_string(i) + " = \"\"\n";
  }
  text +=
      "TASK work\nv1 = v1 + 1\nv200 = v200 + 1\nt200 = t200 + \"b\"\nENDTASK\n"
      "PROC set()\nv200 = 4.5\nt200 = \"a\"\nENDPROC\n"
      "set()\nv1 = 2.5\nSTART work\nWAIT 0.1s\nPRINT v1, \" \", v200, \" \", v199, t200\n";
  CHECK(run_tasks(text).output == std::vector<std::string>{"3.5 5.5 0.5ab"});
}

TEST_CASE("a TASK is outside of what WITH says") {
  const RunResult result = run_tasks(
      "TOOL pen = POSE(30mm, 0mm, 0mm)\nTASK where\nPRINT HERE.x\nENDTASK\n"
      "MOVE(40, 0, 0)\nSTOP\nWITH pen DO\nSTART where\nWAIT 0.1s\nPRINT HERE.x\nENDWITH\n");
  CHECK(result.output == std::vector<std::string>{"40mm", "70mm"});
}

TEST_CASE("calls of a TASK that need more memory than it has are an error") {
  const RunResult result = run_tasks(
      "PROC deep(n: INT)\nVAR block: ARRAY[5000] OF INT\nblock[1] = n\ndeep(n + 1)\nENDPROC\n"
      "TASK work\ndeep(1)\nENDTASK\nSTART work\nWAIT 1s\n");
  REQUIRE(result.error);
  CHECK(result.error->code == "E321");
  CHECK(result.error->message.find("16384 numbers and 256 texts") != std::string::npos);
}

TEST_CASE("a TASK sees the LISTs of the program as they are in motion order") {
  const RunResult result = run_tasks(
      "RECORD bolt\nname: STRING\nsize: LENGTH\nENDRECORD\n"
      "VAR l: LIST OF bolt = [bolt(name: \"a\", size: 1mm)]\nVAR n: LIST OF INT\n"
      "TASK watch\nVAR last = 0\nLOOP\n"
      "IF LEN(l) + LEN(n) <> last THEN\n"
      "PRINT l[LEN(l)].name, l[1].size, n, CLOCK < 3s\nlast = LEN(l) + LEN(n)\nENDIF\n"
      "WAIT 0.01s\nENDLOOP\nENDTASK\n"
      "START watch\nMOVE(40, 0, 0)\nSTOP\n"
      "APPEND(REF l, bolt(name: \"b\", size: 2mm))\nl[1].size = 7mm\nMOVE(0, 0, 0)\nSTOP\n"
      "FOR i = 1 TO 300 DO\nAPPEND(REF n, i)\nENDFOR\nn = [SUM(n)]\nSORT(REF n)\nWAIT 0.1s\n"
      "REMOVE(REF l, 1)\nCLEAR(REF n)\nWAIT 0.1s\n");
  CHECK(result.exit_code == ExitCode::Done);
  REQUIRE(result.output.size() == 4);
  CHECK(result.output[0] == "a1mm[]TRUE");
  CHECK(result.output[1] == "b7mm[]FALSE");
  CHECK(result.output[2] == "b7mm[45150]FALSE");
  CHECK(result.output[3] == "b2mm[]FALSE");
}
