#include "runtime/command/program_task.h"

#include <utility>

namespace rob::runtime {

ProgramTask::ProgramTask(const lang::Chunk& chunk, RobotMachine& machine, std::uint64_t seed,
                         std::optional<std::size_t> test)
    : vm_(chunk, machine, seed),
      machine_(machine),
      tasks_(chunk, machine.parts().task_side, seed),
      beside_(machine.parts().task_side, &tasks_.memory()) {
  machine.run_beside(tasks_);
  machine.parts().safe.declare(chunk.safe_values);
  if (test) vm_.choose_test(*test);
}

ProgramTask::State ProgramTask::step(std::int64_t budget) {
  if (failure_) return finish(lang::line_tag(failure_->place));
  if (circling() != 0) return finish(circling());
  if (auto error = machine_.take_interruption()) vm_.interrupt(std::move(*error));
  begin_handler();
  tasks_.take_due();
  if (auto error = tasks_.take_error()) vm_.interrupt(std::move(*error));
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
  tasks_.stop();
  return finish(lang::line_tag(failure_->place));
}

ProgramTask::State ProgramTask::run_tasks(State state) {
  const std::int64_t cycle = machine_.links().channels.cycle.load(std::memory_order_relaxed);
  if (failure_ || !tasks_.any() || cycle == tasks_cycle_) return state;
  tasks_cycle_ = cycle;
  tasks_.take_due();
  tasks_.run_cycle();
  auto error = tasks_.take_error();
  if (!error) return state;
  if (vm_.state() == lang::Vm::State::Done) {
    failure_ = std::move(error);  // nothing is left that it could interrupt
    tasks_.stop();
  } else {
    vm_.interrupt(std::move(*error));
  }
  return State::Busy;
}

void ProgramTask::begin_handler() {
  if (!vm_.takes_handlers()) return;
  const auto handled = machine_.take_handled();
  if (!handled) return;
  vm_.handle(handled->id, handled->robot != nullptr ? *handled->robot : beside_);
}

/// An error takes effect in motion order: the last motion commanded before it is made exact.
ProgramTask::State ProgramTask::finish(int line) {
  machine_.parts().turns.bar(true);
  if (vm_.tell_persistent() == lang::Reply::Later) return State::Waiting;
  const lang::Reply reply = failure_ ? machine_.fail(line) : machine_.end(line);
  return reply == lang::Reply::Later ? State::Waiting : State::Over;
}

}  // namespace rob::runtime
