#include <algorithm>

#include <fmt/core.h>

#include "lang/ascii.h"
#include "lang/codes.h"
#include "lang/fold.h"
#include "lang/machine.h"
#include "lang/observations.h"
#include "lang/routine.h"
#include "lang/symbols.h"
#include "lang/target.h"
#include "lang/watch_checker.h"

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
  if (!when.action.empty()) check_action(when.action.front(), "WHEN");
}

void WatchChecker::check_event(const WayPoint& event) {
  const auto check = [&](const ExprPtr& value, Type wanted, const char* word) {
    if (value == nullptr) return;
    expressions_.check(value);
    if (!expressions_.accept(*value, wanted, std::string(word) + " needs")) return;
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

/// What may be done in the control cycle itself, with a value that is fixed beforehand.
void WatchChecker::check_action(const Statement& action, std::string_view word) {
  const Expr* value = nullptr;
  bool sound = false;
  if (const auto* const assign = std::get_if<Assign>(&action.node)) {
    const auto* const name = std::get_if<Name>(&assign->target->node);
    const Symbol* const target = name != nullptr ? name->symbol : nullptr;
    sound = target == nullptr || target->kind == Symbol::Kind::Signal;
    value = assign->value.get();
  } else if (const auto* const pulse = std::get_if<Pulse>(&action.node)) {
    sound = true;
    value = pulse->time.get();
  } else if (const auto* const raise = std::get_if<Raise>(&action.node)) {
    sound = word == "WHEN" && raise->value != nullptr;
    value = raise->value.get();
  }
  const bool brake = std::holds_alternative<Brake>(action.node);
  if (word == "WHEN" && (brake || std::holds_alternative<Halt>(action.node))) {
    diagnostics_.error(
        code::kNotYet, action.place,
        fmt::format("{} behind WHEN is not in this version of Rob yet", brake ? "BRAKE" : "HALT"));
  } else if (!sound) {
    diagnostics_.error(
        code::kActionMisplaced, action.place,
        fmt::format("this cannot be done in the control cycle itself, as {} does it", word),
        word == "WHEN" ? "behind ':' an output is set or pulsed, or an error raised: "
                         "lift = OFF, PULSE lift 50ms, RAISE \"door\""
                       : "behind ':' an output is set or pulsed: lift = OFF, PULSE lift 50ms");
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
  return check_watchable(*condition, word);
}

bool WatchChecker::check_watchable(const Expr& expression, std::string_view word) {
  if (known(expression.constant)) return true;
  const auto refuse = [&](std::string_view code, std::string_view what, const char* help) {
    diagnostics_.error(
        code, expression.place,
        fmt::format("the condition of {} is looked at in every control cycle: {}", word, what),
        help);
    return false;
  };
  if (expression.type.kind == Type::Kind::String) {
    return refuse(code::kNotWatchable, "it cannot work with texts",
                  "give the answer a variable before, and watch that");
  }
  if (!expression.type.scalar() || std::holds_alternative<Member>(expression.node) ||
      std::holds_alternative<Index>(expression.node)) {
    return refuse(code::kNotWatchable, "it works with single values",
                  "give the part a variable before, and watch that");
  }
  if (const auto* const name = std::get_if<Name>(&expression.node);
      name != nullptr && name->symbol != nullptr && name->symbol->kind == Symbol::Kind::Reading) {
    diagnostics_.error(code::kNotYet, expression.place,
                       fmt::format("{} in the condition of {} is not in this version of Rob yet",
                                   name->symbol->name, word));
    return false;
  }
  if (const auto* const call = std::get_if<Call>(&expression.node)) {
    if (same_word(call->callee, "RANDOM") && call->routine == nullptr) {
      return refuse(code::kNotWatchable, "it cannot draw random numbers",
                    "give the answer a variable before, and watch that");
    }
    if (call->routine != nullptr) {
      return refuse(code::kWatchCallsRoutine, "it cannot call a routine of the program",
                    "write the condition itself here");
    }
    return std::ranges::all_of(
        call->arguments, [&](const ExprPtr& argument) { return check_watchable(*argument, word); });
  }
  if (const auto* const unary = std::get_if<Unary>(&expression.node)) {
    return check_watchable(*unary->operand, word);
  }
  if (const auto* const binary = std::get_if<Binary>(&expression.node)) {
    return check_watchable(*binary->left, word) && check_watchable(*binary->right, word);
  }
  return true;
}

}  // namespace rob::lang
