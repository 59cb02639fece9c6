#include "tests/support/process.h"

#include <doctest/doctest.h>

#include <fstream>
#include <system_error>

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
