// Files that a command writes: never what it reads.
#include <doctest/doctest.h>
#include <unistd.h>

#include <filesystem>

#include "tests/support/rob_command.h"

namespace fs = std::filesystem;
using nlohmann::json;
using rob::test::contains;
using rob::test::ProcessResult;
using rob::test::read_whole_file;
using rob::test::RobCommand;
using rob::test::run_process;

namespace {

constexpr const char* kProgram =
    "USE used\nPOINT p = POSE(1mm, 2mm, 0mm, 0deg, 0deg, 0deg)\nMOVE(10,0,0)\n";

/// A program with every kind of file that it can read.
struct Inputs {
  RobCommand rob{kProgram};
  Inputs() {
    write("used.rob", "CONST one = 1\n");
    write("test.points", "");
    write("in.signals", "at 0.5s DIN[1] = ON\n");
    fs::copy_file(fs::path(ROB_SOURCE_DIR) / "motion/robots/gantry.toml", rob.file("own.toml"));
    ::setenv("XDG_DATA_HOME", rob.file("data").c_str(), 1);
    fs::create_directories(rob.file("data/rob/archive"));
    fs::create_directories(rob.file("states/rob"));
  }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(rob.file(name), std::ios::binary) << text;
  }
  std::vector<std::string> options() const {
    return {"--robot", rob.file("own.toml"), "--signals", rob.file("in.signals")};
  }
  ProcessResult write_to(const std::string& command, const std::string& option,
                         const std::string& file) const {
    std::vector<std::string> more = options();
    if (command == "run") more.emplace_back("--fast");
    if (command == "check") more.insert(more.end(), {"--law", "lookahead"});
    more.insert(more.end(), {option, file});
    return rob(command, more);
  }
};

struct Output {
  const char* command;
  const char* option;
};
constexpr Output kOutputs[] = {{"run", "--trace"},  {"run", "--report"},   {"run", "--mcap"},
                               {"check", "--path"}, {"check", "--report"}, {"check", "--svg"}};

}  // namespace

TEST_CASE("no output overwrites a file that is read, by whatever name it is called") {
  const Inputs inputs;
  const fs::path folder = fs::path(inputs.rob.program()).parent_path();
  for (const Output output : kOutputs) {
    for (const char* const name :
         {"test.rob", "used.rob", "test.points", "in.signals", "own.toml"}) {
      const std::string before = read_whole_file(inputs.rob.file(name));
      const fs::path hard = folder / "hard";
      const fs::path soft = folder / "soft";
      fs::create_hard_link(folder / name, hard);
      fs::create_symlink(name, soft);
      const std::string around = (folder / "states" / ".." / name).string();
      for (const std::string& called :
           {(folder / name).string(), around, hard.string(), soft.string()}) {
        CAPTURE(output.option);
        CAPTURE(called);
        const ProcessResult result = inputs.write_to(output.command, output.option, called);
        CHECK(result.exit_code == 64);
        CHECK(result.out.empty());
        CHECK(contains(result.err, output.option));
        CHECK(contains(result.err, "name another file"));
        CHECK(read_whole_file(inputs.rob.file(name)) == before);
      }
      fs::remove(hard);
      fs::remove(soft);
    }
    CHECK(inputs.write_to(output.command, output.option, inputs.rob.file("new.csv")).exit_code ==
          0);
  }
}

TEST_CASE("points that are not there yet are not overwritten either, nor what Rob keeps itself") {
  const Inputs inputs;
  fs::remove(inputs.rob.file("test.points"));
  fs::create_symlink("test.points", inputs.rob.file("soft"));
  for (const Output output : kOutputs) {
    for (const char* const name :
         {"test.points", "soft", "data/rob/archive/a.rob", "states/rob/history"}) {
      CAPTURE(name);
      CHECK(inputs.write_to(output.command, output.option, inputs.rob.file(name)).exit_code == 64);
      CHECK_FALSE(fs::exists(inputs.rob.file(name)));
    }
  }
}

TEST_CASE("the prompt's trace overwrites neither its robot file nor its points") {
  const Inputs inputs;
  const std::string robot = inputs.rob.file("own.toml");
  const std::string before = read_whole_file(robot);
  CHECK(run_process({ROB_BINARY, "--fast", "--robot", robot, "--trace", robot}).exit_code == 64);
  CHECK(read_whole_file(robot) == before);
  CHECK(run_process({ROB_BINARY, "--fast", "--trace", "prompt.gantry.points"}).exit_code == 64);
  CHECK_FALSE(fs::exists("prompt.gantry.points"));
}

TEST_CASE("an empty name of a file is a usage error, and not none") {
  const RobCommand rob("MOVE(10,0,0)\n");
  CHECK(rob("run", {"--fast", "--trace", ""}).exit_code == 64);
  CHECK(rob("run", {"--fast", "--signals", ""}).exit_code == 64);
  CHECK(rob("run", {"--fast", "--robot", ""}).exit_code == 64);
  CHECK(rob("check", {"--law", "lookahead", "--path", ""}).exit_code == 64);
  CHECK(run_process({ROB_BINARY, "--fast", "--trace", ""}).exit_code == 64);
  CHECK(run_process({ROB_BINARY, "run", "--fast", ""}).exit_code == 64);
}

TEST_CASE("a points file that cannot be written is found before anything moves") {
  const RobCommand rob("POINT p\nMOVE(10,0,0)\nPRINT \"moved\"\nTEACH p\n");
  fs::create_directory(rob.file(".test.points.saving"));
  const ProcessResult result = rob("run", {"--fast"});
  CHECK(result.exit_code == 74);
  CHECK(result.out.empty());
  CHECK(contains(result.err, "cannot save '" + rob.file("test.points") + "'"));
  CHECK(contains(result.err, "test.rob:4 keeps points there"));
  fs::remove(rob.file(".test.points.saving"));
  CHECK(rob("run", {"--fast"}).exit_code == 0);
}

TEST_CASE("the report keeps the first and the last 5,000 of a list, and counts all") {
  const RobCommand rob("FOR i = 1 TO 20000 DO\nPRINT i\nDOUT[3] = ON\nENDFOR\n");
  const json report = json::parse(rob("run", {"--fast", "--json"}).out);
  CHECK(report["output_count"] == 20000);
  REQUIRE(report["output"].size() == 10000);
  CHECK(report["output"][4999] == "5000");
  CHECK(report["output"][5000] == "15001");
  CHECK(report["output"][9999] == "20000");
  CHECK(report["signals_count"] == 20000);
  CHECK(report["signals"].size() == 10000);
}
