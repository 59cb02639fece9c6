/// How fast a program of plain MOVE lines is read, checked and compiled, and the memory it takes.

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdlib>
#include <string>

#include "lang/compile/compile.h"
#include "runtime/command/robot_machine.h"
#include "runtime/run/load.h"

namespace {

constexpr int kLines = 1'000'000;
constexpr int kTurns = 5;

/// Coordinates in hundredths of a millimetre, no two lines alike, all within the gantry's reach.
std::string program() {
  std::string source;
  for (int i = 0; i < kLines; ++i) {
    source += fmt::format("MOVE({:.2f}, {:.2f}, {})\n", i * 7 % 40000 / 100.0,
                          i * 13 % 30000 / 100.0, i % 90);
  }
  return source;
}

/// The most memory that the process has taken, bytes.
double most_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

}  // namespace

int main() {
  const auto robot = rob::runtime::load_robot("gantry");
  const std::string source = program();
  const double before = most_memory();
  double least = 1e9;
  for (int turn = 0; turn < kTurns; ++turn) {
    const auto begin = std::chrono::steady_clock::now();
    const auto loaded = rob::runtime::compile_program("bench.rob", source, robot, "");
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
    if (!loaded.runnable()) return EXIT_FAILURE;
    least = std::min(least, time.count());
    if (turn > 0) continue;
    // The loaded program holds the text once more.
    fmt::print("{:.0f} bytes a line, {} of them text\n", (most_memory() - before) / kLines,
               source.size() / kLines);
  }
  fmt::print("{:.0f} lines a second (the best of {} turns of {} lines)\n", kLines / least, kTurns,
             kLines);
}
