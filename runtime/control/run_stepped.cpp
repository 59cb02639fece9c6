#include "motion/space/cycle_instant.h"
#include "runtime/control/execution.h"
#include "runtime/control/standstill.h"
#include "runtime/time/clock.h"

namespace rob::runtime {

namespace {

/// So many instructions without a wait also take one cycle of virtual time (docs/language.md).
constexpr std::int64_t kInstructionsPerCycle = 1'000'000;

/// Instants of both tasks that differ by less are the same one, s.
constexpr double kSameInstant = 1e-9;

/// The servo's cycles up to the instant of motion cycle `cycle`, that one's own included; `next` is
/// the first that is still to come. Neither period need be a multiple of the other.
void servo_cycles(Controller& controller, VirtualClock& clock, std::int64_t cycle,
                  std::int64_t& next) {
  const motion::RobotModel& robot = controller.robot();
  const double until = motion::cycle_instant(cycle, robot.reference_period);
  for (;; ++next) {
    const double instant = motion::cycle_instant(next, robot.servo_period);
    if (instant > until + kSameInstant) break;
    clock.sleep_until(instant);
    controller.servo().cycle(clock.now());
  }
  clock.sleep_until(until);
}

}  // namespace

Timing run_stepped(Controller& controller, ProgramTask& program, const RunLimits& limits,
                   const Attend& attend) {
  VirtualClock clock;
  std::int64_t next_servo = 0;
  Timing timing;
  Standstill standstill(controller.robot());

  controller.servo().enable(clock.now());
  controller.motion().prepare(clock.now());
  auto program_state = program.step(kInstructionsPerCycle);
  controller.plan_path();
  for (std::int64_t cycle = 0;; ++cycle) {
    servo_cycles(controller, clock, cycle, next_servo);
    controller.motion().cycle(cycle, 0);
    attend();
    if (controller.motion().over()) {
      servo_cycles(controller, clock, cycle + 1, next_servo);  // an output due last is written, too
      return timing;
    }
    if (controller.holding()) {  // the program has lost its turn
      controller.plan_path();
      continue;
    }
    if (program_state != ProgramTask::State::Over) {
      program_state = program.step(kInstructionsPerCycle);
    }
    program_state = program.run_tasks(program_state);
    controller.plan_path();
    timing.waits_for_ever = limits.standstill && standstill.is_for_ever(controller, clock.now());
    if (clock.now() >= limits.virtual_time || program.executed() >= limits.instructions ||
        timing.waits_for_ever) {
      timing.gave_up = true;
      controller.channels().safe.clear();  // nothing has gone wrong
      controller.request_hold();
    }
  }
}

}  // namespace rob::runtime
