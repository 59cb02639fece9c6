// What `rob check` assumes of inputs, and how far it follows a loop.
#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "motion/robots/robot_library.h"
#include "runtime/run/foretell.h"

using rob::runtime::RunResult;

namespace {

using Texts = std::vector<std::string>;

RunResult foretold(const std::string& text, const std::string& script_text = "") {
  const auto robot = rob::motion::embedded_robot("gantry");
  const auto program = rob::runtime::compile_program("t.rob", text, robot);
  REQUIRE(program.runnable());
  const auto script = rob::runtime::parse_signal_script("t.sig", script_text, robot,
                                                        program.compilation.chunk->named_signals);
  REQUIRE_FALSE(script.diagnostics.has_errors());
  return rob::runtime::foretell(program, robot, {.seed = 0, .script = &script});
}

/// "3 N631 assumed: …"
Texts findings(const RunResult& result) {
  Texts texts;
  for (const auto& found : result.findings) {
    texts.push_back(std::to_string(found.place.line) + " " + found.code + " " + found.message);
  }
  return texts;
}

}  // namespace

TEST_CASE("a WAIT for an input that nobody drives is taken as met after 0 s, once a place") {
  const RunResult result = foretold(
      "SIGNAL part_here = DIN[1]\nFOR i = 1 TO 3 DO\nWAIT part_here AND NOT DIN[2] TIMEOUT 1s\n"
      "ENDFOR\nWAIT AIN[1] > 2V\nWAIT NOT part_here\nPRINT \"through\"");
  CHECK(findings(result) == Texts{"3 N631 assumed: this WAIT for part_here is met after 0 s",
                                  "5 N631 assumed: this WAIT for AIN[1] is met after 0 s",
                                  "6 N631 assumed: this WAIT for part_here is met after 0 s"});
  CHECK(result.output == Texts{"through"});
  CHECK(result.planned <= 0.2);  // some cycles of looking
}

TEST_CASE("an IF finds an input that nobody drives OFF") {
  const RunResult result =
      foretold("IF DIN[3] THEN\nPRINT 1\nELSE\nPRINT 2\nENDIF\nVAR level = AIN[2]\nPRINT level");
  CHECK(findings(result) ==
        Texts{"1 N631 assumed: DIN[3] is OFF here", "6 N631 assumed: AIN[2] is at 0 V here"});
  CHECK(result.output == Texts{"2", "0V"});
}

TEST_CASE("what the simulated robot or the script drives is not assumed") {
  const RunResult result = foretold(
      "SIGNAL part_here = DIN[1]\nlift = ON\nWAIT lift_up\nWAIT part_here\nPRINT part_here",
      "at 2s part_here = ON");
  CHECK(findings(result).empty());
  CHECK(result.output == Texts{"TRUE"});
  CHECK(result.planned >= 2);
}

