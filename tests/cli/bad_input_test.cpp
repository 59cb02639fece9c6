// Whatever is wrong with the input: a message that names it, the right exit code, nothing moved.
#include <doctest/doctest.h>

#include <cstdlib>
#include <random>

#include "tests/support/rob_command.h"

using nlohmann::json;
using rob::test::contains;
using rob::test::ProcessResult;
using rob::test::RobCommand;

namespace {

/// A program that must be refused before anything moves, and a part of what is said about it.
void refuses(const std::string& text, const std::string& message) {
  const RobCommand rob(text);
  for (const char* command : {"run", "check"}) {
    const ProcessResult result = rob(command, {"--json"});
    CAPTURE(result.err.substr(0, 1000));
    CHECK(result.exit_code == 65);
    CHECK(contains(result.err, message));
    const json report = json::parse(result.out);
    CHECK(report["status"] == "program-error");
    CHECK(report["lines"].empty());
    CHECK_FALSE(report["error"].is_null());
  }
}

/// A robot file made from the gantry's by one replacement.
ProcessResult run_on_changed_gantry(const std::string& from, const std::string& to) {
  std::string text =
      rob::test::read_whole_file(std::string(ROB_SOURCE_DIR) + "/motion/robots/gantry.toml");
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  text.replace(at, from.size(), to);
  const RobCommand rob("MOVE(10,0,0)\n");
  std::ofstream(rob.file("odd.toml")) << text;
  return rob("run", {"--fast", "--robot", rob.file("odd.toml")});
}

}  // namespace

TEST_CASE("fault 1: an unknown word is refused with what may have been meant") {
  refuses("MOVEE(1,2,3)\n", "did you mean MOVE?");
}

TEST_CASE("fault 1: all errors of a file are told, each at its place") {
  const RobCommand rob("MOVE(1,2\nPRINT nobody\nMOVE(5s,0,0)\n");
  const ProcessResult result = rob("run");
  CHECK(result.exit_code == 65);
  CHECK(contains(result.err, "test.rob:1:9: error["));
  CHECK(contains(result.err, "test.rob:2:7: error["));
  CHECK(contains(result.err, "test.rob:3:6: error["));
}

TEST_CASE("fault 2: an error in line 900 of 1000 is found before anything moves") {
  std::string text;
  for (int i = 1; i <= 1000; ++i) text += i == 900 ? "MOVE(1,\n" : "MOVE(1,2,3)\n";
  refuses(text, "test.rob:900:");
}

TEST_CASE("fault 3: a line of 10 MB is refused") {
  std::string sum = "PRINT 1";
  while (sum.size() < 10'000'000) sum += "+1";
  refuses(sum + "\n", "too long");
}

