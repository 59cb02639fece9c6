#include "lang/check/watch_checker.h"

#include <algorithm>

#include <fmt/core.h>

#include "lang/check/fold.h"
#include "lang/check/meaning.h"
#include "lang/check/symbols.h"
#include "lang/machine/machine.h"
#include "lang/text/ascii.h"
#include "lang/text/codes.h"

namespace rob::lang {

void WatchChecker::check_until(const ExprPtr& condition) {
  if (!check_condition(condition, "UNTIL") || observations(*condition) > 0) return;
  diagnostics_.warning(code::kNothingToWatch, condition->place,
                       "nothing in this condition can change while the robot moves",
                       "name a signal, as in UNTIL touched");
}

void WatchChecker::check_when(const When& when) {
  if (check_condition(when.condition, "WHEN") && observations(*when.condition) == 0) {
    diagnostics_.error(code::kNothingToWatchFor, when.condition->place,
                       "WHEN has nothing to watch: this condition reads nothing from the world",
                       "name a signal, as in WHEN door : lift = OFF");
  }
  if (!when.handled && !when.action.empty()) check_action(when.action.front(), "WHEN");
}

void WatchChecker::check_live(const Expr& pace) {
  if (!check_watchable(pace, "the speed of AT LIVE") || observations(pace) > 0) return;
  diagnostics_.warning(code::kNothingLive, pace.place,
                       "nothing in this speed can change while the robot moves", "leave LIVE out");
}

void WatchChecker::check_event(const WayPoint& event) {
  const auto check = [&](const ExprPtr& value, Type wanted, const char* word) {
    if (value == nullptr) return;
    expressions_.check(value);
    if (!values_.accept(*value, wanted, std::string(word) + " needs")) return;
    const auto number = constant_number(*value);
    const bool time = wanted == Type::real(kTime);
    if (!number || (*number >= 0 && (!time || *number <= kLongestLead))) return;
    diagnostics_.error(
        code::kPlaceUnsound, value->place,
        time ? fmt::format("{} is 0s to {}s; this is {}", word, kLongestLead, described(*value))
             : fmt::format("{} counts along the motion, from 0mm on; this is {}", word,
                           described(*value)));
  };
  check(event.distance, Type::real(kLength), event.before ? "BEFORE" : "AFTER");
  check(event.shift, Type::real(kTime), event.lag ? "LAG" : "LEAD");
  if (!event.action.empty()) {
    check_action(event.action.front(), event.before ? "BEFORE" : "AFTER");
  }
}

/// The action is done in the control cycle itself, with a value that is fixed beforehand.
void WatchChecker::check_action(const Statement& action, std::string_view word) {
  const Expr* value = nullptr;
  bool sound = false;
  if (const auto* const assign = std::get_if<Assign>(&action.node)) {
    const auto* const name = std::get_if<Name>(&assign->target->node);
    const Symbol* const target = name != nullptr ? name->symbol : nullptr;
    sound = target == nullptr || (target->kind == Symbol::Kind::Signal && target->group == 0);
    value = assign->value.get();
  } else if (const auto* const pulse = std::get_if<Pulse>(&action.node)) {
    sound = true;
    value = pulse->time.get();
  } else if (const auto* const raise = std::get_if<Raise>(&action.node)) {
    sound = word == "WHEN" && raise->value != nullptr;
    value = raise->value.get();
  }
  if (!sound) {
    diagnostics_.error(
        code::kActionMisplaced, action.place,
        fmt::format("this cannot be done in the control cycle itself, as {} does it", word),
        word == "WHEN" ? "after ':' an output is set or pulsed, or an error raised: "
                         "lift = OFF, PULSE lift 50ms, RAISE \"door\"; DO … ENDWHEN does all else"
                       : "after ':' an output is set or pulsed: lift = OFF, PULSE lift 50ms");
  } else if (value != nullptr && (calls_routine(*value) || observations(*value) > 0)) {
    diagnostics_.error(code::kActionNotFixed, value->place,
                       fmt::format("the value is fixed when {} is executed: it cannot read a "
                                   "signal or call a routine of the program",
                                   word),
                       "give the value a variable before");
  }
}

/// False where there is nothing sound to be watched.
bool WatchChecker::check_condition(const ExprPtr& condition, std::string_view word) {
  expressions_.check_condition(condition, word);
  if (condition == nullptr || condition->type != Type::boolean()) return false;
  return check_watchable(*condition, fmt::format("the condition of {}", word));
}

bool WatchChecker::refuse(std::string_view code, Place place, std::string_view word,
                          std::string_view what, const char* help) {
  diagnostics_.error(code, place,
                     fmt::format("{} is computed in every control cycle: {}", word, what), help);
  return false;
}

bool WatchChecker::check_watchable(const Expr& expression, std::string_view word) {
  if (known(expression.constant)) return true;
  if (expression.type.kind == Type::Kind::String) {
    return refuse(code::kNotWatchable, expression.place, word, "it cannot work with texts",
                  "give the answer a variable before, and watch that");
  }
  if (expression.type.is_row()) {
    return refuse(code::kNotWatchable, expression.place, word, "it cannot work with a whole LIST",
                  "give the answer a variable before, and watch that");
  }
  if (const auto* const call = std::get_if<Call>(&expression.node)) {
    return check_call(*call, expression.place, word);
  }
  return check_parts(expression, word);
}

bool WatchChecker::check_call(const Call& call, Place place, std::string_view word) {
  if (call.routine != nullptr) {
    return refuse(code::kWatchCallsRoutine, place, word, "it cannot call a routine of the program",
                  "write the condition itself here");
  }
  if (call.record != nullptr) {
    return refuse(code::kNotWatchable, place, word, "it cannot build a record",
                  "give the answer a variable before, and watch that");
  }
  const Builtin* const builtin = find_builtin(call);
  if (builtin == nullptr) return false;  // has been reported
  const BuiltinRule rule = builtin->rule;
  const bool axes =
      rule == BuiltinRule::Forward || (rule == BuiltinRule::Joints && !call.arguments.empty() &&
                                       call.arguments.front()->type.is_place());
  const bool row = rule == BuiltinRule::RowNumber || rule == BuiltinRule::Split ||
                   rule == BuiltinRule::Join ||
                   (rule == BuiltinRule::ArrayLength && call.arguments.front()->type.is_row());
  if (row) {
    return refuse(code::kNotWatchable, place, word, "it cannot go through all elements",
                  "give the answer a variable before, and watch that");
  }
  if (rule == BuiltinRule::FileExists) {
    return refuse(code::kNotWatchable, place, word, "it cannot look for a file",
                  "give the answer a variable before, and watch that");
  }
  if (rule == BuiltinRule::Unix) {
    return refuse(code::kNotWatchable, place, word, "it cannot read the calendar",
                  "CLOCK counts from the start of the program");
  }
  if (rule == BuiltinRule::Random || axes) {
    return refuse(code::kNotWatchable, place, word,
                  axes ? "it cannot compute axes from a pose, or a pose from axes"
                       : "it cannot draw random numbers",
                  "give the answer a variable before, and watch that");
  }
  return std::ranges::all_of(
      call.arguments, [&](const ExprPtr& argument) { return check_watchable(*argument, word); });
}

/// An element of a variable is fixed as a whole, and its index computed with it.
bool WatchChecker::check_element(const Expr& expression, const Index& index,
                                 std::string_view word) {
  if (known(index.index->constant) && !index.object->type.is_row()) {
    return check_watchable(*index.object, word);
  }
  if (calls_routine(expression)) {
    return refuse(code::kWatchCallsRoutine, expression.place, word,
                  "it cannot call a routine of the program",
                  "give the answer a variable before, and watch that");
  }
  const bool variable = root_of(expression) != nullptr && observations(*index.object) == 0;
  if (variable && observations(*index.index) == 0) return true;
  return refuse(code::kNotWatchable, index.index->place, word,
                variable ? "which element is meant cannot be read from the robot"
                         : "which part of what is read or computed is meant must be a constant",
                "give the index or the element a variable before, and watch that");
}

bool WatchChecker::check_parts(const Expr& expression, std::string_view word) {
  if (const auto* const index = std::get_if<Index>(&expression.node)) {
    return check_element(expression, *index, word);
  }
  if (std::holds_alternative<List>(expression.node)) return true;
  bool sound = true;
  each_part(expression, [&](const Expr& part) { sound = sound && check_watchable(part, word); });
  return sound;
}

void WaitChecker::check(Wait& wait, const Routine* routine) {
  const Type type = expressions_.check(wait.value);
  if (wait.timeout != nullptr) {
    expressions_.check(wait.timeout);
    values_.accept(*wait.timeout, Type::real(kTime), "TIMEOUT needs");
    values_.require_time(*wait.timeout, "TIMEOUT");
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
  values_.require_time(*wait.value, "WAIT");
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

}  // namespace rob::lang
