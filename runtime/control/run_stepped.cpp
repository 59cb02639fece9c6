#include "runtime/control/execution.h"
#include "runtime/control/standstill.h"
#include "runtime/control/stepper.h"

namespace rob::runtime {

namespace {

/// So many instructions without a wait also take one cycle of virtual time (docs/language.md).
constexpr std::int64_t kInstructionsPerCycle = 1'000'000;

}  // namespace

Timing run_stepped(Controller& controller, ProgramTask& program, const RunLimits& limits,
                   const Attend& attend) {
  Stepper stepper(controller);
  Timing timing;
  Standstill standstill(controller.robot());

  auto program_state = program.step(kInstructionsPerCycle);
  controller.plan_path();
  for (;;) {
    stepper.cycle();
    attend();
    if (controller.motion().over()) {
      stepper.servo_cycles();  // an output due last is written, too
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
    timing.waits_for_ever = limits.standstill && standstill.is_for_ever(controller, stepper.now());
    if (stepper.now() >= limits.virtual_time || program.executed() >= limits.instructions ||
        timing.waits_for_ever) {
      timing.gave_up = true;
      controller.channels().safe.clear();  // nothing has gone wrong
      controller.request_hold();
    }
  }
}

}  // namespace rob::runtime
