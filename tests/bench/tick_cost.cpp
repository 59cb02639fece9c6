/// What a cycle of motion and of the servo costs: processor time of the thread, mean and p99.9,
/// once stepped without a pause (caches warm) and once in real time (caches as others left them).

#include <fmt/format.h>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <limits>
#include <optional>
#include <string>
#include <thread>

#include "runtime/time/clock.h"
#include "runtime/time/periodic_task.h"
#include "runtime/time/real_time.h"
#include "tests/bench/bench_options.h"
#include "tests/bench/cost.h"
#include "tests/support/stepped_run.h"

namespace rob::bench {

namespace {

struct Costs {
  Cost motion;
  Cost servo;
};

void start(test::SteppedRun& parts, double now) {
  parts.task.step(std::numeric_limits<std::int64_t>::max());
  parts.controller.servo().enable(now);
}

void measure_stepped(Costs& costs) {
  test::SteppedRun parts(test::kPublishedProgram);
  runtime::Controller& controller = parts.controller;
  start(parts, 0);
  const auto per_cycle =
      static_cast<std::int64_t>(parts.robot.reference_period / parts.robot.servo_period + 0.5);
  for (std::int64_t k = 0; !controller.motion().over(); ++k) {
    const double now = static_cast<double>(k) * parts.robot.servo_period;
    costs.servo.measure([&] { controller.servo().cycle(now); });
    if (k % per_cycle != 0) continue;
    costs.motion.measure([&] { controller.motion().cycle(k / per_cycle, 0); });
    parts.recorder.drain();
  }
}

void measure_in_real_time(Costs& costs) {
  test::SteppedRun parts(test::kPublishedProgram);
  runtime::Controller& controller = parts.controller;
  std::atomic<bool> servo_stops{false};
  runtime::SystemClock clock(0.02);
  start(parts, clock.now());
  runtime::PeriodicTask servo(clock, parts.robot.servo_period, runtime::kServoPriority,
                              [&](std::int64_t, double now, double) {
                                costs.servo.measure([&] { controller.servo().cycle(now); });
                                return !servo_stops.load(std::memory_order_relaxed);
                              });
  runtime::PeriodicTask motion(
      clock, parts.robot.reference_period, runtime::kMotionPriority,
      [&](std::int64_t number, double, double lateness) {
        costs.motion.measure([&] { controller.motion().cycle(number, lateness); });
        return !controller.motion().over();
      });
  while (!controller.motion().over()) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    parts.recorder.drain();
  }
  motion.join();
  servo_stops = true;
  servo.join();
}

void print(const char* how, Costs& costs) {
  fmt::print("{}{}", costs.motion.row(fmt::format("motion, {}", how).c_str()),
             costs.servo.row(fmt::format("servo, {}", how).c_str()));
}

}  // namespace

}  // namespace rob::bench

int main(int argc, char** argv) {
  int stepped_runs = 100;
  int real_runs = 1;
  rob::bench::BenchOptions line(
      "Processor time of a motion and a servo cycle, over the published program");
  line.add("--stepped-runs", stepped_runs, 1, 250);
  line.add("--real-runs", real_runs, 1, 250, "19.1 s each");
  if (const std::optional<int> exit_code = line.parse(argc, argv)) return *exit_code;
  try {
    rob::bench::Costs stepped;
    rob::bench::Costs real;
    for (int i = 0; i < stepped_runs; ++i) rob::bench::measure_stepped(stepped);
    for (int i = 0; i < real_runs; ++i) rob::bench::measure_in_real_time(real);
    fmt::print("  {:<24} {:>9} {:>13} {:>13}\n", "cycle", "cycles", "mean", "p99.9");
    rob::bench::print("stepped", stepped);
    rob::bench::print("in real time", real);
  } catch (const std::exception& error) {
    fmt::print(stderr, "tick_cost: {}\n", error.what());
    return 1;
  }
  return 0;
}
