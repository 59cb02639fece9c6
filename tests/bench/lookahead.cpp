/// The look-ahead law beside other controllers: times, and what the traces say of acceleration,
/// jerk and deviation (docs/motion.md). Exit code 1 where a goal or a bound is not kept.

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "tests/bench/bench_options.h"
#include "tests/bench/lookahead_cases.h"
#include "tests/support/trace_figures.h"
#include "tests/support/traced_run.h"

namespace {

using namespace rob::test;
using rob::bench::kBenchAcceleration;
using rob::bench::kBenchJerk;
using rob::bench::LookAheadCase;

struct Options {
  std::string rob = ROB_BINARY;
  std::string robots = ROB_BENCH_ROBOTS;
  std::string law = "lookahead";
  std::string only;
};

/// What a case came to, mm and s.
struct Outcome {
  double time = 0;
  double speed = 0;
  double acceleration = 0;
  double jerk = 0;
  double deviation = 0;
  std::string trouble;  ///< where it did not run
};

double greatest(const AxisValues& values) {
  return *std::max_element(values.begin(), values.end());
}

Outcome run(const LookAheadCase& c, double jerk, const Options& options) {
  const TracedRun made = run_traced(options.rob, c.program(jerk), options.robots + "/" + c.robot,
                                    {"--law", options.law});
  Outcome outcome;
  if (!made.done()) {
    outcome.trouble = made.trouble();
    return outcome;
  }
  const TracePeaks peaks = peaks_of(made.trace);
  outcome.time = motion_time(made.trace);
  outcome.speed = greatest(peaks.v);
  outcome.acceleration = greatest(peaks.a);
  outcome.jerk = greatest(peaks.j);
  // A corner leaves out a few times its zone of the path.
  const double window = std::max(3.0, 20 * c.zone);
  outcome.deviation = path_deviation(tool_curve(made.trace, 3), c.path, window).greatest();
  return outcome;
}

/// "**1.234**" where it is too much.
std::string held(double value, double most, int decimals) {
  const std::string text = fmt::format("{:.{}f}", value, decimals);
  return value <= most ? text : "**" + text + "**";
}

struct Count {
  int cases = 0;
  int kept = 0;
};

/// One row of the table, and whether all is kept.
std::string row(const LookAheadCase& c, double jerk, const Options& options, Count& count) {
  const double goal = jerk > 0 ? c.jerk_goal : c.goal();
  const double linuxcnc = jerk > 0 ? c.jerk_linuxcnc : c.linuxcnc;
  std::string text = fmt::format("| {} | {:g} | {:g} | {:g} | {:g} | {:.3f} | ", c.name, c.speed,
                                 c.zone, linuxcnc, c.best_known, goal);
  const Outcome o = run(c, jerk, options);
  ++count.cases;
  if (!o.trouble.empty()) return text + o.trouble.substr(0, o.trouble.find('\n')) + " | | | | |\n";
  const double most_jerk = jerk > 0 ? 1.1 * jerk : std::numeric_limits<double>::infinity();
  const bool kept = o.time <= goal && o.acceleration <= 1.02 * kBenchAcceleration &&
                    o.jerk <= most_jerk && o.deviation <= 1.01 * c.zone;
  count.kept += kept ? 1 : 0;
  return text + fmt::format("{} | {:.1f} | {} | {} | {} |\n", held(o.time, goal, 3), o.speed,
                            held(o.acceleration, 1.02 * kBenchAcceleration, 1),
                            jerk > 0 ? held(o.jerk, most_jerk, 0) : "",
                            held(o.deviation, 1.01 * c.zone, 4));
}

Count print_table(const char* title, double jerk, const Options& options) {
  fmt::print(
      "{}\n\n| program | F mm/s | P mm | LinuxCNC s | best known s | goal s | Rob s | axis speed | "
      "acceleration | jerk | deviation |\n|---|---|---|---|---|---|---|---|---|---|---|\n",
      title);
  Count count;
  for (const LookAheadCase& c : rob::bench::lookahead_cases()) {
    if (c.name.find(options.only) == std::string::npos) continue;
    if (jerk > 0 && c.jerk_goal == 0) continue;
    fmt::print("{}", row(c, jerk, options, count));
    std::fflush(stdout);
  }
  fmt::print("\n{} of {} keep the goal and every bound.\n\n", count.kept, count.cases);
  return count;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  rob::bench::BenchOptions line(
      "The look-ahead law beside other controllers. In bold what is too much.");
  line.add("--rob", options.rob, "the program to measure");
  line.add("--robots", options.robots, "where xy.toml and xyza.toml are");
  line.add("--law", options.law);
  line.add("--only", options.only, "cases whose name holds this");
  if (const std::optional<int> exit_code = line.parse(argc, argv)) return *exit_code;
  try {
    const Count plain = print_table("Every axis 1000 mm/s², jerk unlimited:", 0, options);
    const Count jerk = print_table("With JERK 1e5mm/s^3:", kBenchJerk, options);
    return plain.kept == plain.cases && jerk.kept == jerk.cases ? 0 : 1;
  } catch (const std::exception& error) {
    fmt::print(stderr, "lookahead: {}\n", error.what());
    return 70;
  }
}