TEST_CASE("fault 3: 100,000 nested parentheses are refused as too deep") {
  std::string nested = "PRINT ";
  for (int i = 0; i < 100'000; ++i) nested += i % 1000 == 999 ? "(\n" : "(";
  refuses(nested + "1", "too deep");
}

TEST_CASE("fault 5: binary garbage is refused and named by its byte") {
  std::mt19937 random(20100101);
  std::string garbage;
  for (int i = 0; i < 100'000; ++i) garbage += static_cast<char>(random() & 0xFFU);
  refuses(garbage, "byte ");
}

TEST_CASE("fault 8: a target beyond the limits is refused, with axis, value and limit") {
  refuses("MOVE(40,40,0)\nMOVE(9000,0,0)\n", "axis x: 9000 mm is beyond 400 mm");
  refuses("MOVE(0,0,-200)\n", "axis theta: -200 deg is below -180 deg");
}

TEST_CASE("a wrong dimension is refused, with both dimensions in words") {
  refuses("MOVE(5s,0,0)\n", "this is a time, 5s; x of MOVE needs a length here");
}

TEST_CASE("an empty file says so and moves nothing") {
  const ProcessResult result = RobCommand("")("run", {"--fast"});
  CHECK(result.exit_code == 0);
  CHECK(contains(result.err, "no statement"));
}

TEST_CASE("fault 41: a program that is missing, a folder or a device is refused at once") {
  for (const char* path : {"/no/such/file.rob", "/tmp", "/dev/zero"}) {
    const ProcessResult result = rob::test::run_process({ROB_BINARY, "run", path});
    CHECK(result.exit_code == 74);
    CHECK(contains(result.err, path));
  }
}

TEST_CASE("of several programs none starts if one of them cannot be read") {
  const RobCommand rob("PRINT \"started\"\n");
  const ProcessResult result = rob("run", {rob.file("nowhere.rob"), "--fast"});
  CHECK(result.exit_code == 74);
  CHECK(result.out.empty());
  CHECK(contains(result.err, "nowhere.rob"));
}

TEST_CASE("a trace is of one program: with two the second would overwrite the first") {
  const RobCommand rob("PRINT \"started\"\n");
  const ProcessResult result =
      rob("run", {rob.program(), "--fast", "--trace", rob.file("trace.csv")});
  CHECK(result.exit_code == 64);
  CHECK(result.out.empty());
  CHECK(contains(result.err, "--trace records one program"));
}

TEST_CASE("fault 41: a trace that cannot be written is refused before anything moves") {
  const RobCommand rob("MOVE(10,0,0)\nPRINT \"moved\"\n");
  for (const std::string& path : {std::string("/no/such/folder/t.csv"), std::string("/tmp"),
                                  std::string("/dev/zero"), rob.program()}) {
    const ProcessResult result = rob("run", {"--fast", "--trace", path});
    CHECK(result.exit_code == (path == rob.program() ? 64 : 74));
    CHECK_FALSE(contains(result.out, "moved"));
  }
  CHECK(rob::test::read_whole_file(rob.program()) == "MOVE(10,0,0)\nPRINT \"moved\"\n");
}

TEST_CASE("fault 40: a full disk stops the trace, not the robot, and says how much is lost") {
  const RobCommand rob("MOVE(10,0,0)\n");
  const ProcessResult result = rob("run", {"--fast", "--trace", "/dev/full", "--json"});
  CHECK(result.exit_code == 74);
  CHECK(json::parse(result.out)["lost_rows"] == 551);
  CHECK(contains(result.err, "551 rows are lost"));  // 2.75 s and 2.75 s for the end: 550 + 1
  CHECK(json::parse(result.out)["status"] == "done");
}

TEST_CASE("fault 43: a robot file with a missing or absurd value is refused with its place") {
  struct Case {
    const char* from;
    const char* to;
    const char* message;
  };
  const Case cases[] = {
      {"t_acc = \"1.375 s\"", "", "t_acc"},
      {"v_max = \"20 mm/s\"", "v_max = \"0 mm/s\"", "v_max"},
      {"v_max = \"20 mm/s\"", "v_max = \"-20 mm/s\"", "v_max"},
      {"v_max = \"20 mm/s\"", "v_max = \"20 mm\"", "v_max"},
      {"v_max = \"20 mm/s\"", "v_max = \"1e12 mm/s\"", "v_max"},
      {"v_max = \"20 mm/s\"", "v_maxx = \"20 mm/s\"", "v_max"},
      {"law = \"paul\"", "law = \"paul\"\nlaw = \"paul\"", "law"},
      {"max = \"400 mm\"", "max = \"-1 mm\"", "max"},
  };
  for (const Case& c : cases) {
    const ProcessResult result = run_on_changed_gantry(c.from, c.to);
    CAPTURE(c.to);
    CAPTURE(result.err);
    CHECK(result.exit_code == 65);
    CHECK(contains(result.err, "odd.toml:"));
    CHECK(contains(result.err, c.message));
  }
}

TEST_CASE("an unknown robot, command or option is a usage error or names what there is") {
  const RobCommand rob("MOVE(10,0,0)\n");
  CHECK(rob("run", {"--robot", "gantri"}).exit_code == 65);
  CHECK(contains(rob("run", {"--robot", "gantri"}).err, "did you mean 'gantry'?"));
  CHECK(rob("frobnicate").exit_code == 64);
  CHECK(rob("run", {"--no-such-option"}).exit_code == 64);
  CHECK(rob("run", {"--override", "0%"}).exit_code == 64);
  CHECK(rob("run", {"--override", "201%"}).exit_code == 64);
  CHECK(rob("run", {"--law", "linear"}).exit_code == 64);
}

TEST_CASE("results that cannot be written are reported, exit code 74, after the run") {
  const RobCommand rob("MOVE(10,0,0)\nPRINT \"there\"\n");
  const std::string command =
      std::string(ROB_BINARY) + " run --fast " + rob.program() + " >/dev/full 2>/dev/null";
  CHECK(WEXITSTATUS(std::system(command.c_str())) == 74);
}

TEST_CASE("values that cannot be read refuse the start before the machine is opened") {
  const RobCommand rob("PERSIST VAR n = 0\nMOVE(10,0,0)\n");
  std::ofstream(rob.file("test.values")) << "n = 1mm\n";
  const ProcessResult result = rob("run", {"--backend", "grbl:/dev/ttyNothing"});
  CHECK(result.exit_code == 74);
  CHECK(contains(result.err, "test.values:1:5"));
  CHECK_FALSE(contains(result.err, "ttyNothing"));
}

TEST_CASE("a device that does not answer refuses the start before the machine is opened") {
  const RobCommand rob("DEVICE scale = \"tcp://127.0.0.1:1\"\nMOVE(10,0,0)\n");  // nobody there
  const ProcessResult result = rob("run", {"--backend", "grbl:/dev/ttyNothing"});
  CHECK(result.exit_code == 74);
  CHECK(contains(result.err, "DEVICE scale"));
  CHECK_FALSE(contains(result.err, "ttyNothing"));
}
