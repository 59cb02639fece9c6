// OBSTACLE, the SHAPE of a TOOL and ALLOW, as `rob check` and a run see them.
#include <doctest/doctest.h>

#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "motion/robots/robot_library.h"
#include "runtime/run/foretell.h"
#include "runtime/run/run.h"
#include "tests/support/scratch_folder.h"

using namespace rob::motion;
using rob::runtime::Contact;
using rob::runtime::ExitCode;
using rob::runtime::LoadedProgram;
using rob::runtime::RunResult;

namespace {

// A round tool of 10 mm, 80 mm long, and a ball of 20 mm in its way.
const std::string kPen =
    "TOOL pen = POSE(0mm, 0mm, 80mm) SHAPE CAPSULE((0mm, 0mm, 0mm), (0mm, 0mm, 80mm), 5mm)\n";
const std::string kBallInWay = "OBSTACLE ball = SPHERE((100mm, 40mm, 50mm), 10mm)\n";

LoadedProgram compiled_for_gantry(const std::string& text) {
  LoadedProgram program = rob::runtime::compile_program("t.rob", text, embedded_robot("gantry"));
  for (const auto& found : program.compilation.diagnostics.all()) CAPTURE(found.message);
  REQUIRE(program.runnable());
  return program;
}

RunResult foretold_with(const std::string& text) {
  const LoadedProgram program = compiled_for_gantry(text);
  return rob::runtime::foretell(program, program.robot);
}

RunResult run_with(const std::string& text) {
  const LoadedProgram program = compiled_for_gantry(text);
  rob::runtime::RunOptions options;
  options.fast = true;
  return rob::runtime::run(program, program.robot, options, {});
}

std::string code_of(const RunResult& result) { return result.error ? result.error->code : ""; }

}  // namespace

TEST_CASE("a tool with a shape hits an obstacle of the program") {
  // As of the robot's own bodies (contact_watch_test.cpp): the axis of the tool comes within 15.5
  // mm of the ball's centre at x = 84.5 mm, after 3.6 s.
  const RunResult result = foretold_with(kPen + kBallInWay +
                                         "WITH pen DO\nMOVE(40, 40, 0) FINE\nMOVE(140, 40, 0)\n"
                                         "ENDWITH");
  REQUIRE(result.contact.has_value());
  const Contact& contact = *result.contact;
  CHECK(contact.line == 5);
  CHECK(contact.body == "gripper");
  CHECK(contact.other == "ball");
  CHECK(contact.at == doctest::Approx(3.6).epsilon(0.01));
  CHECK(contact.q[0] == doctest::Approx(0.0845).epsilon(0.005));
  CHECK(result.exit_code == ExitCode::ProgramError);
  REQUIRE(result.error.has_value());
  CHECK(result.error->message.starts_with("gripper hits ball 3.6"));
}

TEST_CASE("a tool is looked at while it is in use, and no longer") {
  const std::string there = kPen + kBallInWay + "MOVE(40, 40, 0) FINE\n";
  CHECK(code_of(foretold_with(there + "MOVE(140, 40, 0)")).empty());
  CHECK(code_of(foretold_with(there + "MOVE(140, 40, 0) WITH pen")) == "E580");
  // The next motion has no tool any more.
  CHECK(code_of(foretold_with(there + "WITH pen DO\nMOVE(40, 100, 0) FINE\nENDWITH\n"
                                      "MOVE(40, 40, 0) FINE\nMOVE(140, 40, 0)"))
            .empty());
}

TEST_CASE("ALLOW lets what it names touch, in motion order") {
  const auto allowed = [](const std::string& names, const std::string& behind = "") {
    return code_of(foretold_with(kPen + kBallInWay + "WITH pen DO\nMOVE(40, 40, 0) FINE\nALLOW " +
                                 names + " DO\nMOVE(140, 40, 0) FINE\nENDALLOW\n" + behind +
                                 "ENDWITH"));
  };
  CHECK(allowed("gripper").empty());
  CHECK(allowed("ball").empty());
  CHECK(allowed("part, BALL").empty());
  CHECK(allowed("part") == "E580");
  CHECK(allowed("gripper", "MOVE(40, 40, 0)\n") == "E580");
  // A routine that is called in the block and outside of it.
  const std::string across = "PROC across(x: LENGTH)\nMOVE(x, 40, 0) FINE\nENDPROC\n";
  const std::string called = kPen + kBallInWay + across +
                             "WITH pen DO\nacross(40mm)\nALLOW gripper DO\nacross(140mm)\n"
                             "ENDALLOW\n";
  CHECK(code_of(foretold_with(called + "ENDWITH")).empty());
  CHECK(code_of(foretold_with(called + "across(40mm)\nENDWITH")) == "E580");
}

TEST_CASE("who has touched by permission may part after it, and not press on") {
  const std::string pressed = kPen + kBallInWay +
                              "WITH pen DO\nMOVE(40, 40, 0) FINE\nALLOW gripper DO\n"
                              "MOVE(88, 40, 0) FINE\nENDALLOW\n";
  CHECK(code_of(foretold_with(pressed + "MOVE(40, 40, 0)\nENDWITH")).empty());
  CHECK(code_of(foretold_with(pressed + "MOVE(95, 40, 0)\nENDWITH")) == "E581");
}

TEST_CASE("in a run, too, what nobody has foretold is proved with tool and permission") {
  const std::string way = "WITH pen DO\nMOVE(40, 40, 0) FINE\nMOVE(140, 40, 0)\nENDWITH\nSTOP";
  const RunResult hit = run_with(kPen + kBallInWay + way);
  CHECK(code_of(hit) == "E580");
  CHECK(hit.final_joints.at(0) == doctest::Approx(40));
  const RunResult allowed = run_with(kPen + kBallInWay + "ALLOW ball DO\n" + way + "\nENDALLOW");
  CHECK(code_of(allowed).empty());
  CHECK(allowed.final_joints.at(0) == doctest::Approx(140));
}