TEST_CASE(
    "a loop without a motion is followed for ten thousand turns, and what it did is foretold") {
  const RunResult endless = foretold("PRINT 0\nLOOP\nPRINT 1\nENDLOOP");
  CHECK(findings(endless) ==
        Texts{"3 N632 the loop goes on; it was foretold for 10000 turns without a motion"});
  CHECK(endless.output_count == 10'001);
  CHECK(endless.status == "done");
  const RunResult nested = foretold(
      "VAR n = 0\nVAR i = 0\nVAR j = 0\nWHILE i < 30 DO\ni = i + 1\nj = 0\nWHILE j < 9000 DO\n"
      "j = j + 1\nn = n + 1\nENDWHILE\nENDWHILE\nPRINT n");
  CHECK(findings(nested).empty());
  CHECK(nested.output == Texts{"270000"});
}

TEST_CASE("a FOR is followed to its end, and so is every loop that moves, an hour long at most") {
  const RunResult counted =
      foretold("VAR n = 0\nFOR i = 1 TO 20000 DO\nn = n + i\nENDFOR\nPRINT n");
  CHECK(findings(counted).empty());
  CHECK(counted.output == Texts{"200010000"});
  // By S1 each of the 1200 motions takes 2·t_acc = 2.75 s, and the stop as much.
  const RunResult moving = foretold(
      "VAR n = 0\nWHILE n < 600 DO\nMOVE(1, 0, 0)\nn = n + 1\nMOVE(0, 0, 0)\nENDWHILE\nPRINT n");
  CHECK(findings(moving).empty());
  CHECK(moving.planned == doctest::Approx(1201 * 2.75));
  const RunResult endless = foretold("LOOP\nMOVE(1, 0, 0)\nMOVE(0, 0, 0)\nENDLOOP");
  REQUIRE(endless.findings.size() == 1);
  CHECK(endless.findings[0].code == "N603");
  CHECK(endless.planned == doctest::Approx(3600).epsilon(0.001));
}

TEST_CASE("an OVERRIDE before a motion with a profile holds from its beginning") {
  const std::string law = "LAW LOOKAHEAD\n";
  const std::string move = "MOVE(100, 0, 0) AT 20mm/s PROFILE TRAPEZOIDAL";
  CHECK(foretold(law + "OVERRIDE 50%\n" + move).planned ==
        doctest::Approx(2 * foretold(law + move).planned).epsilon(1e-9));
  CHECK(foretold(law + "MOVE(50, 0, 0) FINE\nOVERRIDE 50%\n" + move).planned >
        2 * foretold(law + "MOVE(50, 0, 0) FINE\nMOVE(50, 50, 0) PROFILE TRAPEZOIDAL").planned -
            foretold(law + "MOVE(50, 0, 0) FINE").planned - 0.02);
}

TEST_CASE("of many findings the first hundred are told, and the number of the others") {
  std::string text;
  for (int i = 1; i <= 300; ++i) text += "MOVE(" + std::to_string(i % 2) + ", 0, 0) OVER 1s\n";
  const RunResult result = foretold("FOR k = 1 TO 2 DO\n" + text + "ENDFOR");
  CHECK(result.findings.size() == 100);
  CHECK(result.findings_left_out == 200);
  CHECK(findings(result)[99].starts_with("101 W602"));
}

TEST_CASE("many findings of one kind do not hide those of another") {
  std::string text;
  for (int i = 1; i <= 300; ++i) text += "MOVE(" + std::to_string(i % 2) + ", 0, 0) OVER 1s\n";
  const RunResult result = foretold(text + "WAIT lift_up");
  REQUIRE(result.findings.size() == 101);
  CHECK(result.findings_left_out == 200);
  CHECK(findings(result)[100].starts_with("301 W633"));
}

TEST_CASE("a WAIT that looks again and again is no loop") {
  const RunResult result =
      foretold("SIGNAL late = DIN[1]\nWAIT late\nPRINT \"after all\"", "at 30s late = ON");
  CHECK(findings(result).empty());
  CHECK(result.output == Texts{"after all"});
}

TEST_CASE(
    "a WAIT for what never comes is told at once, where nothing is left that could bring it") {
  const Texts for_ever{
      "3 W633 the program waits here for ever: it stands, and nothing is left that"
      " could change an input"};
  const RunResult stuck = foretold("MOVE(40, 0, 0)\nPRINT 1\n  WAIT lift_up\nPRINT 2");
  CHECK(findings(stuck) == for_ever);
  CHECK(stuck.findings[0].place.column == 3);
  CHECK(stuck.output == Texts{"1"});
  CHECK(stuck.planned < 10);  // 5.5 s to rest, and what the lift and the gripper could take
  CHECK(stuck.status == "done");
  CHECK(findings(foretold("lift = ON\nWAIT lift_up\nWAIT lift_down\n"))[0].starts_with("3 W633"));
}

TEST_CASE("a WAIT that time can end is followed") {
  const auto through = [](const std::string& text, const std::string& script = "") {
    const RunResult result = foretold(text, script);
    return findings(result).empty() && result.output == Texts{"through"};
  };
  CHECK(through("WAIT lift_up OR CLOCK > 40s\nPRINT \"through\""));
  CHECK(through("WHEN CLOCK > 40s : lift = ON\nWAIT lift_up\nPRINT \"through\""));
  CHECK(through("WAIT lift_up TIMEOUT 40s ELSE PRINT \"through\""));
  CHECK(through("PULSE lift 40s\nWAIT lift_up\nWAIT lift_down\nPRINT \"through\""));
  CHECK(through("TASK t\nWAIT 40s\nlift = ON\nENDTASK\nSTART t\nWAIT lift_up\nPRINT \"through\""));
  CHECK(through("WAIT lift_up OR RANDOM() > 0.999\nPRINT \"through\""));
  CHECK(through("WAIT lift_up\nPRINT \"through\"", "at 40s lift_up = ON"));
  CHECK(through("WHEN lift_up : gripper = ON\nlift = ON\nWAIT gripper_closed\nPRINT \"through\""));
}

TEST_CASE("an AT above 100% is told once: by the compiler if it is constant, else by the planner") {
  CHECK(findings(foretold("MOVE(200, 0, 0) AT 150%")) ==
        Texts{"1 W503 150% is more than the robot can; it moves at 100%"});
  CHECK(findings(foretold("VAR share = 150%\nMOVE(200, 0, 0) AT share")) ==
        Texts{"2 W601 AT asks for more than the axes can do"});
}

TEST_CASE(
    "a default beyond a maximum is told once, at its own line, and the motions are foretold") {
  const RunResult result = foretold(
      "DEFAULT AT 5000mm/s\n"
      "MOVE(200, 0, 0)\nMOVE(100, 0, 0)\nMOVE(150, 0, 0)\n"
      "WITH AT 4000mm/s DO\n  MOVE(40, 0, 0)\n  MOVE(60, 0, 0) AT 5mm/s FINE\nENDWITH");
  CHECK(findings(result) == Texts{"1 W601 AT asks for more than the axes can do, first in line 2",
                                  "5 W601 AT asks for more than the axes can do, first in line 6"});
}
