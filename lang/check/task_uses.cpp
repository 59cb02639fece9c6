#include <algorithm>
#include <type_traits>

#include <fmt/core.h>

#include "lang/check/fold.h"
#include "lang/check/routine_uses.h"
#include "lang/text/ascii.h"
#include "lang/text/codes.h"

/// Member functions of RoutineUses for TASKs: what they do, and the routines that they call.
namespace rob::lang {
namespace {

/// Whether a statement neither moves nor waits for standstill; what is new to this list does.
bool fits_in_task(const Statement& statement) {
  return std::visit(
      [](const auto& node) {
        using Node = std::decay_t<decltype(node)>;
        return (std::is_same_v<Node, Declaration> || std::is_same_v<Node, Assign> ||
                std::is_same_v<Node, Pulse> || std::is_same_v<Node, Print> ||
                std::is_same_v<Node, Wait> || std::is_same_v<Node, If> ||
                std::is_same_v<Node, While> || std::is_same_v<Node, For> ||
                std::is_same_v<Node, Loop> || std::is_same_v<Node, Select> ||
                std::is_same_v<Node, Exit> || std::is_same_v<Node, Next> ||
                std::is_same_v<Node, Assert> || std::is_same_v<Node, CallStatement> ||
                std::is_same_v<Node, Return> || std::is_same_v<Node, Try> ||
                std::is_same_v<Node, Raise>);
      },
      statement.node);
}

/// Whether it needs the axes at rest, or takes them: a handler with such a statement must stop
/// them before.
bool stops_axes(const Statement& statement) {
  return !fits_in_task(statement) || std::holds_alternative<Wait>(statement.node) ||
         std::holds_alternative<Raise>(statement.node);
}

/// What computes, and nothing else.
bool fits_in_path(const Statement& statement) {
  return fits_in_task(statement) && !std::holds_alternative<Pulse>(statement.node) &&
         !std::holds_alternative<Print>(statement.node) &&
         !std::holds_alternative<Wait>(statement.node);
}

}  // namespace

void RoutineUses::statement(const Statement& statement) {
  if (inside_ == nullptr) return;
  if (stops_axes(statement)) stopping_.insert(inside_->index);
  if (std::holds_alternative<When>(statement.node)) {
    watching_.try_emplace(inside_->index, statement.place);
  }
  if (!fits_in_task(statement)) barred_.try_emplace(inside_->index, statement.place);
  if (!fits_in_path(statement)) robots_.try_emplace(inside_->index, statement.place);
}

void RoutineUses::written(const Symbol& symbol) {
  if (inside_ != nullptr && symbol.global) writers_[&symbol].insert(inside_->index);
}

void RoutineUses::referred(const Symbol& symbol, Place place) {
  if (!symbol.global) return;
  references_.push_back({&symbol, place});
}

bool RoutineUses::in_task(const Routine* routine) const {
  return routine != nullptr && !task_of_.empty() && task_of_[routine->index] != nullptr;
}

bool RoutineUses::any_in_task(const std::set<std::size_t>& routines) const {
  return std::ranges::any_of(routines, [&](std::size_t one) { return task_of_[one] != nullptr; });
}

/// From each TASK on to what it calls, and what that calls.
void RoutineUses::gather_tasks(const std::vector<Routine>& routines) {
  task_of_.assign(routines.size(), nullptr);
  const std::vector<std::vector<std::size_t>> called = callees();
  for (const Routine& task : routines) {
    if (!task.task) continue;
    std::vector<std::size_t> open{task.index};
    while (!open.empty()) {
      const std::size_t routine = open.back();
      open.pop_back();
      if (task_of_[routine] != nullptr) continue;
      task_of_[routine] = &task;
      open.insert(open.end(), called[routine].begin(), called[routine].end());
    }
  }
}

void RoutineUses::report_tasks(const std::vector<Routine>& routines, Diagnostics& diagnostics) {
  gather_tasks(routines);
  for (const auto& [routine, place] : barred_) {
    const Routine* const task = task_of_[routine];
    if (task == nullptr) continue;
    const std::string what = "a TASK neither moves the robot nor waits until it stands";
    diagnostics.error(code::kNotInTask, place,
                      task->index == routine
                          ? what
                          : fmt::format("{}; TASK {} calls {}", what, shortened(task->name),
                                        shortened(routines[routine].name)),
                      "a TASK can set a variable that the program looks at, or RAISE an error");
  }
  report_references(diagnostics);
}

void RoutineUses::report_references(Diagnostics& diagnostics) const {
  for (const Reference& reference : references_) {
    const auto users = users_.find(reference.symbol);
    if (users == users_.end() || !any_in_task(users->second)) continue;
    diagnostics.error(code::kSharedReference, reference.place,
                      fmt::format("{} is used by a TASK, and cannot be given to a REF parameter",
                                  shortened(reference.symbol->name)),
                      "give a variable of its own, and assign it behind the call");
  }
}

std::vector<RoutineUses::Shared> RoutineUses::shared() const {
  std::vector<Shared> shared;
  for (const auto& [symbol, users] : users_) {
    if (!any_in_task(users)) continue;
    const auto writers = writers_.find(symbol);
    shared.push_back({symbol, writers != writers_.end() && any_in_task(writers->second)});
  }
  std::ranges::sort(shared, {}, [](const Shared& one) { return one.symbol->id; });
  return shared;
}

}  // namespace rob::lang