TEST_CASE("boxes stand as their pose says, and capsules from end to end") {
  // Turned by 90° the edge of 200 mm lies along y: the pen passes it at x = 40 mm with 35 mm to
  // spare, and not at 76 mm, where the edge is at 80 mm.
  const std::string box =
      "OBSTACLE crate = BOX(POSE(100mm, 100mm, 50mm, 0deg, 0deg, 90deg), 200mm, 40mm, 100mm)\n";
  const std::string post =
      "OBSTACLE post = CAPSULE((80mm, 0mm, 50mm), (80mm, 200mm, 50mm), 0.5mm)\n";
  for (const std::string& obstacle : {box, post}) {
    const std::string along = kPen + obstacle + "WITH pen DO\nMOVE(40, 0, 0) FINE\n";
    CHECK(code_of(foretold_with(along + "MOVE(40, 200, 0)\nENDWITH")).empty());
    CHECK(code_of(foretold_with(along + "MOVE(76, 100, 0)\nENDWITH")) == "E580");
  }
}

TEST_CASE("obstacles without anything that could hit them are a warning") {
  const auto program = rob::runtime::compile_program("t.rob", kBallInWay + "MOVE(40, 40, 0)",
                                                     embedded_robot("gantry"));
  REQUIRE(program.compilation.diagnostics.all().size() == 1);
  CHECK(program.compilation.diagnostics.all().front().code == "W690");
  CHECK(program.runnable());
}

TEST_CASE("a MESH is read beside the program; without it the program is refused") {
  const rob::test::ScratchFolder folder;
  // A pyramid of 100 mm with its tip at the origin, on its side: 80 to 180 mm along x.
  std::ofstream(folder.path() / "tip.obj")
      << "v 0 0 0\nv 0.1 0.05 0.05\nv 0.1 -0.05 0.05\nv 0.1 -0.05 -0.05\nv 0.1 0.05 -0.05\n"
         "f 1 2 3\nf 1 3 4\nf 1 4 5\nf 1 5 2\nf 2 3 4\nf 2 4 5\n";
  const std::string text = kPen +
                           "OBSTACLE tip = MESH(POSE(80mm, 40mm, 40mm), \"tip.obj\")\n"
                           "WITH pen DO\nMOVE(40, 40, 0) FINE\nMOVE(x: ";
  const auto result_at = [&](const std::string& file, const std::string& x) {
    const auto program =
        rob::runtime::compile_program(file, text + x + ")\nENDWITH", embedded_robot("gantry"));
    if (!program.runnable()) return program.compilation.diagnostics.all().front().code;
    return code_of(rob::runtime::foretell(program, program.robot));
  };
  const std::string file = (folder.path() / "t.rob").string();
  CHECK(result_at(file, "74").empty());  // 1 mm before the tip
  CHECK(result_at(file, "75") == "E580");
  CHECK(result_at("elsewhere/t.rob", "74") == "E595");
}

TEST_CASE("the part in the gripper of a simulated cell must not hit the table") {
  // The tubes of the supply are 100 mm long and stand in holes whose bottom is 10 mm above the
  // table. Its row and column have the offset (0, 0): at (220, 130). Lifted by 60 mm the tube is
  // clear of the rack, and in front of it there is nothing but the table.
  const std::string taken =
      "ROBOT \"lwa4p\"\nTOOL jaws = POSE(0mm, 0mm, 120mm)\nWITH jaws DO\n"
      "gripper = OFF\nMOVE(220mm, 130mm, 170mm, 180deg, 0deg, 0deg)\n"
      "MOVEL(z: 100mm) FINE\ngripper = ON\nWAIT gripper_closed\nWAIT 0.2s\nASSERT part_held\n"
      "MOVEL(z: 200mm)\nMOVEL(y: 70mm)\nMOVEL(z: ";
  const auto foretold_at = [&](const std::string& z, const std::string& around) {
    const auto program = rob::runtime::compile_program(
        "t.rob", around + taken + z + ") FINE\nENDWITH", embedded_robot("lwa4p"));
    for (const auto& found : program.compilation.diagnostics.all()) CAPTURE(found.message);
    REQUIRE(program.runnable());
    return rob::runtime::foretell(program, program.robot);
  };
  // Held 90 mm above its lower end.
  const RunResult above = foretold_at("105mm", "");
  CHECK(code_of(above) == "");
  const RunResult hits = foretold_at("80mm", "");
  CHECK(code_of(hits) == "E580");
  REQUIRE(hits.contact.has_value());
  CHECK(hits.contact->body == "part");
  CHECK(hits.contact->other == "table");
}

TEST_CASE("the seven-axis arm of the example would hit the wall if it did not go over it") {
  std::ifstream file(ROB_SOURCE_DIR "/examples/27_cell.rob");
  std::string text(std::istreambuf_iterator<char>(file), {});
  const std::size_t over = text.find("  MOVEL(z: 300mm)");
  REQUIRE(over != std::string::npos);
  text.erase(over, text.find('\n', over) + 1 - over);
  const auto program = rob::runtime::compile_program("t.rob", text, embedded_robot("fr3"));
  REQUIRE(program.runnable());
  const RunResult result = rob::runtime::foretell(program, program.robot);
  CHECK(code_of(result) == "E580");
  REQUIRE(result.contact.has_value());
  CHECK(result.contact->body == "gripper");
  CHECK(result.contact->other == "wall");
}
