#include <fmt/core.h>

#include "lang/check/fold.h"
#include "lang/check/observations.h"
#include "lang/check/target.h"
#include "lang/check/wait_checker.h"
#include "lang/text/codes.h"

namespace rob::lang {

void WaitChecker::check(Wait& wait, const Routine* routine) {
  const Type type = expressions_.check(wait.value);
  if (wait.timeout != nullptr) {
    expressions_.check(wait.timeout);
    expressions_.accept(*wait.timeout, Type::real(kTime), "TIMEOUT needs");
    check_not_negative(*wait.timeout, "TIMEOUT");
  }
  if (type == Type::real(kTime)) {
    check_time(wait);
  } else if (type == Type::boolean()) {
    if (observations(*wait.value) == 0) hopeless_.push_back({wait.value.get(), routine});
  } else if (type.kind != Type::Kind::Unknown) {
    diagnostics_.error(
        is_bare(type) || !type.numeric() ? code::kTypeMismatch : code::kDimensionMismatch,
        wait.value->place,
        fmt::format("this is {}; WAIT needs a time or a condition here", described(*wait.value)),
        is_bare(type) ? "write the unit, for example WAIT 0.5s"
                      : "for example WAIT 0.5s, or WAIT part_here");
  }
}

void WaitChecker::check_time(const Wait& wait) {
  if (wait.timeout != nullptr) {
    diagnostics_.error(code::kTimeoutOfTime, wait.timeout->place,
                       "TIMEOUT belongs to a WAIT for a condition; this one waits for a time",
                       "leave TIMEOUT out");
  }
  check_not_negative(*wait.value, "WAIT");
}

/// A global that a TASK changes counts as read from the world; for a TASK itself every global does.
void WaitChecker::report_hopeless(const RoutineUses& uses) {
  for (const Condition& condition : hopeless_) {
    const Expr& expression = *condition.expression;
    if (observations(expression) > 0) continue;
    if (uses.in_task(condition.routine) && reads_global(expression)) continue;
    diagnostics_.error(code::kNothingToWaitFor, expression.place,
                       "nothing in this condition can change while the program waits",
                       "name a signal, as in WAIT part_here; WAIT 0s only comes to rest");
  }
}

void WaitChecker::check_not_negative(const Expr& time, const char* word) {
  const auto number = constant_number(time);
  if (!number || *number >= 0) return;
  diagnostics_.error(
      code::kNegativeTime, time.place,
      fmt::format("{} needs a time of 0s or more; this is {}", word, described(time)));
}

}  // namespace rob::lang
