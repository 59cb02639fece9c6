#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include <fmt/core.h>

#include "lang/check/routine_uses.h"
#include "lang/text/ascii.h"
#include "lang/text/codes.h"

/// Member functions of RoutineUses for PATHs: what the routines do that they call.
namespace rob::lang {

void RoutineUses::met_robot(Place place) {
  if (inside_ != nullptr) robots_.try_emplace(inside_->index, place);
}

/// Of each routine those that it calls.
std::vector<std::vector<std::size_t>> RoutineUses::callees() const {
  std::vector<std::vector<std::size_t>> called(callers_.size());
  for (std::size_t callee = 0; callee < callers_.size(); ++callee) {
    for (const std::size_t caller : callers_[callee]) called[caller].push_back(callee);
  }
  return called;
}

/// A global that a TASK changes counts as read from the robot.
void RoutineUses::report_paths(const std::vector<Routine>& routines,
                               Diagnostics& diagnostics) const {
  std::map<std::size_t, Place> robots = robots_;
  for (const Shared& one : shared()) {
    if (!one.observed) continue;
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
