/// Paths and corners whose best time is known, and arms beside themselves: one row each, with Rob's
/// time, the ratio and what is aimed at. A curve's best is its own closed form, d/v + v/a; a
/// corner's with a bound on jerk comes from a linear program over all motions within the zone; an
/// arm's chords are measured beside their MOVEC, its corners beside stops. Exit code 1 where a goal
/// is missed.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <numbers>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/bench/bench_options.h"
#include "tests/support/process.h"
#include "tests/support/random_text.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/topp.h"
#include "tests/support/trace_figures.h"
#include "tests/support/traced_run.h"

namespace {

using rob::test::Choice;

constexpr double kPi = std::numbers::pi;

struct Options {
  std::string rob = ROB_BINARY;
  std::string xy = ROB_BENCH_ROBOTS "/xy.toml";
  int programs = 40;
};

/// One row after the other; how many there are, and how many miss their goal.
class Table {
 public:
  Table() { fmt::print("| work | best known | Rob | ratio | goal |\n|---|---|---|---|---|\n"); }
  void row(const std::string& work, double best, double rob, double goal) {
    const double ratio = rob / best;
    const bool kept = ratio <= goal;
    fmt::print("| {} | {:.3f} | {:.3f} | {}{:.3f}{} | {:.2f} |\n", work, best, rob,
               kept ? "" : "**", ratio, kept ? "" : "**", goal);
    std::fflush(stdout);
    ++rows_;
    missed_ += kept ? 0 : 1;
  }
  int end() const {
    fmt::print("\n{} of {} rows keep their goal.\n", rows_ - missed_, rows_);
    return missed_ == 0 ? 0 : 1;
  }

