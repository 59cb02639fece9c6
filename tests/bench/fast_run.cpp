/// What a cycle of `rob run --fast` costs, of plain moves of the gantry: processor time of the
/// process, beside that of a turn of x = sqrt(x*1.0000001 + sin(x)), measured in between. Of both
/// the least of some rounds counts.

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "tests/bench/bench_options.h"
#include "tests/support/rob_command.h"

namespace rob::bench {

namespace {

struct Options {
  int rounds = 5;
  int squares = 2000;
};

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

/// Processor time in user mode, s.
double used(int who) {
  rusage usage{};
  ::getrusage(who, &usage);
  return seconds(usage.ru_utime);
}

/// s for a turn.
double turn_cost() {
  constexpr int kTurns = 10'000'000;
  const double before = used(RUSAGE_SELF);
  double x = 1.5;
  for (int i = 0; i < kTurns; ++i) x = std::sqrt(x * 1.0000001 + std::sin(x));
  const double cost = (used(RUSAGE_SELF) - before) / kTurns;
  return std::isfinite(x) ? cost : std::numeric_limits<double>::quiet_NaN();
}

/// Squares of 100 mm, with a slope on the last side.
std::string program(int squares) {
  return fmt::format(
      "FOR i = 1 TO {} DO\n  MOVE(0, 0, 0)\n  MOVE(100, 0, 0)\n  MOVE(100, 100, 0)\n"
      "  MOVE(0, 100, 50)\nENDFOR\n",
      squares);
}

struct Run {
  std::int64_t cycles = 0;
  double time = 0;  ///< s
};

std::optional<Run> run(const test::RobCommand& rob) {
  const double before = used(RUSAGE_CHILDREN);
  const test::ProcessResult result = rob("run", {"--fast", "--json"});
  if (result.exit_code != 0) return std::nullopt;
  const auto report = nlohmann::json::parse(result.out);
  return Run{report.at("cycles").get<std::int64_t>(), used(RUSAGE_CHILDREN) - before};
}

int compare(const Options& options) {
  const test::RobCommand rob(program(options.squares));
  double turn = turn_cost();
  std::optional<Run> best;
  for (int i = 0; i < options.rounds; ++i) {
    const std::optional<Run> one = run(rob);
    if (!one) return fmt::print(stderr, "fast_run: the run failed\n"), 1;
    if (!best || one->time < best->time) best = one;
    turn = std::min(turn, turn_cost());
  }
  const double cycle = best->time / static_cast<double>(best->cycles);
  fmt::print("| cycles | a cycle | a turn | turns a cycle | cycles/s |\n|---|---|---|---|---|\n");
  fmt::print("| {} | {:.0f} ns | {:.1f} ns | {:.1f} | {:.2f} M |\n", best->cycles, cycle * 1e9,
             turn * 1e9, cycle / turn, 1e-6 / cycle);
  return 0;
}

}  // namespace

}  // namespace rob::bench

int main(int argc, char** argv) {
  rob::bench::Options options;
  rob::bench::BenchOptions line("Processor time of a cycle of `rob run --fast`");
  line.add("--rounds", options.rounds, 1, 100);
  line.add("--squares", options.squares, 1, 100'000, "of 20 s of the run each");
  if (const std::optional<int> exit_code = line.parse(argc, argv)) return *exit_code;
  return rob::bench::compare(options);
}
