// What kill -9 leaves of the values that are kept between runs.
#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <sstream>
#include <thread>

#include "tests/support/rob_command.h"

using rob::test::Process;
using rob::test::ProcessResult;
using rob::test::read_whole_file;
using rob::test::RobCommand;

namespace {

/// What the program has said of itself: the value, and when it had it, s of its run.
struct Said {
  long value = 0;
  double time = 0;
};

std::vector<Said> said_in(const std::string& out) {
  std::vector<Said> all;
  std::istringstream text(out.substr(0, out.rfind('\n') + 1));  // the last line may be a part
  for (std::string line; std::getline(text, line);) {
    Said said;
    if (std::istringstream(line) >> said.value >> said.time) all.push_back(said);
  }
  return all;
}

/// The saved value, 0 if none is saved yet; the file must be whole.
long saved_in(const std::string& file) {
  if (!std::filesystem::exists(file)) return 0;
  const std::string text = read_whole_file(file);
  long value = 0;
  std::string expected;
  if (text.starts_with("n = ")) {
    value = std::stol(text.substr(4));
    expected = "n = " + std::to_string(value) + "\n";
  }
  expected += "row = [7";
  for (int i = 1; i < 100; ++i) expected += ", 7";
  REQUIRE(text == expected + "]\n");
  return value;
}

}  // namespace

TEST_CASE("kill -9 leaves the values whole, and takes the last second of them at most") {
  // The row only makes the file longer.
  const RobCommand rob(
      "PERSIST VAR n = 0\nPERSIST VAR row: ARRAY[100] OF INT\n"
      "FOR i = 1 TO 100 DO\nrow[i] = 7\nENDFOR\nWAIT 0s\n"
      "LOOP\nn += 1\nPRINT n, \" \", CLOCK\nWAIT 0.02s\nENDLOOP\n");
  long saved = 0;
  for (const int moment : {300, 1100, 1950, 2600}) {  // ms
    CAPTURE(moment);
    Process process(rob.line("run"));
    std::this_thread::sleep_for(std::chrono::milliseconds(moment));
    process.send(SIGKILL);
    const ProcessResult result = process.wait();
    CHECK(result.exit_code == 128 + SIGKILL);
    const std::vector<Said> said = said_in(result.out);
    if (said.empty()) continue;              // it had not begun
    CHECK(said.front().value == saved + 1);  // it goes on from what was kept
    saved = saved_in(rob.file("test.values"));
    // It may have been killed after a value was kept, and before it was said.
    CHECK(saved <= said.back().value + 1);
    // The time of the first value that is lost. Values count by 1.
    const auto lost = static_cast<std::size_t>(saved + 1 - said.front().value);
    const double from = said.at(std::min(lost, said.size() - 1)).time;
    // A second between two saves, and what a save itself takes.
    CHECK(said.back().time - from < 1.25);
  }
  CHECK(saved > 0);
}
