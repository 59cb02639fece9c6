/// Long programs under the look-ahead law: random polylines and a relief of short pieces, judged by
/// their traces and beside the time-optimal motion of a rounded polyline; and a million segments,
/// which take no more memory than few (docs/motion.md). Exit code 1 where something is not kept.

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "tests/bench/bench_options.h"
#include "tests/bench/lookahead_cases.h"
#include "tests/support/ordered_distance.h"
#include "tests/support/random_text.h"
#include "tests/support/rounded_polyline.h"
#include "tests/support/trace_figures.h"
#include "tests/support/traced_run.h"

namespace {

using namespace rob::test;
using Eigen::Vector3d;
using rob::bench::kBenchAcceleration;

struct Options {
  std::string rob = ROB_BINARY;
  std::string robot = ROB_BENCH_ROBOTS "/xy.toml";
  int polylines = 5;
  int segments = 2000;
  int million = 1'000'000;
};

Vector3d written(const Vector3d& p) { return (p * 1e6).array().round() / 1e6; }

/// Legs of 0.2 … 60 mm in all directions of a box of 300 mm.
std::vector<Vector3d> polyline(std::uint64_t seed, int segments) {
  Choice choice(seed);
  const auto share = [&] { return choice.below(1'000'001) / 1e6; };
  std::vector<Vector3d> places{Vector3d::Zero()};
  while (static_cast<int>(places.size()) <= segments) {
    const double length = 0.2 * std::pow(300, share());
    const Vector3d way(2 * share() - 1, 2 * share() - 1, 2 * share() - 1);
    if (way.norm() < 0.1) continue;
    const Vector3d next = written(places.back() + length * way.normalized());
    if (next.cwiseAbs().maxCoeff() <= 150) places.push_back(next);
  }
  return places;
}

/// 20,000 pieces of 0.1 mm: 20 lines of 100 mm to and fro over hills of 2 mm, 1 mm apart.
std::vector<Vector3d> relief() {
  const auto height = [](double x, double y) {
    return 2 * std::sin(x / 5) * std::cos(y / 7) + 0.3 * std::sin(x / 0.9 + y);
  };
  std::vector<Vector3d> places;
  for (int line = 0; line < 20; ++line) {
    for (int k = 0; k <= 1000; ++k) {
      const double x = 0.1 * (line % 2 == 0 ? k : 1000 - k);
      const double y = line;
      places.push_back(written({x, y, height(x, y) - height(0, 0)}));
    }
  }
  return places;
}

/// Runs a path and prints what became of it; false where a bound is not kept.
bool judge(const std::string& name, rob::bench::LookAheadCase c, double jerk,
           const Options& options) {
  const TracedRun run = run_traced(options.rob, c.program(jerk), options.robot);
  if (!run.done()) return fmt::print("| {} | {}\n", name, run.trouble()), false;
  const std::vector<AxisBounds> axes(3,
                                     {-1000, 1000, 1000, kBenchAcceleration,
                                      jerk > 0 ? jerk : std::numeric_limits<double>::infinity()});
  const auto findings = judge_bounds(run.trace, axes);
  const double time = motion_time(run.trace);
  const double deviation = ordered_distance(tool_curve(run.trace, 3), c.path.places, 5 * c.zone);
  const ToppLimits limits{{1000, 1000, 1000}, AxisValues(3, kBenchAcceleration), c.speed};
  const double rounded = time_optimal(rounded_polyline(c.path.places, c.zone), limits).time;
  const TracePeaks peaks = peaks_of(run.trace);
  fmt::print("| {} | {:g} | {:g} | {:g} | {:.3f} | {:.3f} | {:.3f} | {:.1f} | {:.0f} | {:.4f} |\n",
             name, c.speed, c.zone, jerk, time, rounded, time / rounded,
             *std::ranges::max_element(peaks.a), *std::ranges::max_element(peaks.j), deviation);
  for (const std::string& finding : findings) fmt::print("  {}\n", finding);
  std::fflush(stdout);
  return findings.empty() && deviation <= 1.01 * c.zone;
}

bool judge_long(const Options& options) {
  fmt::print(
      "| program | F mm/s | P mm | jerk | Rob s | rounded, time-optimal s | ratio | acceleration | "
      "jerk | deviation |\n|---|---|---|---|---|---|---|---|---|---|\n");
  bool kept = true;
  for (int seed = 1; seed <= options.polylines; ++seed) {
    rob::bench::LookAheadCase c;
    c.path.places = polyline(static_cast<std::uint64_t>(seed), options.segments);
    c.speed = seed % 2 == 0 ? 100 : 400;
    c.zone = seed % 3 == 0 ? 0.5 : 0.1;
    const std::string name = fmt::format("polyline {}", seed);
    for (const double jerk : {0.0, rob::bench::kBenchJerk})
      kept = judge(name, c, jerk, options) && kept;
  }
  rob::bench::LookAheadCase c;
  c.path.places = relief();
  c.speed = 100;
  c.zone = 0.02;
  for (const double jerk : {0.0, rob::bench::kBenchJerk})
    kept = judge("relief, 20,000 pieces", c, jerk, options) && kept;
  return kept;
}

/// kB: the most memory that any program started so far has had.
long most_memory() {
  rusage usage{};
  getrusage(RUSAGE_CHILDREN, &usage);
  return usage.ru_maxrss;
}

/// Pieces of 0.1 mm round and round an octagon, without a trace; kB afterwards, 0 if it failed.
long stream(int segments, const Options& options) {
  const ScratchFolder scratch;
  const std::string program = (scratch.path() / "stream.rob").string();
  std::string turns;
  for (int k = 0; k < 8; ++k) {
    const double angle = k * 3.14159265358979323846 / 4;
    turns += fmt::format(
        "    FOR k = 1 TO 10 DO\n      MOVEL BY ({:.6f}, {:.6f}, 0) AT 100mm/s ZONE 0.02mm\n    "
        "ENDFOR\n",
        0.1 * std::cos(angle), 0.1 * std::sin(angle));
  }
  std::ofstream(program) << fmt::format("FOR n = 1 TO {} DO\n{}ENDFOR\n", segments / 80, turns);
  const auto begin = std::chrono::steady_clock::now();
  const ProcessResult run =
      run_process({options.rob, "run", program, "--robot", options.robot, "--fast", "--json"});
  const double wall =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  if (run.exit_code != 0) return fmt::print("{}\n{}\n", run.err, run.out.substr(0, 300)), 0;
  const auto report = nlohmann::json::parse(run.out);
  fmt::print("{:>9} segments: {:.1f} s of motion in {:.1f} s, {} kB\n", segments / 80 * 80,
             report.value("measured_s", 0.0), wall, most_memory());
  return most_memory();
}

bool judge_memory(const Options& options) {
  const long few = stream(std::max(80, options.million / 100), options);
  const long many = few > 0 ? stream(options.million, options) : 0;
  // [choice] 1 MB is what an allocator may spread; a million segments of one word each take 8 MB.
  const bool kept = many > 0 && many <= few + 1024;
  fmt::print("memory {}\n", kept ? "does not grow" : "GROWS");
  return kept;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  rob::bench::BenchOptions line("Long programs under the look-ahead law");
  line.add("--rob", options.rob, "the program to measure");
  line.add("--robot", options.robot);
  line.add("--polylines", options.polylines, "how many");
  line.add("--segments", options.segments, "of each");
  line.add("--million", options.million, "segments of the stream");
  if (const std::optional<int> exit_code = line.parse(argc, argv)) return *exit_code;
  try {
    const bool memory = judge_memory(options);
    const bool kept = judge_long(options);
    return memory && kept ? 0 : 1;
  } catch (const std::exception& error) {
    fmt::print(stderr, "lookahead_long: {}\n", error.what());
    return 70;
  }
}
