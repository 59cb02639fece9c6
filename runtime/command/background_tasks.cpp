#include "runtime/command/background_tasks.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "lang/text/ascii.h"
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

/// The program outlives its TASKs.
BackgroundTasks::Code borrowed(const lang::Chunk& chunk) {
  return {BackgroundTasks::Code(), &chunk};
}

}  // namespace

BackgroundTasks::BackgroundTasks(const lang::Chunk& chunk, const TaskSide& side, std::uint64_t seed)
    : code_(borrowed(chunk)),
      side_(side),
      channels_(side.links.channels),
      seed_(seed),
      memory_(chunk) {}

BackgroundTasks::BackgroundTasks(const TaskSide& side, std::uint64_t seed)
    : code_(std::make_shared<const lang::Chunk>()),
      side_(side),
      channels_(side.links.channels),
      seed_(seed) {}

void BackgroundTasks::go_on_with(Code entry) {
  // The handlers of WHENs share what they use already, for TASKs that come later.
  if (!entry->tasks.empty() || !entry->watches.empty()) memory_.open();
  if (entry->tasks.empty() && code_->tasks.empty()) return;
  code_ = std::move(entry);
  std::erase_if(running_, [&](const Running& one) { return declared_anew(*one.code, one.task); });
  for (const lang::TaskCode& task : code_->tasks) {
    if (task.outdated) end_outdated(task);
  }
}

/// Its code is of the old variables; one whose START is on its way would begin with them.
void BackgroundTasks::end_outdated(const lang::TaskCode& task) {
  const int asked = lang::line_tag(task.place);
  const std::size_t ended = std::erase_if(
      running_, [&](const Running& one) { return identity(*one.code, one.task) == asked; });
  const std::size_t dropped = std::erase_if(kept_, [&](const auto& kept) {
    const auto* const start = std::get_if<Start>(&kept.second);
    return start != nullptr && identity(*start->code, start->task) == asked;
  });
  if (ended + dropped > 0) outdated_.push_back(task.name);
}

bool BackgroundTasks::declared_anew(const lang::Chunk& code, std::uint32_t task) const {
  const lang::TaskCode& old = code.tasks[task];
  return std::ranges::any_of(code_->tasks, [&](const lang::TaskCode& one) {
    return one.place.file == old.place.file && lang::same_word(one.name, old.name) &&
           lang::line_tag(one.place) != lang::line_tag(old.place);
  });
}

std::size_t BackgroundTasks::free_stack() const {
  std::size_t stack = 0;
  const auto taken = [&](const Running& one) { return one.stack == stack; };
  while (std::ranges::any_of(running_, taken)) ++stack;
  return stack;
}

std::uint32_t BackgroundTasks::keep(Due due) {
  if (auto* const start = std::get_if<Start>(&due)) {
    start->code = code_;
    started_.insert(identity(start->task));
  }
  bytes_of_lists_ += bytes_of_list(due);
  kept_.emplace(next_, std::move(due));
  return next_++;
}

void BackgroundTasks::take_due() {
  Channels::Report report;
  while (channels_.reports.take(report)) {
    auto kept = kept_.extract(report.id);
    if (kept.empty()) continue;  // of a program that is over
    bytes_of_lists_ -= bytes_of_list(kept.mapped());
    if (report.dropped) continue;
    std::visit([&](const auto& due) { carry_out(due); }, kept.mapped());
  }
}

void BackgroundTasks::carry_out(const Start& start) {
  if (declared_anew(*start.code, start.task)) return;
  Running running{start.code,
                  start.task,
                  free_stack(),
                  lang::line_tag(start.place),
                  std::make_unique<TaskMachine>(side_, &memory_),
                  nullptr};
  running.vm =
      std::make_unique<lang::Vm>(*start.code, *running.machine, start.task,
                                 lang::TaskStack{memory_, running.stack}, seed_ + 1 + start.task);
  running_.push_back(std::move(running));
}

void BackgroundTasks::carry_out(const StoreList& store) {
  memory_.store_list(store.home, {store.size, store.count, store.numbers, store.texts});
}

bool BackgroundTasks::busy(std::uint32_t task) const {
  const int asked = identity(task);
  const auto is_due = [&](const auto& kept) {
    const auto* const start = std::get_if<Start>(&kept.second);
    return start != nullptr && identity(*start->code, start->task) == asked;
  };
  return std::ranges::any_of(
             running_,
             [&](const Running& one) { return identity(*one.code, one.task) == asked; }) ||
         std::ranges::any_of(kept_, is_due);
}

lang::Refusal BackgroundTasks::runs_already(std::uint32_t task) const {
  return {std::string(lang::code::kTaskRunning),
          fmt::format("TASK {} runs already", code_->tasks[task].name),
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
