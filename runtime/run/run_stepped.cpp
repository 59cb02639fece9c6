#include <algorithm>
#include <cmath>

#include "runtime/run/execution.h"
#include "runtime/run/standstill.h"
#include "runtime/run/stepper.h"

namespace rob::runtime {

namespace {

/// Turns of program and planner in one cycle: as many as the planner's thread would have in real
/// time.
int turns_in(double period) {
  return std::max(1, static_cast<int>(std::lround(period / kPlanningPeriod)));
}

/// The program goes on where planning the path has made room for it; `budget`: instructions.
ProgramTask::State work_ahead(Controller& controller, ProgramTask& program,
                              ProgramTask::State state, std::int64_t budget) {
  const std::int64_t end = program.executed() + budget;
  for (int turns = turns_in(controller.robot().reference_period);
       controller.plan_path() && program.waits_for_room() && --turns > 0;) {
    const std::int64_t left = end - program.executed();
    if (left <= 0) break;
    state = program.step(left);
  }
  return state;
}

}  // namespace

Timing run_stepped(Controller& controller, ProgramTask& program, const RunLimits& limits,
                   const Attend& attend) {
  Stepper stepper(controller);
  Timing timing;
  Standstill standstill(controller.robot());

  auto program_state = program.step(kInstructionsPerCycle);
  program_state = work_ahead(controller, program, program_state, kInstructionsPerCycle);
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
    program_state = work_ahead(controller, program, program_state, kInstructionsPerCycle);
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
