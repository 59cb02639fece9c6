// Records of runs, and what repeats them.
#include <doctest/doctest.h>

#include <fstream>
#include <string>

#include "tests/support/rob_command.h"

using rob::test::contains;
using rob::test::ProcessResult;
using rob::test::read_whole_file;
using rob::test::RobCommand;
using rob::test::run_process;

namespace {

constexpr const char* kRecordedProgram =
    "USE tools\nPERSIST VAR n = 0\nPOINT p = POSE(20mm, 30mm, 0mm, 0deg, 0deg, 0deg)\nn = n + 1\n"
    "go(50mm)\nMOVE p\nWAIT DIN[1] TIMEOUT 5s\nPRINT \"run \", n\nMOVE(RANDOM() * 100mm, 0, 0)\n";

/// A program with a used file, points, saved values and a signal script, recorded.
struct RecordedRun {
  RobCommand rob{kRecordedProgram};
  std::string record = rob.file("run.mcap");
  RecordedRun() {
    std::ofstream(rob.file("tools.rob")) << "PROC go(x: LENGTH)\n  MOVE(x, 10, 0)\nENDPROC\n";
    std::ofstream(rob.file("in.signals")) << "at 4s DIN[1] = ON\n";
    const ProcessResult run = rob(
        "run", {"--fast", "--seed", "7", "--signals", rob.file("in.signals"), "--mcap", record});
    REQUIRE(run.exit_code == 0);
  }
};

ProcessResult replayed(const std::string& record) {
  return run_process({ROB_BINARY, "run", "--replay", record});
}

}  // namespace

TEST_CASE("a record repeats its run wherever it is, though the program has changed since") {
  const RecordedRun run;
  std::ofstream(run.rob.program()) << "MOVE(1,1,1)\n";
  std::ofstream(run.rob.file("tools.rob")) << "";
  const ProcessResult again = replayed(run.record);
  CHECK(again.exit_code == 0);
  CHECK(contains(again.out, "the same, all "));
  CHECK_FALSE(contains(again.out, "run 1"));  // nothing is printed anew
}

TEST_CASE("a record with another reference is told apart, with the time of the first") {
  const RecordedRun run;
  std::string bytes = read_whole_file(run.record);
  const std::string begin = "\"line\":\"6\",\"q\":[";
  const std::size_t at = bytes.find(begin);
  REQUIRE(at != std::string::npos);
  char& digit = bytes[at + begin.size()];
  digit = digit == '1' ? '2' : '1';
  std::ofstream(run.record, std::ios::binary) << bytes;
  const ProcessResult again = replayed(run.record);
  CHECK(again.exit_code == 65);
  CHECK(contains(again.out, "differs from t = "));
}

TEST_CASE("files that are no records, and records that cannot be written, are exit 74") {
  const RecordedRun run;
  CHECK(replayed(run.rob.program()).exit_code == 74);
  CHECK(replayed(run.rob.file("none.mcap")).exit_code == 74);
  CHECK(run.rob("run", {"--fast", "--mcap", run.rob.file("no/x.mcap")}).exit_code == 74);
  const RobCommand move("MOVE(10,0,0)\n");
  const ProcessResult full = move("run", {"--fast", "--mcap", "/dev/full"});
  CHECK(full.exit_code == 74);
  CHECK(contains(full.err, "is the disk full?"));
}

TEST_CASE("--replay takes no program, and a run without it needs one") {
  const RobCommand rob("MOVE(10,0,0)\n");
  CHECK(rob("run", {"--replay", "x.mcap"}).exit_code == 64);
  CHECK(run_process({ROB_BINARY, "run"}).exit_code == 64);
}
