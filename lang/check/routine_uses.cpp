#include "lang/check/routine_uses.h"

#include <algorithm>
#include <functional>
#include <utility>

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

}  // namespace

/// What is constant lives in the code and is there from the beginning.
void RoutineUses::used(const Symbol& symbol) {
  if (inside_ == nullptr || known(symbol.value)) return;
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

}  // namespace rob::lang
