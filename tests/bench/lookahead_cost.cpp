/// What the look-ahead law costs: processor time for a motion to be completed and checked, for its
/// path and corners to be planned, and for a period of the tick (docs/motion.md). A million
/// segments a second need 1 µs each for both of the first.

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "motion/plan/motion_planner.h"
#include "motion/robots/robot_file.h"
#include "motion/robots/robot_library.h"
#include "tests/bench/bench_options.h"
#include "tests/bench/cost.h"
#include "tests/motion/ahead/ahead_run.h"
#include "tests/support/process.h"
#include "tests/support/random_text.h"

namespace {

using namespace rob::motion;
using rob::bench::Cost;
using rob::bench::thread_time;
using rob::test::AheadRun;
using rob::test::Choice;

/// The axes' ways from vertex to vertex: `step` of their ranges in all directions.
class Walk {
 public:
  Walk(const RobotModel& robot, double step) : robot_(robot), choice_(1), step_(step) {}

  MotionRequest next(double speed) {
    MotionRequest request;
    for (int i = 0; i < robot_.axis_count(); ++i) {
      const Axis& axis = robot_.axes[static_cast<std::size_t>(i)];
      const double reach = step_ * (axis.max - axis.min), middle = robot_.start[i];
      const double way = reach * (choice_.below(20'001) / 1e4 - 1);
      double& at = at_[static_cast<std::size_t>(i)];
      at = std::abs(at + way) < 10 * reach ? at + way : at - way;
      request.target[static_cast<std::size_t>(i)] = middle + at;
      request.given |= static_cast<std::uint8_t>(1U << static_cast<unsigned>(i));
    }
    request.pace = MotionRequest::Pace::Share;
    request.pace_value = speed;
    request.zone = MotionRequest::Zone::Length;
    request.zone_value = 1e-4;
    return request;
  }

 private:
  const RobotModel& robot_;
  Choice choice_;
  double step_;
  std::array<double, kMaxJoints> at_{};
};

/// Of the tick, between two turns of the planner.
constexpr int kPeriods = 32;

/// Goes through so many vertices and prints what they took.
void measure(const char* name, RobotModel robot, int vertices, double step) {
  robot.law = Law::LookAhead;
  AheadRun run(robot, 4096);
  MotionPlanner planner(run.robot(), robot.start);
  Walk walk(run.robot(), step);
  const double asking = Cost::asking();
  double completing = 0, planning = 0;
  Cost tick;
  for (int left = vertices; !run.ended() || left > 0;) {
    const double begin = thread_time();
    for (; left > 0 && !run.buffer().full(); --left) {
      const PlanOutcome outcome = planner.plan(walk.next(0.3));
      run.buffer().push(std::get<PlannedSegment>(outcome).segment);
    }
    const double completed = thread_time();
    if (left == 0) run.close();
    run.planner().work();
    completing += completed - begin - asking;
    planning += thread_time() - completed - asking;
    for (int i = 0; i < kPeriods && !(run.ended() && left == 0); ++i)
      tick.measure([&] { run.tick(); });
  }
  const double each = 1e6 / vertices;
  fmt::print("{}: a motion {:.2f} us to be completed and checked, {:.2f} us to be planned\n", name,
             completing * each, planning * each);
  fmt::print("  {:<24} {:>9} {:>13} {:>13}\n{}", "", "periods", "mean", "p99.9", tick.row("tick"));
}

RobotModel from_file(const std::string& file) {
  return parse_robot_file(rob::test::read_whole_file(file), file);
}

}  // namespace

int main(int argc, char** argv) {
  int vertices = 100'000;
  rob::bench::BenchOptions line("Processor time of the look-ahead law");
  line.add("--vertices", vertices, 10, 1'000'000);
  if (const std::optional<int> exit_code = line.parse(argc, argv)) return *exit_code;
  try {
    measure("3 axes", from_file(ROB_BENCH_ROBOTS "/xy.toml"), vertices, 5e-4);
    measure("6 axes", embedded_robot("irb120"), vertices / 10, 5e-4);
  } catch (const std::exception& error) {
    fmt::print(stderr, "lookahead_cost: {}\n", error.what());
    return 70;
  }
}
