#include "runtime/files/signal_script.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "motion/robots/robot_library.h"
#include "runtime/run/run.h"
#include "tests/support/no_allocation.h"
#include "tests/support/stepped_run.h"

using rob::runtime::RunResult;
using rob::runtime::SignalScript;

// A control cycle of the gantry takes 10 ms, a short motion or a stop 2.75 s, its lift 0.5 s.

namespace {

using Texts = std::vector<std::string>;

SignalScript script_for(const std::string& text, const std::string& program) {
  const auto robot = rob::motion::embedded_robot("gantry");
  const auto loaded = rob::runtime::compile_program("test.rob", program, robot);
  REQUIRE(loaded.runnable());
  return rob::runtime::parse_signal_script("test.sig", text, robot,
                                           loaded.compilation.chunk->named_signals,
                                           loaded.compilation.chunk->devices);
}

RunResult run(const std::string& program, const std::string& text) {
  const auto robot = rob::motion::embedded_robot("gantry");
  const auto loaded = rob::runtime::compile_program("test.rob", program, robot);
  REQUIRE(loaded.runnable());
  const SignalScript script = script_for(text, program);
  REQUIRE_FALSE(script.diagnostics.has_errors());
  rob::runtime::RunOptions options;
  options.fast = true;
  options.script = &script;
  return rob::runtime::run(loaded, robot, options, {});
}

std::string script_error(const std::string& text) {
  const SignalScript script = script_for(
      text, "SIGNAL part_here = DIN[1]\nSIGNAL wire: SPEED = AIN[1] SCALE 0mm/s TO 300mm/s");
  REQUIRE(script.diagnostics.has_errors());
  const rob::lang::Diagnostic& found = script.diagnostics.all().front();
  return std::to_string(found.place.line) + ":" + std::to_string(found.place.column) + " " +
         found.code + " " + found.message;
}

}  // namespace

TEST_CASE("an input takes its value at the time that the script says") {
  const RunResult result = run("SIGNAL part_here = DIN[1]\nPRINT part_here\nWAIT part_here",
                               "// a part comes\nat 1.5s part_here = ON\n");
  CHECK(result.output == Texts{"FALSE"});
  // Latched at 1.50 s, seen in the same cycle; what follows begins with the next one.
  CHECK(result.measured >= 1.5);
  CHECK(result.measured <= 1.5 + 0.021);
}

TEST_CASE("what holds at 0 s is known to the program's first look") {
  const RunResult result =
      run("PRINT DIN[1], \" \", AIN[2]", "at 0s DIN[1] = ON\nat 0s AIN[2] = 2.5V");
  CHECK(result.output == Texts{"TRUE 2.5V"});
}

TEST_CASE("a when answers what the program does, so much later") {
  const RunResult result = run(
      "SIGNAL vacuum = DOUT[1]\nSIGNAL vac_ok = DIN[2]\n"
      "vacuum = ON\nWAIT vac_ok\nvacuum = OFF\nWAIT NOT vac_ok\nPRINT \"dropped\"",
      "when vacuum == ON after 0.3s : vac_ok = ON\nwhen vacuum == OFF after 0.1s : vac_ok = OFF");
  CHECK(result.output == Texts{"dropped"});
  REQUIRE(result.lines.size() >= 2);
  CHECK(result.lines[0].measured == doctest::Approx(0.3).epsilon(0.1));
  CHECK(result.lines[1].measured == doctest::Approx(0.1).epsilon(0.3));
}

TEST_CASE("a when acts each time its condition becomes true") {
  const RunResult result =
      run("SIGNAL wanted = DOUT[1]\nSIGNAL here = DIN[1]\nVAR n = 0\n"
          "FOR i = 1 TO 3 DO\nwanted = ON\nWAIT here\nn = n + 1\nwanted = OFF\nWAIT NOT "
          "here\nENDFOR\nPRINT n",
          "when wanted == ON after 20ms : here = ON\nwhen wanted == OFF : here = OFF");
  CHECK(result.output == Texts{"3"});
}

TEST_CASE("an analog input is set and looked at in the program's quantity") {
  const RunResult result =
      run("SIGNAL wire: SPEED = AIN[1] SCALE 0mm/s TO 300mm/s\nSIGNAL feed: SPEED = AOUT[1] SCALE "
          "0mm/s TO 300mm/s\n"
          "feed = 200mm/s\nWAIT wire > 100mm/s\nPRINT wire",
          "when feed > 150mm/s after 1s : wire = 150mm/s");
  CHECK(result.output == Texts{"150mm/s"});
}

