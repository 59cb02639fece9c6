// The memory that a command takes at most.
#include <doctest/doctest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>

#include "tests/support/rob_command.h"

#if !defined(ROB_SANITIZED)

using rob::test::RobCommand;
using rob::test::run_process;

namespace {

/// The greatest memory of `rob` with these arguments, MB. In a process of its own, of whose
/// children it is the only one.
int megabytes_of(const std::vector<std::string>& arguments, int exit_code) {
  const pid_t child = ::fork();
  if (child == 0) {
    const bool done = run_process(arguments).exit_code == exit_code;
    rusage usage{};
    ::getrusage(RUSAGE_CHILDREN, &usage);
    ::_exit(done ? static_cast<int>(usage.ru_maxrss / 1024) : 255);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return WEXITSTATUS(status);
}

}  // namespace

TEST_CASE("the memory of a run does not grow with what it prints and switches") {
  // At 12 bytes each the last million would take 12 MB.
  for (const char* const body : {"PRINT i", "DOUT[3] = ON\nDOUT[3] = OFF"}) {
    CAPTURE(body);
    const auto program = [&](int count) {
      return RobCommand("FOR i = 1 TO " + std::to_string(count) + " DO\n" + body + "\nENDFOR\n");
    };
    const RobCommand few = program(100'000);
    const RobCommand many = program(1'100'000);
    const int before = megabytes_of(few.line("run", {"--fast", "--json"}), 0);
    const int after = megabytes_of(many.line("run", {"--fast", "--json"}), 0);
    CHECK(before > 5);
    CHECK(after < 64);
    CHECK(after - before < 12);
  }
}

TEST_CASE("what is switched takes no memory in rob check, either") {
  const RobCommand rob("FOR i = 1 TO 600000 DO\nDOUT[3] = ON\nDOUT[3] = OFF\nENDFOR\n");
  CHECK(megabytes_of(rob.line("check", {"--json"}), 0) < 32);
}

TEST_CASE("a program of two hundred thousand motions is foretold and run in little memory") {
  // A tenth of a millimetre each, on circles of 50 mm.
  constexpr int kMotions = 200'000;
  std::string text;
  for (int i = 0; i < kMotions; ++i) {
    const double angle = i * 0.002;
    text += "MOVE(" + std::to_string(50 * std::cos(angle)) + ", " +
            std::to_string(50 * std::sin(angle)) + ", 0)\n";
  }
  const RobCommand rob(text);
  const std::string xy = std::string(ROB_SOURCE_DIR) + "/tests/bench/xy.toml";
  // 37 MB are the robot's with its 4096 motions of look-ahead and the short ones that become
  // curves, each with the shape of its tool; a line has 36 bytes of code and 64 of totals. Its text
  // is put away.
  const int foretold = megabytes_of(rob.line("check", {"--robot", xy}), 0);
  CHECK(foretold > 20);
  CHECK(foretold <= 66);
  CHECK(megabytes_of(rob.line("run", {"--fast", "--robot", xy}), 0) <= 66);
}

TEST_CASE("a program of too many declarations is refused before it takes much memory") {
  for (const char* const kind : {"VAR v", "POINT p"}) {
    CAPTURE(kind);
    std::string text;
    for (int i = 0; i < 1'000'000; ++i) text += kind + std::to_string(i) + " = 1\n";
    const int megabytes = megabytes_of(RobCommand(text).line("check"), 65);
    // 65,536 names of some 1000 bytes, and the text itself of 20 MB.
    CHECK(megabytes > 20);
    CHECK(megabytes < 128);
  }
}

#endif
