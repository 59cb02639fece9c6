#include <algorithm>
#include <utility>

#include "lang/check/statement_checker.h"

/// Member functions of StatementChecker for the handlers of WHEN. A handler is checked at its place
/// in the text, because it sees what is declared there; it becomes a routine.
namespace rob::lang {

void StatementChecker::check_handler(When& when) {
  watches_.check_when(when);
  const Place place = place_;
  Routine& handler = *std::ranges::find_if(
      routines_, [&](const Routine& one) { return one.handler && one.place == place; });
  when.handler = handler.index;
  uses_.called(handler, place);
  const Routine* const outer = uses_.enter(&handler);
  const Inside outside = inside_;
  inside_ = {.routine = &handler,
             .around = outside.around != nullptr ? outside.around : outside.routine};
  const bool memory = expressions_.take_memory_use();
  uses_.enter_handler(scopes_.declared());
  check(when.action);
  handler.body = std::move(when.action);
  handler.memory = take_memory_use();
  if (memory) expressions_.need_memory();
  inside_ = outside;
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