TEST_CASE("the robot's own inputs can be driven too") {
  const RunResult result =
      run("lift = ON\nWAIT lift_up TIMEOUT 2s ELSE PRINT \"stuck\"", "at 0s lift_up = OFF");
  CHECK(result.output == Texts{"stuck"});
}

TEST_CASE("mistakes of a script are all told, with their place") {
  CHECK(script_error("part_here = ON") == "1:1 E541 at or when expected, not 'part_here'");
  CHECK(script_error("\nat 5 part_here = ON") ==
        "2:4 E541 a time such as 2.5s after at expected, not '5'");
  CHECK(script_error("at 5mm part_here = ON") ==
        "1:4 E541 a time such as 2.5s after at expected, not '5mm'");
  CHECK(script_error("at 5s part_her = ON") ==
        "1:7 E542 neither the program nor the robot has a signal part_her");
  CHECK(script_error("at 5s DIN[17] = ON") ==
        "1:7 E542 neither the program nor the robot has a signal DIN[17]");
  CHECK(script_error("at 5s lift = ON") ==
        "1:7 E542 lift is an output: the program sets it, no script can");
  CHECK(script_error("at 5s part_here = 3") == "1:19 E543 part_here is ON or OFF, not '3'");
  CHECK(script_error("at 5s wire = 3V") == "1:14 E543 wire is a speed, not '3V'");
  CHECK(script_error("at 5s wire = 301mm/s") ==
        "1:14 E543 wire carries 0mm/s to 300mm/s; 301mm/s is beyond that");
  CHECK(script_error("when part_here > ON : part_here = ON") ==
        "1:16 E543 part_here is ON or OFF; compare it with == or <>");
  CHECK(script_error("when part_here == ON part_here = ON") ==
        "1:22 E541 ':' expected, not 'part_here'");
  CHECK(script_error("at 5s part_here = ON twice") ==
        "1:22 E541 the end of the line expected, not 'twice'");
  CHECK(script_error("at 5s") == "1:6 E541 the name of a signal expected, not the end of the line");
  CHECK(script_error("at 5s ANSWER = 7") == "1:16 E541 a text such as \"7\" expected, not '7'");
  CHECK(script_error("at 5s HOLD = 3") == "1:14 E543 HOLD is ON, not '3'");
  CHECK(script_error("at 5s HOLD = OFF") == "1:14 E543 HOLD is ON, not 'OFF'");
  CHECK(script_error("at 5s STOP = 7s") == "1:14 E543 STOP is ON, not '7s'");
  CHECK(script_error("at 5s STOP") == "1:11 E541 '=' expected, not the end of the line");
  CHECK(script_error("at 5s GO = 1") == "1:12 E543 GO is ON or OFF, not '1'");
  constexpr const char* kShares = "1:18 E543 OVERRIDE is a share above 0% and at most 200%, not ";
  for (const std::string share : {"'fast'", "'0.5'", "'50'", "'0%'", "'201%'", "'3mm'", "'ON'"}) {
    CAPTURE(share);
    CHECK(script_error("at 5s OVERRIDE = " + share.substr(1, share.size() - 2)) == kShares + share);
  }
  CHECK(script_error("when HOLD == ON : part_here = ON") ==
        "1:6 E542 neither the program nor the robot has a signal HOLD");
  CHECK(script_error("at 2000000s part_here = ON") ==
        "1:4 E543 2000000s is beyond the 1000000s of a run");
  CHECK(script_for("at 1s x = ON\nat 2s y = ON", "STOP").diagnostics.error_count() == 2);
}

TEST_CASE("a wrong value for the operator tells the way out") {
  const auto help = [](const std::string& text) {
    return script_for(text, "STOP").diagnostics.all().front().help;
  };
  CHECK(help("at 5s HOLD = OFF") == "write HOLD = ON; GO = ON lets the robot go on");
  CHECK(help("at 5s STOP = OFF") == "write STOP = ON; it ends the run");
  CHECK(help("at 5s OVERRIDE = 0%") == "for example OVERRIDE = 30%");
}

TEST_CASE("the operator's names go before a signal of the same name") {
  const SignalScript script =
      script_for("at 1s hold = ON\nwhen hold == ON : DIN[2] = ON", "SIGNAL hold = DIN[3]");
  REQUIRE(script.rules.size() == 2);
  CHECK(script.rules[0].setting.place.kind == rob::runtime::WorldSignal::Kind::Hold);
  CHECK(script.rules[1].watched.kind == rob::runtime::WorldSignal::Kind::Input);
  CHECK(script.rules[1].watched.channel == 2);
}

