/// examples/21_hole_search.rob in many simulated cells, judged by what really happens at the tube
/// (docs/performance.md). Exit code 1 where a cell does not end as it has to.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "tests/bench/bench_options.h"
#include "tests/bench/cell_runs.h"

namespace {

using namespace rob::bench;
using rob::motion::RackData;
using rob::motion::RobotModel;

// Side errors, m: up to the first every hole has to be found, from the second on none can be. The
// spiral begins at 4 mm, and the tube falls where it is less than the clearance and the edge's
// chamfer beside the hole, 1.05 mm; it lags behind by what friction bends the tool, 0.1 mm at most.
constexpr double kReach = 4e-3;
constexpr double kBeyond = 5.2e-3;
constexpr double kContact = 1;  // N [choice] ten times what noise makes
// m below the face of the rack from which on the tube is in. [choice] half of the clearance
constexpr double kSunk = 0.5e-3;

struct Verdict {
  enum class End { Found, NotFound, Overshot, Other };

  End end = End::Other;
  double error = 0;    // m, of the hole
  double search = -1;  // s from the first contact until the tube is in; before 0: never
  double across = 0;   // N, the greatest along the surface
  double down = 0;     // N, the greatest across it
  std::string said;

  bool kept() const {
    if (error <= kReach) return end == End::Found;
    return end == End::NotFound || (end != End::Other && error < kBeyond);
  }
};

/// The rack whose hole is searched for: the one that is not at its place.
RackData& searched(RobotModel& robot) {
  return *std::find_if(robot.cell->racks.begin(), robot.cell->racks.end(),
                       [](const RackData& rack) { return !rack.error.isZero(0); });
}

std::size_t hole_number(const RobotModel& robot, const RackData& searched) {
  int number = 0;
  for (const RackData& rack : robot.cell->racks) {
    if (&rack == &searched) break;
    number += rack.columns * rack.rows;
  }
  return static_cast<std::size_t>(number);
}

bool over(const RackData& rack, const Eigen::Vector3d& place) {
  const Eigen::Vector2d middle(rack.x, rack.y);
  return (place.head<2>() - middle).cwiseAbs().maxCoeff() < rack.pitch / 2;
}

void judge_search(const std::vector<Instant>& instants, const RackData& rack, Verdict& verdict) {
  double contact = -1;  // s, the first
  for (const Instant& now : instants) {
    if (!now.held || !over(rack, now.foot)) continue;
    verdict.across = std::max(verdict.across, now.force.head<2>().norm());
    verdict.down = std::max(verdict.down, std::abs(now.force.z()));
    if (contact < 0 && now.force.z() > kContact) contact = now.time;
    const bool in = now.foot.z() < rack.face - kSunk;
    if (in && verdict.search < 0) verdict.search = contact < 0 ? 0 : now.time - contact;
  }
}

/// Found: the tube stands in the hole. Not found, and overshot (the force has fallen, but it does
/// not go in): it is back where it was taken from, unhurt.
Verdict::End end_of(const CellRun& run, std::size_t hole, const std::string& said) {
  using End = Verdict::End;
  if (run.result.exit_code != rob::runtime::ExitCode::Done || run.end.dropped > 0)
    return End::Other;
  if (run.end.occupied[hole] && said == "the tube is in the hole") return End::Found;
  if (!run.end.occupied[0] || run.end.occupied[hole]) return End::Other;
  if (said.starts_with("not inserted: hole not found")) return End::NotFound;
  return said.starts_with("not inserted: jammed") ? End::Overshot : End::Other;
}

Verdict judge(const std::string& file, const std::string& source, RobotModel& robot) {
  RackData& rack = searched(robot);
  const CellRun run = run_in_cell(file, source, robot);
  Verdict verdict;
  verdict.error = rack.error.norm();
  verdict.said = said_by(run);
  verdict.end = end_of(run, hole_number(robot, rack), verdict.said);
  judge_search(run.instants, rack, verdict);
  return verdict;
}

void print(std::uint64_t seed, const RobotModel& robot, const Verdict& v) {
  const auto& cell = *robot.cell;
  fmt::print(
      "| {} | {:.0f} | {:.2f} | {:.1f} | {:.2f} | {:.2f} | {:.1f} | {:.1f} | {:.1f} | {} |\n", seed,
      cell.contact.stiffness / 1e3, cell.contact.friction, cell.sensor.delay * 1e3,
      cell.sensor.force_noise, v.error * 1e3, v.search, v.down, v.across, v.said);
  std::fflush(stdout);
}

struct Bench : CellBench {
  std::string pace = "1";  // mm/s
  double beside = 0;       // mm; 0: as the cell is drawn

  std::string edited_source() const {
    return edited(source(), "CONST pace = 1mm/s", "CONST pace = " + pace + "mm/s");
  }
};

/// The cell number `i`, its hole as it was asked for.
RobotModel robot_of(const Bench& bench, int i) {
  RobotModel robot = bench.robot(i);
  Eigen::Vector2d& error = searched(robot).error;
  if (bench.beside > 0) error *= bench.beside * 1e-3 / error.norm();
  return robot;
}

int run_cells(const Bench& bench) {
  const std::string source = bench.edited_source();
  std::array<int, 4> ends{};
  std::vector<double> searches;
  double down = 0;
  double across = 0;
  int kept = 0;
  fmt::print(
      "| seed | k N/mm | friction | delay ms | noise N | beside mm | found after s | down N | "
      "across N | |\n|---|---|---|---|---|---|---|---|---|---|\n");
  for (int i = 0; i < bench.cells; ++i) {
    RobotModel robot = robot_of(bench, i);
    const Verdict verdict = judge(bench.program, source, robot);
    if (bench.every || !verdict.kept()) print(bench.seed(i), robot, verdict);
    ++ends[static_cast<std::size_t>(verdict.end)];
    if (verdict.end == Verdict::End::Found) searches.push_back(verdict.search);
    down = std::max(down, verdict.down);
    across = std::max(across, verdict.across);
    if (verdict.kept()) ++kept;
  }
  fmt::print("{} mm/s: found in {} of {} cells, not found in {}, overshot in {}, other in {}; ",
             bench.pace, ends[0], bench.cells, ends[1], ends[2], ends[3]);
  std::sort(searches.begin(), searches.end());
  if (!searches.empty())
    fmt::print("searched for {:.1f} … {:.1f} s, half within {:.1f} s; ", searches.front(),
               searches.back(), searches[searches.size() / 2]);
  fmt::print("at most {:.1f} N down and {:.1f} N across\n", down, across);
  return kept == bench.cells ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  Bench bench;
  bench.program = ROB_SOURCE_DIR "/examples/21_hole_search.rob";
  bench.cells = 1000;
  rob::bench::BenchOptions line("The search for a hole in many simulated cells");
  bench.add_to(line);
  line.add("--pace", bench.pace, "of the search, mm/s");
  line.add("--beside", bench.beside, "mm that each hole is beside its place");
  if (const std::optional<int> exit_code = line.parse(argc, argv)) return *exit_code;
  try {
    return run_cells(bench);
  } catch (const std::exception& error) {
    fmt::print(stderr, "hole_search: {}\n", error.what());
    return 70;
  }
}
