/// The experiment of S1, repeated: the published program in real time under the organisation that
/// S1 had first and under Rob's, on the same parts and with the same work added to each cycle.

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "motion/robots/robot_library.h"
#include "runtime/run/foretell.h"
#include "runtime/run/load.h"
#include "tests/bench/bench_options.h"
#include "tests/bench/busy.h"
#include "tests/bench/first_organisation.h"
#include "tests/bench/robs_organisation.h"
#include "tests/support/stepped_run.h"

namespace rob::bench {

namespace {

/// What `rob check` foretells, s.
double theoretical_time() {
  const motion::RobotModel robot = motion::embedded_robot("gantry");
  const auto program = runtime::compile_program("triangle.rob", test::kPublishedProgram, robot);
  return runtime::foretell(program, robot).planned;
}

/// The runs of one organisation. One that ended early, because the processor was away for too long,
/// is told and not counted.
class Series {
 public:
  explicit Series(std::string name) : name_(std::move(name)) {}

  void add(const Outcome& outcome) {
    if (outcome.trouble.empty()) {
      runs_.push_back(outcome);
    } else {
      fmt::print("not counted: a run of {} ended early, {}\n", name_, outcome.trouble);
    }
  }

  std::string row(double theoretical) const {
    if (runs_.empty()) return fmt::format("  {:<12} no run came to its end\n", name_);
    return fmt::format(
        "  {:<12} {:<8} {:>9.2f} s {:>8.2f} s  {:>5.2f}…{:<5.2f} s {:>14} {:>12.1f} ms\n", name_,
        runs_.front().fixed_priority ? "fixed" : "normal", theoretical, mean(&Outcome::measured),
        least(), most(), late(), worst() * 1e3);
  }

 private:
  template <typename T>
  double mean(T Outcome::*figure) const {
    double sum = 0;
    for (const Outcome& run : runs_) sum += static_cast<double>(run.*figure);
    return sum / static_cast<double>(runs_.size());
  }
  double least() const { return std::min_element(runs_.begin(), runs_.end(), faster)->measured; }
  double most() const { return std::max_element(runs_.begin(), runs_.end(), faster)->measured; }
  static bool faster(const Outcome& a, const Outcome& b) { return a.measured < b.measured; }
  std::string late() const {
    return fmt::format("{:.0f} of {:.0f}", mean(&Outcome::late), mean(&Outcome::samples));
  }
  double worst() const {
    double worst = 0;
    for (const Outcome& run : runs_) worst = std::max(worst, run.worst_lateness);
    return worst;
  }

  std::string name_;
  std::vector<Outcome> runs_;
};

struct Options {
  double work_ms = 1.3;  // S1's 21.60 s are 1.3 ms more than 10 ms for each of 1910 references
  int runs = 1;
  int load = 0;
};

void print(const Options& options, const Series& first, const Series& robs) {
  const double theoretical = theoretical_time();
  fmt::print(
      "the published program in real time, {} run(s) of each organisation, on one processor\n"
      "added work: {} ms for each reference, servo cycle and instruction; busy threads: {}\n\n",
      options.runs, options.work_ms, options.load);
  fmt::print("  {:<12} {:<8} {:>11} {:>10}  {:<13} {:>14} {:>15}\n", "organisation", "priority",
             "theoretical", "measured", "from…to", "late samples", "worst lateness");
  fmt::print("{}{}\n", first.row(theoretical), robs.row(theoretical));
  fmt::print(
      "Reference k is meant for the instant k * 10 ms after the start. A sample is late if it is\n"
      "handed out after that instant, or left out. Measured is a mean, lateness the worst.\n");
}

void measure(const Options& options) {
  const double work = options.work_ms * 1e-3;
  Series first("S1's first");
  Series robs("Rob's");
  {
    const Load load(options.load);
    stay_on_one_processor();
    for (int i = 0; i < options.runs; ++i) {
      first.add(FirstOrganisation(work).run());
      robs.add(run_robs_organisation(work));
    }
  }
  print(options, first, robs);
}

}  // namespace

}  // namespace rob::bench

int main(int argc, char** argv) {
  rob::bench::Options options;
  rob::bench::BenchOptions line(
      "The published program in real time, under two organisations of its loops");
  line.add("--work-ms", options.work_ms, 0.0, 4.0, "processor time added to every cycle");
  line.add("--runs", options.runs, 1, 1000, "of each organisation");
  line.add("--load", options.load, 0, 1024, "threads that compute all the while");
  if (const std::optional<int> exit_code = line.parse(argc, argv)) return *exit_code;
  try {
    rob::bench::measure(options);
  } catch (const std::exception& error) {
    fmt::print(stderr, "timing_experiment: {}\n", error.what());
    return 1;
  }
  return 0;
}