 private:
  int rows_ = 0;
  int missed_ = 0;
};

/// s of a program's motion, by its trace. Throws std::runtime_error where it does not run.
double seconds(const Options& options, const std::string& program, const std::string& robot) {
  const auto run = rob::test::run_traced(options.rob, program, robot, {"--law", "lookahead"});
  if (!run.done()) throw std::runtime_error(run.trouble());
  return rob::test::motion_time(run.trace);
}

std::string move(double x, double y, const std::string& clauses, int digits = 6) {
  return fmt::format("MOVE({:.{}f}, {:.{}f}, 0) {}\n", x, digits, y, digits, clauses);
}

/// mm: a whole circle in chords, from its lowest place.
std::string circle(double radius, double chord, int digits, const std::string& clauses) {
  const int count = static_cast<int>(std::lround(2 * kPi * radius / chord));
  std::string program;
  for (int k = 1; k <= count; ++k) {
    const double angle = 2 * kPi * k / count;
    program += move(radius * std::sin(angle), radius * (1 - std::cos(angle)), clauses, digits);
  }
  return program;
}

/// 200 mm in steps of 0.05 mm that lie up to 2 µm beside the line.
std::string noisy_line(const std::string& clauses) {
  Choice choice(1);
  std::string program;
  for (int k = 1; k <= 4000; ++k)
    program += move(0.05 * k, k < 4000 ? choice.between(-2000, 2000) * 1e-6 : 0, clauses);
  return program;
}

void tables_without_jerk(const Options& options, Table& table) {
  const double round = 2 * kPi * 50 / 100 + 0.1;
  for (const char* zone : {"0.01", "0.1"})
    table.row(fmt::format("circle r 50, chords 0.05 mm written to 0.01 mm, F 100, P {}", zone),
              round,
              seconds(options, circle(50, 0.05, 2, fmt::format("AT 100mm/s ZONE {}mm", zone)),
                      options.xy),
              1.03);
  for (const double chord : {0.01, 0.005})
    table.row(fmt::format("circle r 20, chords {:g} mm, F 100, P 0.1", chord),
              2 * kPi * 20 / 100 + 0.1,
              seconds(options, circle(20, chord, 6, "AT 100mm/s ZONE 0.1mm"), options.xy), 1.01);
  table.row("straight 200 mm, steps 0.05 mm with 2 um of noise, F 100, P 0.01", 2.1,
            seconds(options, noisy_line("AT 100mm/s ZONE 0.01mm"), options.xy), 1.03);
}

struct Corner {
  double leg;    ///< mm
  double turn;   ///< deg
  double speed;  ///< mm/s
  double jerk;   ///< mm/s³
  double best;   ///< s, of the linear program
  double goal;
};

void corners_with_jerk(const Options& options, Table& table) {
  for (const Corner& c :
       {Corner{5, 90, 100, 1e4, 0.405, 1.10}, Corner{5, 45, 100, 1e4, 0.358, 1.10},
        Corner{5, 20, 100, 1e4, 0.316, 1.10}, Corner{20, 90, 300, 1e4, 0.694, 1.05},
        Corner{20, 90, 300, 1e5, 0.542, 1.05}}) {
    const std::string clauses =
        fmt::format("AT {:g}mm/s JERK {:g}mm/s^3 ZONE 0.1mm", c.speed, c.jerk);
    const double angle = c.turn * kPi / 180;
    table.row(fmt::format("corner {:g} degrees, legs {:g} mm, F {:g}, J {:g}, P 0.1", c.turn, c.leg,
                          c.speed, c.jerk),
              c.best,
              seconds(options,
                      move(c.leg, 0, clauses) +
                          move(c.leg * (1 + std::cos(angle)), c.leg * std::sin(angle), clauses),
                      options.xy),
              c.goal);
  }
}

/// What lies within the reach of all these arms, and how long going there takes.
const char* const kThere = "MOVE BY (10, 20, -60) FINE\n";

std::string chords(double chord) {
  const int count = static_cast<int>(std::lround(40 / chord));
  std::string program;
  double x = 0;
  double y = 0;
  for (int k = 1; k <= count; ++k) {
    const double angle = 1.0 * k / count;
    const double next_x = 40 * std::sin(angle);
    const double next_y = 40 * (1 - std::cos(angle));
    program +=
        fmt::format("MOVEL BY ({:.7f}, {:.7f}, 0) AT 200mm/s ZONE 0.1mm\n", next_x - x, next_y - y);
    x = next_x;
    y = next_y;
  }
  return program;
}

std::string arc() {
  return fmt::format(
      "VAR half = HERE\nhalf.x = half.x + {:.7f}mm\nhalf.y = half.y + {:.7f}mm\n"
      "VAR whole = HERE\nwhole.x = whole.x + {:.7f}mm\nwhole.y = whole.y + {:.7f}mm\n"
      "MOVEC VIA half TO whole AT 200mm/s FINE\n",
      40 * std::sin(0.5), 40 * (1 - std::cos(0.5)), 40 * std::sin(1.0), 40 * (1 - std::cos(1.0)));
}

void chords_on_arms(const Options& options, Table& table) {
  for (const char* robot : {"irb120", "pc104", "ums7", "lwa4p"}) {
    const double there = seconds(options, kThere, robot);
    const double along = seconds(options, kThere + arc(), robot) - there;
    for (const double chord : {2.0, 0.2, 0.02})
      table.row(fmt::format("{}: arc of 40 mm in chords of {:g} mm beside its MOVEC", robot, chord),
                along, seconds(options, kThere + chords(chord), robot) - there, 1.02);
  }
}

/// Six legs between random places within 120 mm.
std::string legs(Choice& choice, const char* command, const std::string& clauses) {
  std::string program;
  int last[3] = {};
  for (int k = 0; k < 6; ++k) {
    int next[3];
    for (int& place : next) place = choice.between(-60, 60);
    program += fmt::format("{} BY ({}, {}, {}) {}\n", command, next[0] - last[0], next[1] - last[1],
                           next[2] - last[2], clauses);
    std::copy(std::begin(next), std::end(next), std::begin(last));
  }
  return program;
}

/// The mean and the greatest ratio of random programs; those that leave the reach do not count.
void corners_on_arms(const Options& options, Table& table) {
  const std::vector<const char*> robots = {"irb120", "pc104", "ums7", "lwa4p"};
  for (const char* command : {"MOVE", "MOVEL"}) {
    for (const char* zone : {"1mm", "5mm"}) {
      double sum = 0;
      double most = 0;
      int count = 0;
      for (int k = 0; k < options.programs; ++k) {
        const auto program = [&](const std::string& corner) {
          Choice choice(static_cast<std::uint64_t>(k) + 1);
          const std::string at = choice.percent(50) ? "AT 250mm/s " : "";
          return kThere + legs(choice, command, at + corner);
        };
        const std::string robot = robots[static_cast<std::size_t>(k) % robots.size()];
        try {
          const double there = seconds(options, kThere, robot);
          const double ratio =
              (seconds(options, program(std::string("ZONE ") + zone), robot) - there) /
              (seconds(options, program("FINE"), robot) - there);
          sum += ratio;
          most = std::max(most, ratio);
          ++count;
        } catch (const std::runtime_error&) {
          continue;
        }
      }
      const std::string what =
          fmt::format("{} of six legs, ZONE {}, beside FINE ({} programs)", command, zone, count);
      table.row("arms: mean of " + what, 1, sum / count, zone[0] == '5' ? 0.85 : 1.0);
      table.row("arms: greatest of " + what, 1, most, 1.0005);
    }
  }
}

/// The IRB 120 without bounds on jerk, in `folder`.
std::string without_jerk(const rob::test::ScratchFolder& folder, rob::test::ToppLimits& limits) {
  std::istringstream text(
      rob::test::read_whole_file(ROB_BENCH_ROBOTS "/../../motion/robots/irb120.toml"));
  const std::string name = (folder.path() / "irb120.toml").string();
  std::ofstream file(name);
  for (std::string row; std::getline(text, row);) {
    const auto value = [&] { return std::stod(row.substr(row.find('"') + 1)); };
    if (row.starts_with("j_max")) continue;
    if (row.starts_with("v_max")) limits.v.push_back(value());
    if (row.starts_with("a_max")) limits.a.push_back(value());
    file << row << '\n';
  }
  return name;
}

/// MOVES through three to nine random places of the joints.
std::string joint_spline(Choice& choice) {
  constexpr int kMost[6] = {150, 70, 60, 140, 100, 200};  // deg
  constexpr int kStep[6] = {40, 25, 25, 60, 50, 90};
  int place[6] = {0, 0, 0, 0, 30, 0};
  const int count = choice.between(3, 9);
  std::string program = "MOVES VIA ";
  for (int k = 0; k < count; ++k) {
    program += k == 0 ? "JOINTS(" : k + 1 < count ? ", JOINTS(" : " TO JOINTS(";
    for (std::size_t i = 0; i < 6; ++i) {
      const int next = place[i] + choice.between(-kStep[i], kStep[i]);
      place[i] = std::clamp(next, -kMost[i], kMost[i]);
      program += fmt::format("{}{}deg", i == 0 ? "" : ", ", place[i]);
    }
    program += ")";
  }
  return program + " FINE\n";
}

/// Beside the time-optimal motion along the path that was planned, both bounded by speed and
/// acceleration.
void splines_of_six_axes(const Options& options, Table& table) {
  const rob::test::ScratchFolder folder;
  rob::test::ToppLimits limits;
  const std::string robot = without_jerk(folder, limits);
  const std::string file = (folder.path() / "spline.rob").string();
  const std::string path = (folder.path() / "path.csv").string();
  double sum = 0;
  double most = 0;
  constexpr int kSplines = 24;
  for (int seed = 1; seed <= kSplines; ++seed) {
    Choice choice(static_cast<std::uint64_t>(seed));
    const std::string program = joint_spline(choice);
    std::ofstream(file) << program;
    const auto check = rob::test::run_process(
        {options.rob, "check", file, "--robot", robot, "--law", "lookahead", "--path", path});
    if (check.exit_code != 0) throw std::runtime_error(check.err);
    const auto nodes = rob::test::parse_topp_path(rob::test::read_whole_file(path));
    const double best = rob::test::time_optimal(nodes, limits, 20'000).time;
    const double ratio = seconds(options, program, robot) / best;
    sum += ratio;
    most = std::max(most, ratio);
  }
  table.row(fmt::format("mean of {} six-axis splines, no jerk, beside the time-optimal", kSplines),
            1, sum / kSplines, 1.01);
  table.row("the greatest of them", 1, most, 1.01);
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  rob::bench::BenchOptions line(
      "Rob's motion beside the best that is known; in bold what misses its goal");
  line.add("--rob", options.rob, "the program to measure");
  line.add("--programs", options.programs, 1, 1000,
           "random programs for each row of an arm's corners");
  if (const std::optional<int> exit_code = line.parse(argc, argv)) return *exit_code;
  try {
    Table table;
    tables_without_jerk(options, table);
    corners_with_jerk(options, table);
    chords_on_arms(options, table);
    corners_on_arms(options, table);
    splines_of_six_axes(options, table);
    return table.end();
  } catch (const std::exception& error) {
    fmt::print(stderr, "motion_table: {}\n", error.what());
    return 70;
  }
}
