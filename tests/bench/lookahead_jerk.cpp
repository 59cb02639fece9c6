/// The look-ahead law where the jerk is low: times beside those of exact stops by third-order
/// profiles, and what the traces say of acceleration, jerk and deviation (docs/motion.md). Exit
/// code 1 where a bound is not kept.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "tests/bench/bench_options.h"
#include "tests/bench/lookahead_cases.h"
#include "tests/support/ordered_distance.h"
#include "tests/support/random_text.h"
#include "tests/support/trace_figures.h"
#include "tests/support/traced_run.h"

namespace {

using namespace rob::test;
using Eigen::Vector3d;
using rob::bench::kBenchAcceleration;
using rob::bench::LookAheadCase;
using Places = std::vector<Vector3d>;

struct Options {
  std::string rob = ROB_BINARY;
  std::string robot = ROB_BENCH_ROBOTS "/xy.toml";
  std::string only;
};

Vector3d written(const Vector3d& p) { return (p * 1e6).array().round() / 1e6; }

Places circle(int chords) {
  Places places;
  for (int k = 0; k <= chords; ++k) {
    const double angle = 2 * std::numbers::pi * k / chords;
    places.push_back(written(50 * Vector3d(std::sin(angle), 1 - std::cos(angle), 0)));
  }
  return places;
}

/// 0.2 mm pieces of a wave of 5 mm, 100 mm long.
Places wave() {
  Places places;
  for (int k = 0; k <= 500; ++k)
    places.push_back(written({0.2 * k, 5 * (1 - std::cos(0.2 * k / 10)), 0}));
  return places;
}

Places straight() {
  Places places;
  for (int k = 0; k <= 5000; ++k) places.push_back(written({0.02 * k, 0, 0}));
  return places;
}

Places hatch() {
  Places places;
  for (int line = 0; line < 20; ++line) {
    places.emplace_back(line % 2 == 0 ? 0 : 50, line, 0);
    places.emplace_back(line % 2 == 0 ? 50 : 0, line, 0);
  }
  return places;
}

/// Legs of least … most mm that turn by at most `turn`, rad.
Places polyline(std::uint64_t seed, int legs, double least, double most, double turn) {
  Choice choice(seed);
  const auto share = [&] { return choice.below(1'000'001) / 1e6; };
  Places places{Vector3d::Zero()};
  double heading = 0;
  while (static_cast<int>(places.size()) <= legs) {
    const double length = least * std::pow(most / least, share());
    heading += turn * (2 * share() - 1);
    const Vector3d way(std::cos(heading), std::sin(heading), 0);
    const Vector3d next = written(places.back() + length * way);
    if (next.cwiseAbs().maxCoeff() <= 150) places.push_back(next);
  }
  return places;
}

std::vector<LookAheadCase> cases() {
  std::vector<LookAheadCase> made;
  const auto add = [&](const char* name, Places places, double speed) {
    LookAheadCase c;
    c.name = name;
    c.robot = "xy.toml";
    c.path.places = std::move(places);
    c.speed = speed;
    c.zone = 0.1;
    made.push_back(c);
  };
  add("circle of 1000 chords", circle(1000), 100);
  add("circle of 100 chords", circle(100), 100);
  add("wave of 500 pieces", wave(), 100);
  add("gentle legs of 1 mm", polyline(1, 300, 1, 1, 0.1), 100);
  add("straight, 0.02 mm pieces", straight(), 100);
  add("triangle", {{0, 0, 0}, {100, 0, 0}, {50, 86, 0}, {0, 0, 0}}, 100);
  add("triangle", {{0, 0, 0}, {100, 0, 0}, {50, 86, 0}, {0, 0, 0}}, 300);
  add("hatch of 20 lines", hatch(), 100);
  add("hatch of 20 lines", hatch(), 300);
  add("random legs of 0.2 to 60 mm", polyline(2, 100, 0.2, 60, std::numbers::pi), 100);
  add("random legs of 1 to 60 mm, 45 degrees", polyline(3, 100, 1, 60, std::numbers::pi / 4), 100);
  return made;
}

/// s from rest to rest over d with speed v, acceleration a and jerk j of the way (motion.md).
double third_order(double d, double v, double a, double j) {
  const double change = v >= a * a / j ? v / a + a / j : 2 * std::sqrt(v / j);
  if (d >= v * change) return d / v + change;
  if (d >= 2 * a * a * a / (j * j)) return a / j + std::sqrt(a * a / (j * j) + 4 * d / a);
  return std::cbrt(32 * d / j);
}

/// The same from place to place, with each axis within its limits.
double with_stops(const LookAheadCase& c, double jerk) {
  double time = 0;
  for (std::size_t k = 1; k < c.path.places.size(); ++k) {
    const Vector3d way = c.path.places[k] - c.path.places[k - 1];
    const double share = way.cwiseAbs().maxCoeff() / way.norm();
    time += third_order(way.norm(), std::min(c.speed, 1000 / share), kBenchAcceleration / share,
                        jerk / share);
  }
  return time;
}

bool judge(const LookAheadCase& c, double jerk, const Options& options) {
  fmt::print("| {} | {:g} | {:g} | ", c.name, c.speed, jerk);
  const TracedRun run = run_traced(options.rob, c.program(jerk), options.robot);
  if (!run.done()) return fmt::print("{} |\n", run.trouble()), false;
  const TracePeaks peaks = peaks_of(run.trace);
  const double acceleration = *std::ranges::max_element(peaks.a);
  const double peak_jerk = *std::ranges::max_element(peaks.j);
  const double deviation =
      ordered_distance(tool_curve(run.trace, 3), c.path.places, std::max(3.0, 20 * c.zone));
  fmt::print("{:.3f} | {:.3f} | {:.0f} | {:.0f} | {:.4f} |\n", motion_time(run.trace),
             with_stops(c, jerk), acceleration, peak_jerk, deviation);
  std::fflush(stdout);
  return acceleration <= 1.02 * kBenchAcceleration && peak_jerk <= 1.1 * jerk &&
         deviation <= 1.01 * c.zone;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  rob::bench::BenchOptions line("The look-ahead law where the jerk is low");
  line.add("--rob", options.rob, "the program to measure");
  line.add("--robot", options.robot);
  line.add("--only", options.only, "cases whose name holds this");
  if (const std::optional<int> exit_code = line.parse(argc, argv)) return *exit_code;
  try {
    fmt::print(
        "ZONE 0.1mm\n\n| program | F mm/s | jerk | Rob s | stops s | acceleration | jerk | "
        "deviation |\n|---|---|---|---|---|---|---|---|\n");
    bool kept = true;
    for (const LookAheadCase& c : cases()) {
      if (c.name.find(options.only) == std::string::npos) continue;
      for (const double jerk : {1e5, 3e4, 1e4, 3e3, 1e3}) kept = judge(c, jerk, options) && kept;
    }
    return kept ? 0 : 1;
  } catch (const std::exception& error) {
    fmt::print(stderr, "lookahead_jerk: {}\n", error.what());
    return 70;
  }
}
