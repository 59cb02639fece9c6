#include "runtime/control/program_task.h"

#include <utility>

namespace rob::runtime {

ProgramTask::ProgramTask(const lang::Chunk& chunk, RobotMachine& machine, std::uint64_t seed,
                         std::optional<std::size_t> test)
    : vm_(chunk, machine, seed), machine_(machine) {
  machine.declare_safe(chunk.safe_values);
  if (test) vm_.choose_test(*test);
}

ProgramTask::State ProgramTask::step(std::int64_t budget) {
  if (failure_) return finish(lang::line_tag(failure_->place));
  if (circling() != 0) return finish(circling());
  if (auto error = machine_.take_interruption()) vm_.interrupt(std::move(*error));
  switch (vm_.run(budget)) {
    case lang::Vm::State::Running:
      return State::Busy;
    case lang::Vm::State::Waiting:
    case lang::Vm::State::NextCycle:
      return State::Waiting;
    case lang::Vm::State::Done:
      return State::Over;
    case lang::Vm::State::Failed:
      break;
  }
  failure_ = vm_.error();
  return finish(lang::line_tag(failure_->place));
}

/// An error takes effect in motion order: the last motion commanded before it is made exact.
ProgramTask::State ProgramTask::finish(int line) {
  const lang::Reply reply = failure_ ? machine_.fail(line) : machine_.end(line);
  return reply == lang::Reply::Later ? State::Waiting : State::Over;
}

}  // namespace rob::runtime
