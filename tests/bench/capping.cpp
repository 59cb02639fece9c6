/// examples/20_capping.rob in many simulated cells, judged by what really happens at the cap
/// (docs/performance.md). Exit code 1 where a bound is not kept.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "tests/bench/bench_options.h"
#include "tests/bench/cell_runs.h"

namespace {

using namespace rob::bench;
using rob::motion::RobotModel;

constexpr double kForce = 10;      // N, what the program presses with
constexpr double kBand = 1.5;      // N
constexpr double kBandByHand = 4;  // N [choice] what gains for the stiffest cell leave in others
constexpr double kMost = 50;       // N: S4, more wears the cap
constexpr double kLeastTorque = 0.97;  // Nm
constexpr double kMostTorque = 1.15;   // Nm
constexpr double kSettled = 0.5;       // s after first contact
constexpr double kMean = 0.02;         // s
constexpr double kContact = 1;         // N [choice] a tenth of the set-point
constexpr double kTurns = 0.01;        // rad/s [choice] a tenth of the slowest turning

struct Verdict {
  bool done = false;
  double band = kBand;
  double least = kForce;  // N, of the force while it is judged
  double most = kForce;
  double first_band = 0;  // s from first contact to the last instant outside of the band
  double peak = 0;        // N
  double torque = 0;      // Nm, the greatest mean of 20 ms
  int grips = 0;
  std::string said;

  bool kept() const {
    return done && least >= kForce - band && most <= kForce + band && peak <= kMost &&
           torque >= kLeastTorque && torque <= kMostTorque;
  }
};

/// The greatest mean of |torque| over 20 ms.
double greatest_mean(const std::vector<Instant>& instants, double period) {
  const auto count = static_cast<std::size_t>(std::lround(kMean / period));
  double sum = 0;
  double most = 0;
  for (std::size_t i = 0; i < instants.size(); ++i) {
    sum += std::abs(instants[i].torque);
    if (i < count) continue;
    sum -= std::abs(instants[i - count].torque);
    most = std::max(most, sum / static_cast<double>(count));
  }
  return most;
}

void judge_force(const std::vector<Instant>& instants, Verdict& verdict) {
  double contact = -1;  // s, since when; before 0: not yet in this grip
  for (std::size_t i = 1; i < instants.size(); ++i) {
    const Instant& now = instants[i];
    const Instant& before = instants[i - 1];
    const double up = now.force.z();
    verdict.peak = std::max(verdict.peak, now.force.norm());
    if (!now.held) contact = -1;
    if (now.held && !before.held) ++verdict.grips;
    if (!now.held || now.time <= before.time) continue;
    if (contact < 0 && up > kContact) contact = now.time;
    const bool turns = std::abs(now.turned - before.turned) > kTurns * (now.time - before.time);
    if (contact < 0 || !turns) continue;
    if (std::abs(up - kForce) > verdict.band)
      verdict.first_band = std::max(verdict.first_band, now.time - contact);
    if (now.time < contact + kSettled) continue;
    verdict.least = std::min(verdict.least, up);
    verdict.most = std::max(verdict.most, up);
  }
}

Verdict judge(const CellRun& run, const RobotModel& robot, double band) {
  Verdict verdict;
  verdict.band = band;
  verdict.said = said_by(run);
  verdict.done =
      run.result.exit_code == rob::runtime::ExitCode::Done && verdict.said.starts_with("tight");
  judge_force(run.instants, verdict);
  verdict.torque = greatest_mean(run.instants, robot.servo_period);
  return verdict;
}

void print(const std::string& name, const RobotModel& robot, const Verdict& v) {
  const auto& cell = *robot.cell;
  fmt::print(
      "| {} | {:.0f} | {:.2f} | {:.1f} | {:.2f} | {:.2f} | {:.2f} | {:.2f} | {:.2f} | {:.1f} "
      "| {:.3f} | {} | {} |\n",
      name, cell.contact.stiffness / 1e3, cell.contact.friction, cell.sensor.delay * 1e3,
      cell.sensor.force_noise, cell.cap.slip_torque, v.first_band, v.least, v.most, v.peak,
      v.torque, v.grips, v.kept() ? "" : "NOT KEPT: " + v.said);
  std::fflush(stdout);
}

/// The worst figures of all.
void widen(Verdict& all, const Verdict& one, double& least_torque) {
  all.least = std::min(all.least, one.least);
  all.most = std::max(all.most, one.most);
  all.first_band = std::max(all.first_band, one.first_band);
  all.peak = std::max(all.peak, one.peak);
  all.torque = std::max(all.torque, one.torque);
  least_torque = std::min(least_torque, one.torque);
}

int run_cells(const CellBench& bench) {
  const std::string source = bench.source();
  const double band = bench.by_hand ? kBandByHand : kBand;
  Verdict all;
  double least_torque = 10;
  std::vector<int> grips(9, 0);
  int kept = 0;
  fmt::print(
      "| seed | k N/mm | friction | delay ms | noise N | slip Nm | in the band after s | least N | "
      "most N | peak N | torque Nm | grips | "
      "|\n|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  for (int i = 0; i < bench.cells; ++i) {
    const RobotModel robot = bench.robot(i);
    const Verdict verdict = judge(run_in_cell(bench.program, source, robot), robot, band);
    if (bench.every || !verdict.kept()) print(std::to_string(bench.seed(i)), robot, verdict);
    widen(all, verdict, least_torque);
    ++grips[static_cast<std::size_t>(std::min(verdict.grips, 8))];
    if (verdict.kept()) ++kept;
  }
  fmt::print(
      "{} of {} cells kept: force {:.2f} … {:.2f} N from {} s after contact (in the band "
      "after {:.2f} s), at most {:.1f} N; torque at the end {:.3f} … {:.3f} Nm; grips:",
      kept, bench.cells, all.least, all.most, kSettled, all.first_band, all.peak, least_torque,
      all.torque);
  for (std::size_t n = 0; n < grips.size(); ++n)
    if (grips[n] > 0) fmt::print(" {} in {} cells", n, grips[n]);
  fmt::print("\n");
  return kept == bench.cells ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  CellBench bench{.program = ROB_SOURCE_DIR "/examples/20_capping.rob", .cells = 200};
  rob::bench::BenchOptions line("Capping in many simulated cells");
  bench.add_to(line);
  if (const std::optional<int> exit_code = line.parse(argc, argv)) return *exit_code;
  try {
    return run_cells(bench);
  } catch (const std::exception& error) {
    fmt::print(stderr, "capping: {}\n", error.what());
    return 70;
  }
}
