/// How fast a program of plain MOVE lines is read, checked and compiled, bare and with AT and ZONE,
/// and the memory it takes.

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <ctime>
#include <string>
#include <string_view>

#include "lang/compile/compile.h"
#include "runtime/command/robot_machine.h"
#include "runtime/run/load.h"

namespace {

constexpr int kLines = 1'000'000;
constexpr int kTurns = 5;

/// Coordinates in hundredths of a millimetre, no two lines alike, all within the gantry's reach.
std::string program(std::string_view clauses) {
  std::string source;
  for (int i = 0; i < kLines; ++i) {
    source += fmt::format("MOVE({:.2f}, {:.2f}, {}){}\n", i * 7 % 40000 / 100.0,
                          i * 13 % 30000 / 100.0, i % 90, clauses);
  }
  return source;
}

/// The most memory that the process has taken, bytes.
double most_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

/// Processor time of the fastest of some turns, s; below 0 where the program cannot be run.
double compile_time(const rob::motion::RobotModel& robot, std::string_view clauses) {
  const std::string source = program(clauses);
  const double before = most_memory();
  double least = 1e9;
  for (int turn = 0; turn < kTurns; ++turn) {
    const std::clock_t begin = std::clock();
    const auto loaded = rob::runtime::compile_program("bench.rob", source, robot, "");
    const auto time = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    if (!loaded.runnable()) return -1;
    least = std::min(least, time);
    if (turn > 0) continue;
    // The loaded program holds the text once more. After a smaller program it is what comes on top.
    fmt::print("MOVE (…){}: {:.0f} bytes a line, {} of them text\n", clauses,
               (most_memory() - before) / kLines, source.size() / kLines);
  }
  fmt::print("{:.0f} lines a second (the best of {} turns of {} lines)\n", kLines / least, kTurns,
             kLines);
  return least;
}

}  // namespace

int main() {
  const auto robot = rob::runtime::load_robot("gantry");
  const double bare = compile_time(robot, "");
  const double paced = compile_time(robot, " AT 15mm/s ZONE 1.5mm");
  if (bare < 0 || paced < 0) return EXIT_FAILURE;
  fmt::print("with AT and ZONE: {:.2f} times the processor time of bare ones, {:.0f} MB at most\n",
             paced / bare, most_memory() / 1e6);
}
