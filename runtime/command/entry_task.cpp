#include "runtime/command/entry_task.h"

#include <span>
#include <utility>

#include <fmt/format.h>

namespace rob::runtime {

using lang::Reply;

EntryTask::EntryTask(RobotMachine& machine, std::uint64_t seed)
    : machine_(machine),
      tasks_(machine.parts().task_side, seed),
      beside_(machine.parts().task_side, &tasks_.memory()),
      vm_(machine, seed) {
  machine.run_beside(tasks_);
  machine.parts().operator_stop.stay();
}

void EntryTask::submit(Entry entry) {
  const std::lock_guard lock(mutex_);
  queue_.push_back(std::move(entry));
  settled_.store(false, std::memory_order_release);
  open_.fetch_add(1, std::memory_order_release);
}

std::optional<EntryTask::Failure> EntryTask::take_failure() {
  const std::lock_guard lock(mutex_);
  if (failures_.empty()) return std::nullopt;
  Failure failure = std::move(failures_.front());
  failures_.pop_front();
  return failure;
}

void EntryTask::tell_settled() {
  const bool stands = machine_.parts().progress.settled();
  const std::lock_guard lock(mutex_);
  settled_.store(stands && open() == 0, std::memory_order_release);
}

EntryTask::State EntryTask::carry_out(std::int64_t budget) {
  if (!program_) {
    take_interruption();
    tasks_.take_due();
  }
  if (failing_) return end_failed();
  begin_handler();
  if (!entry_ && !vm_.handling() && !begin_next()) return State::Over;
  if (!entry_) return run_vm(budget);
  return std::visit([&](const auto& what) { return go_on(what, budget); }, entry_->what);
}

/// One that fails has ended; the others and the entries go on.
void EntryTask::run_own_tasks() {
  const std::int64_t cycle = machine_.links().channels.cycle.load(std::memory_order_relaxed);
  if (!tasks_.any() || cycle == tasks_cycle_) return;
  tasks_cycle_ = cycle;
  if (!program_) tasks_.take_due();
  tasks_.run_cycle();
  auto error = tasks_.take_error();
  if (!error) return;
  const std::lock_guard lock(mutex_);
  failures_.push_back({.error = std::move(*error), .beside = true});
}

EntryTask::State EntryTask::run_tasks(State state) {
  run_own_tasks();
  return program_ ? program_->run_tasks(state) : state;
}

bool EntryTask::begin_next() {
  Channels& channels = machine_.links().channels;
  if (channels.way_back.under_way.load(std::memory_order_acquire)) return false;
  // The next entry begins where WayBack has brought the axes.
  if (channels.way_back.moved.exchange(false))
    machine_.parts().queue.restart_from(channels.joints.load());
  {
    const std::lock_guard lock(mutex_);
    if (queue_.empty()) return false;
    entry_ = std::move(queue_.front());
    queue_.pop_front();
  }
  std::visit([&](const auto& what) { begin(what); }, entry_->what);
  return true;
}

/// An entry with watches is kept: the handlers of its WHENs may begin as long as they are armed.
void EntryTask::begin(const Statements& statements) {
  if (!statements.chunk->watches.empty()) watching_.push_back(statements.chunk);
  present_ = statements.chunk;
  stand(statements.obstacles);
  tasks_.go_on_with(statements.chunk);
  tell_outdated();
  machine_.parts().safe.declare_further(statements.chunk->safe_values);
  vm_.go_on_with(*statements.chunk);
}

/// Declared obstacles stand there from now on, for handlers, too.
void EntryTask::stand(const std::vector<motion::Obstacle>& obstacles) {
  machine_.parts().touching.add(obstacles);
  if (RobotMachine* const handlers = machine_.handlers()) handlers->parts().touching.add(obstacles);
}

void EntryTask::tell_outdated() {
  for (const std::string& task : tasks_.take_outdated()) {
    Failure failure;
    failure.beside = failure.told = true;
    failure.error.message = fmt::format(
        "TASK {} has ended: what it uses has been declared anew; START {} begins it again", task,
        task);
    const std::lock_guard lock(mutex_);
    failures_.push_back(std::move(failure));
  }
}

/// Their handlers are not the program's.
void EntryTask::begin(const Program& program) {
  machine_.parts().whens.disarm_all(static_cast<int>(entry_->line));  // at rest: there is room
  vm_.forget_whens();
  stand(program.obstacles);
  tasks_.take_due();  // all of it is due: the robot stands
  program_.emplace(*program.chunk, machine_, program.seed);
  if (program.saved != nullptr) program_->start_from(*program.saved);
  machine_.links().channels.hold_points.begin_behind(machine_.links().planner.last_number());
}

EntryTask::State EntryTask::go_on(const Statements&, std::int64_t budget) { return run_vm(budget); }

/// The entry, or a handler between two of them.
EntryTask::State EntryTask::run_vm(std::int64_t budget) {
  switch (vm_.run(budget)) {
    case lang::Vm::State::Running:
      return State::Busy;
    case lang::Vm::State::Waiting:
    case lang::Vm::State::NextCycle:
      return State::Waiting;
    case lang::Vm::State::Done:
      return entry_ ? end() : State::Over;
    case lang::Vm::State::Failed:
      break;
  }
  failing_ = vm_.error();
  return end_failed();
}

/// It has finished what it had commanded, whether it failed or not.
EntryTask::State EntryTask::go_on(const Program& program, std::int64_t budget) {
  const State state = program_->step(budget);
  if (state != State::Over) return state;
  failing_ = program_->failure();
  program_.reset();
  machine_.run_beside(tasks_);
  tasks_.take_due();          // what is left is of the program
  run_last_ = program.chunk;  // a guard may point into it
  watching_.clear();          // the disarming is done
  machine_.parts().safe.declare(present_ ? std::span<const lang::SafeValue>(present_->safe_values)
                                         : std::span<const lang::SafeValue>{});
  machine_.links().channels.hold_points.end_with(machine_.links().planner.last_number());
  given_up_ = true;
  return failing_ ? end_failed() : end();
}

EntryTask::State EntryTask::go_on(const Jog& jog, std::int64_t) {
  const int line = static_cast<int>(entry_->line);
  bool hit = false;
  Reply reply = jogs_ ? machine_.ended(line, hit)
                      : machine_.parts().motions.jog_while(line, jog.command, jog.held);
  if (reply == Reply::Later) return State::Waiting;
  if (reply == Reply::Refused) {
    failing_ = lang::RuntimeError{machine_.refusal().code,
                                  {entry_->line, 1},
                                  machine_.refusal().message,
                                  machine_.refusal().help};
    return end_failed();
  }
  if (std::exchange(jogs_, !jogs_)) return end();
  return State::Busy;
}

/// The entry, and all that have been typed after it.
EntryTask::State EntryTask::end_failed() {
  const int line = entry_ ? static_cast<int>(entry_->line) : 0;
  if (!given_up_) {
    if (vm_.give_up_entry() != Reply::Done) return State::Waiting;
    given_up_ = true;
  }
  if (machine_.settle(line) != Reply::Done) return State::Waiting;
  if (machine_.parts().safe.take(true) != Reply::Done) return State::Waiting;
  const std::lock_guard lock(mutex_);
  Failure failure{static_cast<std::uint32_t>(line), 0, 0, queue_.size(), std::move(*failing_)};
  if (entry_) queue_.push_front(std::move(*entry_));
  if (!queue_.empty()) {
    failure.first = queue_.front().line;
    failure.last = queue_.back().line;
  }
  failures_.push_back(std::move(failure));
  failing_.reset();
  open_.fetch_sub(queue_.size(), std::memory_order_release);
  queue_.clear();
  entry_.reset();
  given_up_ = jogs_ = false;
  return State::Waiting;
}

EntryTask::State EntryTask::end() {
  entry_.reset();
  given_up_ = false;
  open_.fetch_sub(1, std::memory_order_release);
  return State::Busy;
}

/// A WHEN has raised, or the operator has stopped the robot; the program may be done with its part.
void EntryTask::take_interruption() {
  auto error = machine_.take_interruption();
  if (!error || failing_) return;
  const bool statements = entry_ && std::holds_alternative<Statements>(entry_->what);
  if (!statements) {
    failing_ = std::move(error);
  } else {
    vm_.interrupt(std::move(*error));  // a TRY of the entry may catch it
  }
}

void EntryTask::begin_handler() {
  if (program_ || !vm_.takes_handlers()) return;
  const auto handled = machine_.take_handled();
  if (!handled) return;
  vm_.handle(handled->id, handled->robot != nullptr ? *handled->robot : beside_);
}

}  // namespace rob::runtime
