#include "runtime/run/load.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>

#include "motion/robots/robot_file.h"
#include "runtime/files/files.h"
#include "tests/support/scratch_folder.h"

namespace rob::runtime {
namespace {

/// A program of more than a megabyte.
std::string long_program() {
  std::string text;
  for (int i = 0; i < 80'000; ++i) text += "MOVE(" + std::to_string(i % 100) + ", 10, 10)\n";
  return text;
}

}  // namespace

TEST_CASE("a long source text that is put away is read anew for messages, if it is the same") {
  const test::ScratchFolder scratch;
  const std::string file = scratch.file("long.rob");
  const std::string text = long_program();
  std::ofstream(file, std::ios::binary) << text;
  LoadedProgram program = load_program(file, "");
  REQUIRE(program.runnable());
  put_source_away(program);
  CHECK(program.source.capacity() < 1000);
  const std::string shown = source_lines(program, {3});
  CHECK(shown.starts_with("\n\nMOVE(2, 10, 10)\n\n\n"));
  CHECK(std::ranges::count(shown, '\n') == std::ranges::count(text, '\n'));
  std::ofstream(file, std::ios::binary) << "PRINT 1\n" << text;
  CHECK(source_lines(program, {3}).empty());
  std::filesystem::remove(file);
  CHECK(source_lines(program, {3}).empty());
}

TEST_CASE("a robot file that cannot be read is a file's error, not a robot's") {
  const test::ScratchFolder scratch;
  const std::string file = scratch.file("none.toml");
  CHECK_THROWS_WITH_AS(
      load_robot(file),
      ("cannot read '" + file + "': No such file or directory; check the name and the folder")
          .c_str(),
      FileError);
  CHECK_THROWS_AS(load_robot("nobody"), motion::RobotFileError);
}

TEST_CASE("a short source text stays as it was compiled") {
  const test::ScratchFolder scratch;
  const std::string file = scratch.file("short.rob");
  std::ofstream(file) << "PRINT 1\n";
  LoadedProgram program = load_program(file, "");
  put_source_away(program);
  std::filesystem::remove(file);
  CHECK(source_lines(program, {}) == "PRINT 1\n");
}

}  // namespace rob::runtime
