#include <atomic>
#include <chrono>
#include <exception>
#include <optional>
#include <thread>

#include "motion/space/cycle_instant.h"
#include "runtime/control/execution.h"
#include "runtime/time/clock.h"
#include "runtime/time/periodic_task.h"
#include "runtime/time/real_time.h"

namespace rob::runtime {

namespace {

using namespace std::chrono_literals;

constexpr double kLead = 0.02;                  // s [choice] for every thread to wake up
constexpr std::int64_t kHeadStart = 1'000'000;  // instructions before the clock starts
constexpr std::int64_t kSlice = 10'000;         // instructions between looks at the stop flag
constexpr auto kProgramPause = 1ms;             // [choice] a tenth of a reference period
constexpr double kPathPeriod = 0.002;           // s [choice] of 50 ms that it may be late at most
constexpr auto kReportPause = 10ms;             // [choice] what an eye does not notice

/// The program's thread: sleeps while the program has to wait. It works far ahead of the motion,
/// so that its pauses shape nothing.
/// TASKs run on until the motion is over.
void run_program(ProgramTask& program, ProgramTask::State state,
                 const std::atomic<bool>& stopping) {
  while (!stopping.load(std::memory_order_relaxed)) {
    if (state != ProgramTask::State::Over) state = program.step(kSlice);
    state = program.run_tasks(state);
    if (state == ProgramTask::State::Over && !program.has_tasks()) return;
    if (state != ProgramTask::State::Busy) std::this_thread::sleep_for(kProgramPause);
  }
}

/// Reports until the robot stands for good. If the reporting itself fails, the robot is stopped on
/// its path first; what went wrong is returned.
std::exception_ptr watch_over(Controller& controller, std::atomic<bool>& program_stops,
                              const Attend& attend) {
  std::exception_ptr trouble;
  while (!controller.motion().over()) {
    std::this_thread::sleep_for(kReportPause);
    try {
      if (!trouble) attend();
    } catch (...) {
      trouble = std::current_exception();
      controller.request_hold();
    }
    if (controller.holding()) program_stops = true;
  }
  return trouble;
}

}  // namespace

Timing run_threaded(Controller& controller, ProgramTask& program, const Attend& attend) {
  const motion::RobotModel& robot = controller.robot();
  std::atomic<bool> program_stops{false};
  std::atomic<bool> servo_stops{false};
  std::optional<double> first;  // when the first cycle began, s
  double drift = 0;

  controller.servo().enable(-kLead);  // where the clock will begin
  controller.motion().prepare(0);
  const auto program_state = program.step(kHeadStart);
  controller.plan_path();
  SystemClock clock;
  StartLine line(3);
  PeriodicTask servo(
      clock, robot.servo_period, kServoPriority,
      [&](std::int64_t, double now, double) {
        controller.servo().cycle(now);
        return !servo_stops.load(std::memory_order_relaxed);
      },
      &line);
  PeriodicTask motion(
      clock, robot.reference_period, kMotionPriority,
      [&](std::int64_t number, double now, double lateness) {
        if (!first) first = now;
        drift = now - *first - motion::cycle_instant(number, robot.reference_period);
        controller.motion().cycle(number, lateness);
        return !controller.motion().over();
      },
      &line);
  PeriodicTask path(
      clock, kPathPeriod, kPathPriority,
      [&](std::int64_t, double, double) {
        controller.plan_path();
        return !servo_stops.load(std::memory_order_relaxed);
      },
      &line);
  line.wait_until_ready();
  clock = SystemClock(kLead);
  line.go();
  std::thread program_thread([&] { run_program(program, program_state, program_stops); });

  const std::exception_ptr trouble = watch_over(controller, program_stops, attend);
  program_stops = true;
  servo_stops = true;
  program_thread.join();
  motion.join();
  path.join();
  servo.join();
  if (trouble) std::rethrow_exception(trouble);
  attend();
  return {motion.punctuality().missed, motion.punctuality().worst_lateness, drift, false};
}

}  // namespace rob::runtime
