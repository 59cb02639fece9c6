#include "tests/support/process.h"

#include <doctest/doctest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include "tests/support/eventually.h"

using namespace rob::test;

TEST_CASE("what a process writes and how it ends is known") {
  const ProcessResult result =
      run_process({"/bin/sh", "-c", "echo out; echo \"$1\" >&2; exit 65", "sh", "two words"});
  CHECK(result.exit_code == 65);
  CHECK(result.out == "out\n");
  CHECK(result.err == "two words\n");
}

TEST_CASE("a process that a signal ends is told from one that returns") {
  CHECK(run_process({"/bin/sh", "-c", "kill -TERM $$"}).exit_code == 128 + 15);
}

TEST_CASE("a process that does not exist is an error") {
  CHECK_THROWS_AS(run_process({"/nowhere/rob"}), std::system_error);
}

namespace {

/// Whether the process still runs; one that nobody has waited for does not.
bool runs(const std::string& pid) {
  std::ifstream stream("/proc/" + pid + "/stat");
  std::string number, name, state;
  return stream >> number >> name >> state && state != "Z";
}

/// A shell command that starts a child, writes its number to the file, and waits for it.
std::vector<std::string> with_child(const std::string& file) {
  return {"/bin/sh", "-c", "sleep 1000 & echo $! > '" + file + "'; wait"};
}

std::string child_in(const std::string& file) {
  std::string pid;
  REQUIRE(eventually([&] { return static_cast<bool>(std::ifstream(file) >> pid); }));
  return pid;
}

}  // namespace

TEST_CASE("a process that hangs is killed with its children, and named") {
  const ScratchFolder scratch;
  const std::string file = scratch.file("child");
  Process hanging(with_child(file));
  const std::string child = child_in(file);
  CHECK(runs(child));
  CHECK_THROWS_WITH_AS(hanging.wait(std::chrono::milliseconds(50)),
                       doctest::Contains("/bin/sh -c sleep 1000"), std::runtime_error);
  CHECK(eventually([&] { return !runs(child); }));
}

TEST_CASE("a process that a test leaves is killed with its children") {
  const ScratchFolder scratch;
  std::string child;
  {
    const Process left(with_child(scratch.file("child")));
    child = child_in(scratch.file("child"));
  }
  CHECK(eventually([&] { return !runs(child); }));
}

TEST_CASE("what a test has started ends with it, whatever kills it") {
  const ScratchFolder scratch;
  const std::string file = scratch.file("child");
  const pid_t test = ::fork();
  if (test == 0) {
    const Process started({"/bin/sh", "-c", "echo $$ > '" + file + "'; exec sleep 1000"});
    for (;;) ::pause();
  }
  const std::string child = child_in(file);
  CHECK(runs(child));
  ::kill(test, SIGKILL);
  ::waitpid(test, nullptr, 0);
  CHECK(eventually([&] { return !runs(child); }));
}

TEST_CASE("a scratch folder disappears with what is in it") {
  std::filesystem::path path;
  {
    const ScratchFolder scratch;
    path = scratch.path();
    std::ofstream(path / "file") << "x";
    CHECK(read_whole_file(path / "file") == "x");
  }
  CHECK_FALSE(std::filesystem::exists(path));
  CHECK_THROWS(read_whole_file(path / "file"));
}
