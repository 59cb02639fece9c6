#include "tests/bench/robs_organisation.h"

#include <sched.h>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <limits>
#include <optional>
#include <thread>

#include "runtime/run/run_result.h"
#include "runtime/time/clock.h"
#include "runtime/time/periodic_task.h"
#include "runtime/time/real_time.h"
#include "tests/bench/busy.h"
#include "tests/support/stepped_run.h"

namespace rob::bench {

namespace {

constexpr double kLead = 0.02;  // s [choice] for both threads to wake up
constexpr std::chrono::milliseconds kReportPause(10);

}  // namespace

Outcome run_robs_organisation(double work) {
  test::SteppedRun parts(test::kPublishedProgram);
  runtime::Controller& controller = parts.controller;
  SampleCount samples(parts.robot.reference_period, 1);  // reference 0 is where the robot stands
  std::optional<double> first;
  double measured = 0;
  bool fixed_priority = false;
  std::atomic<bool> servo_stops{false};

  // The buffer holds more than this program: it is decoded before the clock starts.
  parts.task.step(std::numeric_limits<std::int64_t>::max());
  runtime::SystemClock clock;
  runtime::StartLine line(2);
  runtime::PeriodicTask servo(
      clock, parts.robot.servo_period, runtime::kServoPriority,
      [&](std::int64_t, double, double) {
        work_for(work);
        controller.servo().cycle(clock.now());
        return !servo_stops.load(std::memory_order_relaxed);
      },
      &line);
  runtime::PeriodicTask motion(
      clock, parts.robot.reference_period, runtime::kMotionPriority,
      [&](std::int64_t number, double now, double lateness) {
        if (!first) {
          first = now;
          fixed_priority = sched_getscheduler(0) == SCHED_FIFO;
        }
        measured = now - *first;
        work_for(work);
        controller.motion().cycle(number, lateness);
        if (controller.motion().over()) return false;
        samples.hand_out(number + 1, clock.now());
        return true;
      },
      &line);
  line.wait_until_ready();
  clock = runtime::SystemClock(kLead);
  controller.servo().enable(clock.now());
  line.go();
  while (!controller.motion().over()) {
    std::this_thread::sleep_for(kReportPause);
    parts.recorder.drain();
  }
  motion.join();
  servo_stops = true;
  servo.join();
  parts.recorder.drain();
  Outcome outcome = samples.outcome(measured);
  outcome.fixed_priority = fixed_priority;
  const runtime::RunResult result = parts.recorder.finish();
  if (result.error) outcome.trouble = result.error->message;
  return outcome;
}

}  // namespace rob::bench
