#include "motion/space/cycle_instant.h"
#include "runtime/control/execution.h"
#include "runtime/control/standstill.h"
#include "runtime/time/clock.h"

namespace rob::runtime {

namespace {

/// So many instructions without a wait also take one cycle of virtual time (docs/language.md).
constexpr std::int64_t kInstructionsPerCycle = 1'000'000;

/// The servo's cycles after the motion cycle before this one, up to and with `cycle`'s own.
void servo_cycles(Controller& controller, VirtualClock& clock, std::int64_t cycle,
                  std::int64_t per_cycle) {
  const std::int64_t first = cycle == 0 ? 0 : (cycle - 1) * per_cycle + 1;
  for (std::int64_t k = first; k <= cycle * per_cycle; ++k) {
    clock.sleep_until(motion::cycle_instant(k, controller.robot().servo_period));
    controller.servo().cycle(clock.now());
  }
}

}  // namespace

Timing run_stepped(Controller& controller, ProgramTask& program, const RunLimits& limits,
                   const Attend& attend) {
  const motion::RobotModel& robot = controller.robot();
  const auto per_cycle =
      static_cast<std::int64_t>(robot.reference_period / robot.servo_period + 0.5);
  VirtualClock clock;
  Timing timing;
  Standstill standstill(robot);

  controller.servo().enable(clock.now());
  controller.motion().prepare(clock.now());
  auto program_state = program.step(kInstructionsPerCycle);
  for (std::int64_t cycle = 0;; ++cycle) {
    servo_cycles(controller, clock, cycle, per_cycle);
    controller.motion().cycle(cycle, 0);
    attend();
    if (controller.motion().over()) {
      servo_cycles(controller, clock, cycle + 1, per_cycle);  // an output due last is written, too
      return timing;
    }
    if (controller.holding()) continue;  // the program has lost its turn
    if (program_state != ProgramTask::State::Over) {
      program_state = program.step(kInstructionsPerCycle);
    }
    program_state = program.run_tasks(program_state);
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
