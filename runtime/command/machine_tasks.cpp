#include <span>
#include <string>
#include <utility>

#include "runtime/command/background_tasks.h"
#include "runtime/command/robot_machine.h"

/// Member functions of RobotMachine for TASKs: what the program tells them in motion order, and
/// what it learns from them.
namespace rob::runtime {

using lang::Reply;
using motion::Effect;

namespace {

template <typename Value>
BackgroundTasks::Store<Value> store_of(std::size_t first, std::span<const Value> values) {
  return {first, {values.begin(), values.end()}};
}

}  // namespace

template <typename Due>
Reply RobotMachine::report(int line, Due due) {
  if (buffer_.effects_full() || tasks_->full()) return Reply::Later;
  Effect effect{.tag = static_cast<motion::Tag>(line), .kind = Effect::Kind::Report};
  effect.id = tasks_->keep(std::move(due));
  return push(effect);
}

/// A TASK that was started before may run still: that is seen at the decision point, and nothing
/// after its START is commanded before.
Reply RobotMachine::start(const lang::Place& place, std::uint32_t task) {
  if (tasks_->was_started(task)) {
    if (!observable()) return Reply::Later;
    tasks_->take_due();
    if (tasks_->busy(task)) {
      refuse(tasks_->runs_already(task));
      return Reply::Refused;
    }
  }
  return report(lang::line_tag(place), BackgroundTasks::Start{task, place});
}

Reply RobotMachine::publish(int line, std::size_t first, std::span<const lang::Slot> values) {
  return report(line, store_of(first, values));
}

Reply RobotMachine::publish(int line, std::size_t first, std::span<const std::string> texts) {
  return report(line, store_of(first, texts));
}

template <typename Value>
Reply RobotMachine::fetch(std::size_t first, std::span<Value> values) {
  if (!observable()) return Reply::Later;
  tasks_->take_due();
  tasks_->memory().load(first, values);
  return Reply::Done;
}

Reply RobotMachine::refresh(int /*line*/, std::size_t first, std::span<lang::Slot> values) {
  return fetch(first, values);
}

Reply RobotMachine::refresh(int /*line*/, std::size_t first, std::span<std::string> texts) {
  return fetch(first, texts);
}

}  // namespace rob::runtime
