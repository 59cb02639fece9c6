#include "lang/check/routine_uses.h"

#include <algorithm>
#include <optional>
#include <type_traits>
#include <utility>
#include <variant>

#include <fmt/core.h>

#include "lang/check/fold.h"
#include "lang/text/ascii.h"
#include "lang/text/codes.h"

namespace rob::lang {
namespace {

bool is_local(const Symbol& symbol) {
  return symbol.kind == Symbol::Kind::Variable || symbol.kind == Symbol::Kind::NamedConstant ||
         symbol.kind == Symbol::Kind::LoopVariable;
}

/// Whether a statement neither moves nor waits for standstill; what is new to this list does.
bool fits_in_task(const Statement& statement) {
  return std::visit(
      [](const auto& node) {
        using Node = std::decay_t<decltype(node)>;
        return (std::is_same_v<Node, Declaration> || std::is_same_v<Node, Assign> ||
                std::is_same_v<Node, Pulse> || std::is_same_v<Node, Print> ||
                std::is_same_v<Node, Write> || std::is_same_v<Node, Wait> ||
                std::is_same_v<Node, Send> || std::is_same_v<Node, Receive> ||
                std::is_same_v<Node, If> || std::is_same_v<Node, While> ||
                std::is_same_v<Node, For> || std::is_same_v<Node, Loop> ||
                std::is_same_v<Node, Select> || std::is_same_v<Node, Exit> ||
                std::is_same_v<Node, Next> || std::is_same_v<Node, Assert> ||
                std::is_same_v<Node, CallStatement> || std::is_same_v<Node, Return> ||
                std::is_same_v<Node, Try> || std::is_same_v<Node, Raise>);
      },
      statement.node);
}

/// With a device.
bool speaks(const Statement& statement) {
  return std::holds_alternative<Send>(statement.node) ||
         std::holds_alternative<Receive>(statement.node);
}

/// Whether it needs the axes at rest, or takes them: a handler with such a statement must stop
/// them before.
bool stops_axes(const Statement& statement) {
  return !fits_in_task(statement) || std::holds_alternative<Wait>(statement.node) ||
         speaks(statement) || std::holds_alternative<Raise>(statement.node);
}

/// Whether it computes, and does nothing else.
bool fits_in_path(const Statement& statement) {
  return fits_in_task(statement) && !speaks(statement) &&
         !std::holds_alternative<Pulse>(statement.node) &&
         !std::holds_alternative<Print>(statement.node) &&
         !std::holds_alternative<Write>(statement.node) &&
         !std::holds_alternative<Wait>(statement.node);
}

}  // namespace

/// A constant lives in the code and is there from the beginning.
void RoutineUses::used(const Symbol& symbol) {
  if (inside_ == nullptr) return;
  named_[&symbol].insert(inside_->index);
  if (known(symbol.value)) return;
  if (symbol.global) {
    users_[&symbol].insert(inside_->index);
  } else if (inside_->handler && symbol.id < handler_begins_ && is_local(symbol)) {
    captured_[inside_->index].emplace(symbol.id, &symbol);
  }
}

void RoutineUses::called(const Routine& routine, Place place) {
  if (in_path_) path_calls_.push_back({&routine, place});
  if (inside_ != nullptr) {
    callers_[routine.index].insert(inside_->index);
  } else {
    calls_.push_back({&routine, place, statement_});
  }
}

void RoutineUses::statement(const Statement& statement) {
  if (inside_ == nullptr) return;
  if (stops_axes(statement)) stopping_.insert(inside_->index);
  if (std::holds_alternative<When>(statement.node)) {
    watching_.try_emplace(inside_->index, statement.place);
  }
  if (!fits_in_task(statement)) barred_.try_emplace(inside_->index, statement.place);
  if (!fits_in_path(statement)) robots_.try_emplace(inside_->index, statement.place);
}

void RoutineUses::met_list(Place place) {
  if (inside_ != nullptr) listed_.try_emplace(inside_->index, place);
}

void RoutineUses::written(const Symbol& symbol, Place place) {
  if (symbol.type.is(Type::Kind::List)) return met_list(place);
  if (inside_ != nullptr && symbol.global) writers_[&symbol].insert(inside_->index);
}

void RoutineUses::spoke_with(const Symbol& device, Place place) {
  talks_.push_back({&device, inside_, place});
}

void RoutineUses::referred(const Symbol& symbol, Place place) {
  if (!symbol.global) return;
  references_.push_back({&symbol, place});
}

void RoutineUses::met_robot(Place place) {
  if (inside_ != nullptr) robots_.try_emplace(inside_->index, place);
}

/// The routines that each routine calls.
std::vector<std::vector<std::size_t>> RoutineUses::callees() const {
  std::vector<std::vector<std::size_t>> called(callers_.size());
  for (std::size_t callee = 0; callee < callers_.size(); ++callee) {
    for (const std::size_t caller : callers_[callee]) called[caller].push_back(callee);
  }
  return called;
}

std::set<std::size_t> RoutineUses::reached_from(std::size_t routine) const {
  const std::vector<std::vector<std::size_t>> called = callees();
  std::set<std::size_t> reached;
  std::vector<std::size_t> open{routine};
  while (!open.empty()) {
    const std::size_t caller = open.back();
    open.pop_back();
    if (reached.insert(caller).second) {
      open.insert(open.end(), called[caller].begin(), called[caller].end());
    }
  }
  return reached;
}

// Globals

/// For each routine the global, of those it needs, that is declared last; null if it needs none.
/// From the last global backward, each routine is settled once, and with it all that call it.
std::vector<const Symbol*> RoutineUses::latest_needs() const {
  std::vector<std::pair<std::size_t, const Symbol*>> globals;
  for (const auto& [symbol, users] : users_) {
    const auto declared = declared_in_.find(symbol);
    if (declared != declared_in_.end()) globals.emplace_back(declared->second, symbol);
  }
  std::ranges::sort(globals, [](const auto& a, const auto& b) {
    return a.first != b.first ? a.first > b.first : a.second->id < b.second->id;
  });
  std::vector<const Symbol*> needs(callers_.size(), nullptr);
  for (const auto& [statement, symbol] : globals) {
    const std::set<std::size_t>& users = users_.at(symbol);
    std::vector<std::size_t> open(users.begin(), users.end());
    while (!open.empty()) {
      const std::size_t routine = open.back();
      open.pop_back();
      if (needs[routine] != nullptr) continue;
      needs[routine] = symbol;
      open.insert(open.end(), callers_[routine].begin(), callers_[routine].end());
    }
  }
  return needs;
}

void RoutineUses::report(Diagnostics& diagnostics) const {
  const std::vector<const Symbol*> needs = latest_needs();
  for (const TopLevelCall& call : calls_) {
    const Symbol* const global = needs[call.routine->index];
    if (global == nullptr || declared_in_.at(global) < call.statement) continue;
    diagnostics.error(
        code::kGlobalTooEarly, call.place,
        fmt::format("{} uses {}, which is declared in {}: it has no value yet here",
                    shortened(call.routine->name), shortened(global->name),
                    diagnostics.line_of(global->place, call.place)),
        fmt::format("move the declaration of {} above this line", shortened(global->name)));
  }
}

// Handlers

bool RoutineUses::stops(const Routine& handler) const {
  return std::ranges::any_of(reached_from(handler.index),
                             [&](std::size_t one) { return stopping_.contains(one); });
}

std::vector<const Symbol*> RoutineUses::captured(const Routine& handler) const {
  std::vector<const Symbol*> symbols;
  const auto found = captured_.find(handler.index);
  if (found == captured_.end()) return symbols;
  for (const auto& [id, symbol] : found->second) symbols.push_back(symbol);
  return symbols;
}

void RoutineUses::report_handlers(const std::vector<Routine>& routines,
                                  Diagnostics& diagnostics) const {
  for (const Routine& handler : routines) {
    if (!handler.handler) continue;
    for (const std::size_t one : reached_from(handler.index)) {
      const auto found = watching_.find(one);
      if (found == watching_.end()) continue;
      const std::string called = one == handler.index ? ""
                                                      : fmt::format(", and {} is called by one",
                                                                    shortened(routines[one].name));
      diagnostics.error(code::kWhenInHandler, found->second,
                        fmt::format("a handler of WHEN has no WHEN of its own{}", called),
                        "look at the condition with IF, or arm it before");
    }
  }
}

// TASKs

bool RoutineUses::in_task(const Routine* routine) const {
  return routine != nullptr && !task_of_.empty() && task_of_[routine->index] != nullptr;
}

bool RoutineUses::any_in_task(const std::set<std::size_t>& routines) const {
  return std::ranges::any_of(routines, [&](std::size_t one) { return task_of_[one] != nullptr; });
}

/// From each TASK on to what it calls, and what that calls.
void RoutineUses::gather_tasks(const std::vector<Routine>& routines) {
  task_of_.assign(routines.size(), nullptr);
  for (const Routine& task : routines) {
    if (!task.task) continue;
    for (const std::size_t one : reached_from(task.index)) {
      if (task_of_[one] == nullptr) task_of_[one] = &task;
    }
  }
}

void RoutineUses::report_tasks(const std::vector<Routine>& routines, Diagnostics& diagnostics) {
  gather_tasks(routines);
  for (const auto& [routine, place] : listed_) {
    if (task_of_[routine] == nullptr) continue;
    diagnostics.error(code::kListInTask, place,
                      "a TASK only looks at the LISTs of the program: it changes none, and has "
                      "none of its own",
                      "an ARRAY has the same room from the beginning");
  }
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
  report_devices(routines, diagnostics);
}

/// From the statements of the program on, and from its handlers and TESTs.
std::set<std::size_t> RoutineUses::reached_by_program(const std::vector<Routine>& routines) const {
  std::set<std::size_t> reached;
  const auto begin_at = [&](const Routine& routine) {
    if (!routine.task) reached.merge(reached_from(routine.index));
  };
  for (const TopLevelCall& call : calls_) begin_at(*call.routine);
  for (const Routine& routine : routines) {
    if (routine.handler || routine.test) begin_at(routine);
  }
  return reached;
}

/// A line is for one reader, so a device belongs to the program or to one TASK.
void RoutineUses::report_devices(const std::vector<Routine>& routines,
                                 Diagnostics& diagnostics) const {
  const std::set<std::size_t> by_program = reached_by_program(routines);
  std::map<const Symbol*, std::set<const Routine*>> users;  // null: the program
  for (const Talk& talk : talks_) {
    std::set<const Routine*>& known = users[talk.device];
    const bool alone = known.size() < 2;
    if (talk.inside == nullptr || by_program.contains(talk.inside->index)) known.insert(nullptr);
    for (const Routine& task : routines) {
      const bool calls = task.task && talk.inside != nullptr &&
                         reached_from(task.index).contains(talk.inside->index);
      if (calls) known.insert(&task);
    }
    if (!alone || known.size() < 2) continue;
    std::string names;
    for (const Routine* const user : known) {
      names += names.empty() ? "" : " and ";
      names += user == nullptr ? "the program" : "TASK " + shortened(user->name);
    }
    diagnostics.error(code::kNotInTask, talk.place,
                      fmt::format("{} belongs to the program or to one TASK; {} use it",
                                  shortened(talk.device->name), names),
                      "let one of them speak with it, and give the other what it needs in a "
                      "variable");
  }
}

bool RoutineUses::uses_since(const Routine& task, std::uint32_t line,
                             const std::vector<Routine>& routines) const {
  const std::set<std::size_t> reached = reached_from(task.index);
  const auto since = [&](const Place& place) { return place.file == 0 && place.line >= line; };
  const auto is_reached = [&](std::size_t one) { return reached.contains(one); };
  if (std::ranges::any_of(reached, [&](std::size_t one) { return since(routines[one].place); }))
    return true;
  return std::ranges::any_of(named_, [&](const auto& one) {
    const auto& [symbol, users] = one;
    return since(symbol->place) && std::ranges::any_of(users, is_reached);
  });
}

void RoutineUses::report_references(Diagnostics& diagnostics) const {
  for (const Reference& reference : references_) {
    const auto users = users_.find(reference.symbol);
    if (users == users_.end() || !any_in_task(users->second)) continue;
    diagnostics.error(code::kSharedReference, reference.place,
                      fmt::format("{} is used by a TASK, and cannot be given to a REF parameter",
                                  shortened(reference.symbol->name)),
                      "give a variable of its own, and assign it after the call");
  }
}

void RoutineUses::share_with_handlers(const std::vector<Routine>& routines) {
  for (const Routine& routine : routines) {
    if (routine.handler) of_handlers_.merge(reached_from(routine.index));
  }
}

std::vector<RoutineUses::Shared> RoutineUses::shared() const {
  std::vector<Shared> shared;
  for (const auto& [symbol, users] : users_) {
    const bool of_tasks = any_in_task(users);
    const bool of_handlers =
        std::ranges::any_of(users, [&](std::size_t one) { return of_handlers_.contains(one); });
    if (!of_tasks && !of_handlers) continue;
    const auto writers = writers_.find(symbol);
    const bool written = writers != writers_.end() && any_in_task(writers->second);
    shared.push_back({symbol, written || of_handlers, of_tasks});
  }
  std::ranges::sort(shared, {}, [](const Shared& one) { return one.symbol->id; });
  return shared;
}

// PATHs

/// A global that a TASK changes counts as read from the robot.
void RoutineUses::report_paths(const std::vector<Routine>& routines,
                               Diagnostics& diagnostics) const {
  std::map<std::size_t, Place> robots = robots_;
  for (const Shared& one : shared()) {
    if (!one.observed || !one.of_tasks) continue;
    for (const std::size_t user : users_.at(one.symbol)) robots.try_emplace(user, Place{});
  }
  const std::vector<std::vector<std::size_t>> called = callees();
  for (const PathCall& call : path_calls_) {
    std::vector<std::size_t> open{call.routine->index};
    std::set<std::size_t> seen(open.begin(), open.end());
    std::optional<std::size_t> guilty;
    while (!open.empty() && !guilty) {
      const std::size_t routine = open.back();
      open.pop_back();
      if (robots.contains(routine)) guilty = routine;
      for (const std::size_t next : called[routine]) {
        if (seen.insert(next).second) open.push_back(next);
      }
    }
    if (!guilty) continue;
    const Place where = robots.at(*guilty);
    const std::string what = where.line == 0
                                 ? "uses a variable that a TASK changes"
                                 : fmt::format("has to do with the robot or the world in {}",
                                               diagnostics.line_of(where, call.place));
    const std::string by = *guilty == call.routine->index
                               ? shortened(call.routine->name)
                               : fmt::format("{} calls {}, which", shortened(call.routine->name),
                                             shortened(routines[*guilty].name));
    diagnostics.error(code::kReadInPath, call.place,
                      fmt::format("a PATH is planned before it starts, and {} {}", by, what),
                      "call it before PATH and give its value a variable");
  }
}

}  // namespace rob::lang
