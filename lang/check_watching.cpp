#include <algorithm>

#include <fmt/core.h>

#include "lang/ascii.h"
#include "lang/codes.h"
#include "lang/fold.h"
#include "lang/observations.h"
#include "lang/watch_checker.h"

namespace rob::lang {

void WatchChecker::check_until(const ExprPtr& condition) {
  if (!check_condition(condition, "UNTIL") || observations(*condition) > 0) return;
  diagnostics_.warning(code::kNothingToWatch, condition->place,
                       "nothing in this condition can change while the robot moves",
                       "name a signal, as in UNTIL touched");
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
