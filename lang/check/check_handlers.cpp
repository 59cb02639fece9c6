#include <algorithm>
#include <utility>

#include "lang/check/statement_checker.h"

/// The part of StatementChecker that knows the handlers of WHEN. A handler is checked where it
/// stands, since it sees what is declared there, and becomes a routine.
namespace rob::lang {

void StatementChecker::check_handler(When& when) {
  watches_.check_when(when);
  const Place place = place_;
  Routine& handler = *std::ranges::find_if(
      routines_, [&](const Routine& one) { return one.handler && one.place == place; });
  when.handler = handler.index;
  uses_.called(handler, place);
  const Routine* const outer = uses_.enter(&handler);
  const Routine* const routine = std::exchange(routine_, &handler);
  if (around_ == nullptr) around_ = routine;
  const int loops = std::exchange(loops_, 0);
  const int rescues = std::exchange(rescues_, 0);
  const Slots declared = std::exchange(declared_, Slots{});
  const Slots most = std::exchange(most_declared_, Slots{});
  const bool memory = expressions_.take_memory_use();
  uses_.enter_handler(scopes_.declared());
  check(when.action);
  handler.body = std::move(when.action);
  handler.memory = take_memory_use();
  if (memory) expressions_.need_memory();
  declared_ = declared;
  most_declared_ = most;
  rescues_ = rescues;
  loops_ = loops;
  routine_ = routine;
  if (around_ == routine) around_ = nullptr;
  uses_.enter(outer);
}

void StatementChecker::settle_handlers() {
  uses_.report_handlers(routines_, diagnostics_);
  for (Routine& routine : routines_) {
    if (!routine.handler) continue;
    routine.stops = uses_.stops(routine);
    routine.captured = uses_.captured(routine);
  }
}

}  // namespace rob::lang
