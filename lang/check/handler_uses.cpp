#include <algorithm>
#include <variant>

#include <fmt/format.h>

#include "lang/check/routine_uses.h"
#include "lang/text/ascii.h"
#include "lang/text/codes.h"

/// Member functions of RoutineUses for the handlers of WHEN: what they do, and the routines that
/// they call.
namespace rob::lang {

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

}  // namespace rob::lang
