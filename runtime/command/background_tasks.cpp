#include "runtime/command/background_tasks.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "lang/text/codes.h"

namespace rob::runtime {

namespace {

std::size_t bytes_of_list(const BackgroundTasks::Due& due) {
  const auto* const list = std::get_if<BackgroundTasks::StoreList>(&due);
  if (list == nullptr) return 0;
  std::size_t bytes = list->numbers.size() * sizeof(lang::Slot);
  for (const std::string& text : list->texts) bytes += sizeof(std::string) + text.size();
  return bytes;
}

}  // namespace

BackgroundTasks::BackgroundTasks(const lang::Chunk& chunk, const TaskSide& side, std::uint64_t seed)
    : chunk_(chunk), side_(side), channels_(side.links.channels), seed_(seed), memory_(chunk) {}

std::uint32_t BackgroundTasks::keep(Due due) {
  if (const auto* const start = std::get_if<Start>(&due)) started_.insert(start->task);
  bytes_of_lists_ += bytes_of_list(due);
  kept_.emplace(next_, std::move(due));
  return next_++;
}

void BackgroundTasks::take_due() {
  Channels::Report report;
  while (channels_.reports.take(report)) {
    auto kept = kept_.extract(report.id);
    bytes_of_lists_ -= bytes_of_list(kept.mapped());
    if (report.dropped) continue;
    std::visit([&](const auto& due) { carry_out(due); }, kept.mapped());
  }
}

void BackgroundTasks::carry_out(const Start& start) {
  Running running{start.task, lang::line_tag(start.place),
                  std::make_unique<TaskMachine>(side_, &memory_), nullptr};
  running.vm = std::make_unique<lang::Vm>(chunk_, *running.machine, start.task, memory_,
                                          seed_ + 1 + start.task);
  running_.push_back(std::move(running));
}

void BackgroundTasks::carry_out(const StoreList& store) {
  memory_.store_list(store.home, {store.size, store.count, store.numbers, store.texts});
}

bool BackgroundTasks::busy(std::uint32_t task) const {
  const auto is_due = [&](const auto& kept) {
    const auto* const start = std::get_if<Start>(&kept.second);
    return start != nullptr && start->task == task;
  };
  return std::ranges::any_of(running_, [&](const Running& one) { return one.task == task; }) ||
         std::ranges::any_of(kept_, is_due);
}

lang::Refusal BackgroundTasks::runs_already(std::uint32_t task) const {
  return {std::string(lang::code::kTaskRunning),
          fmt::format("TASK {} runs already", chunk_.tasks[task].name),
          "it may be started again when it has come to its end"};
}

void BackgroundTasks::run_cycle() {
  std::erase_if(running_, [&](const Running& one) {
    const lang::Vm::State state = one.vm->run(kInstructions);
    if (state == lang::Vm::State::Failed) {
      lang::RuntimeError error = one.vm->error();
      // The outermost is the TASK itself.
      if (!error.calls.empty()) {
        error.calls.back().line = one.line;
        error.calls.back().by = lang::CallSite::By::Start;
      }
      fail(std::move(error));
    }
    return state == lang::Vm::State::Failed || state == lang::Vm::State::Done;
  });
}

/// The first error is the one to mend.
void BackgroundTasks::fail(lang::RuntimeError error) {
  if (!error_) error_ = std::move(error);
}

std::optional<lang::RuntimeError> BackgroundTasks::take_error() {
  return std::exchange(error_, std::nullopt);
}

}  // namespace rob::runtime