TEST_CASE("a script has at most a thousand lines") {
  std::string text;
  for (int i = 0; i < 1001; ++i) text += "at 1s DIN[1] = ON\n";
  const SignalScript script = script_for(text, "STOP");
  REQUIRE(script.diagnostics.error_count() == 1);
  CHECK(script.diagnostics.all()[0].place.line == 1001);
}

TEST_CASE("GO and ANSWER wait for the one who asks") {
  rob::runtime::OperatorPanel panel;
  const SignalScript script =
      script_for("at 2s GO = ON\nat 1s ANSWER = \"7\"\nat 3s GO = OFF", "STOP");
  REQUIRE_FALSE(script.diagnostics.has_errors());
  panel.prepare(script.answers, {.times = 1}, {.times = 1});
  rob::runtime::SimulatedInputs inputs(script.rules, panel);
  rob::runtime::WorldImage image;
  CHECK(panel.take_answer() == nullptr);
  inputs.latch(1, image);
  CHECK_FALSE(panel.take_go());
  CHECK(panel.go_may_come());
  CHECK_FALSE(panel.answer_may_come());
  inputs.latch(4, image);
  CHECK_FALSE(panel.go_may_come());
  CHECK(panel.take_go());
  CHECK_FALSE(panel.take_go());
  const std::string* const answer = panel.take_answer();
  REQUIRE(answer != nullptr);
  CHECK(*answer == "7");
}

TEST_CASE("latching simulated inputs takes no memory") {
  rob::runtime::OperatorPanel panel;
  const SignalScript script = script_for(
      "at 0.1s DIN[1] = ON\nwhen DIN[1] == ON after 0.1s : AIN[1] = 2V\nat 0.2s GO = ON", "STOP");
  rob::runtime::SimulatedInputs inputs(script.rules, panel);
  rob::runtime::WorldImage image;
  int taken = -1;
  const rob::test::NoAllocation guard;
  for (int cycle = 0; cycle < 100; ++cycle) {
    image = {};
    inputs.schedule({{rob::runtime::WorldSignal::Kind::Input, 3}, 1, 0}, 0.5);
    inputs.latch(0.01 * cycle, image);
  }
  taken = guard.count();
  CHECK(taken == 0);
  CHECK(image.inputs == 0b1001);
  CHECK(image.analog_inputs[0] == 2);
}

TEST_CASE("a device sends a line when a condition comes true, each time") {
  // The script sees the output in cycle 1, 0.01 s.
  const RunResult result =
      run("DEVICE scale = \"tcp://a:1\"\nVAR line: STRING\n"
          "lift = ON\nRECEIVE scale INTO line TIMEOUT 2s\n"
          "PRINT line, CLOCK >= 0.31s AND CLOCK < 0.34s\n"
          "lift = OFF\nWAIT 1s\nlift = ON\nRECEIVE scale INTO line TIMEOUT 2s\nPRINT line\n"
          "RECEIVE scale INTO line TIMEOUT 2s ELSE line = \"none\"\nPRINT line\n",
          "when lift == ON after 0.3s : scale = \"7 g\"\n");
  CHECK(result.output == Texts{"7 gTRUE", "7 g", "none"});
}

TEST_CASE("a script names devices only where it sets, and gives them texts") {
  const auto error = [](const std::string& text) {
    const SignalScript script = script_for(text, "DEVICE scale = \"tcp://a:1\"");
    REQUIRE(script.diagnostics.has_errors());
    return script.diagnostics.all().front().message;
  };
  CHECK(error("when lift == ON : scale = 7").find("a text such as") == 0);
  CHECK(error("when scale == \"x\" : DIN[1] = ON").find("has a signal scale") != std::string::npos);
}

TEST_CASE("a TASK has a device of its own, beside the motion") {
  // The motion takes 5.5 s.
  const RunResult result =
      run("DEVICE scale = \"tcp://a:1\"\nVAR last = \"-\"\n"
          "TASK listen\nLOOP\nSEND scale: \"W\"\n"
          "RECEIVE scale INTO last TIMEOUT 3s ELSE last = \"late\"\nENDLOOP\nENDTASK\n"
          "START listen\nMOVE(20, 0, 0)\nPRINT CLOCK > 2s\nSTOP\nPRINT last\nWAIT 3s\n"
          "PRINT last\nWAIT 5s\nPRINT last\n",
          "at 4s scale = \"a\"\nat 8.25s scale = \"b\"\n");
  // Nothing for 3 s from the start and from 8.25 s on; PRINTs at 5.5 s, 8.5 s and 13.5 s.
  CHECK(result.output == Texts{"TRUE", "a", "b", "late"});
}
