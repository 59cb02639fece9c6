#pragma once

#include <string_view>
#include <vector>

#include "lang/check/expression_checker.h"
#include "lang/check/routine_uses.h"
#include "lang/check/value_checker.h"
#include "lang/syntax/ast.h"
#include "lang/text/diagnostic.h"

namespace rob::lang {

/// Settles what may be looked at in every control cycle: conditions of signals, constants,
/// variables and built-in functions. No routine of the program is called there, and no text is
/// made.
class WatchChecker {
 public:
  WatchChecker(ExpressionChecker& expressions, ValueChecker& values, Diagnostics& diagnostics)
      : expressions_(expressions), values_(values), diagnostics_(diagnostics) {}

  /// The condition of an UNTIL; null where it could not be read.
  void check_until(const ExprPtr& condition);
  /// The condition of a WHEN, and what it does, which has been checked as a statement before.
  void check_when(const When& when);
  /// The pace of an AT LIVE, which has been checked as that of an AT before.
  void check_live(const Expr& pace);
  /// A path event; its action has been checked as a statement before.
  void check_event(const WayPoint& event);

 private:
  bool check_condition(const ExprPtr& condition, std::string_view word);
  void check_action(const Statement& action, std::string_view word);
  bool check_watchable(const Expr& expression, std::string_view word);
  bool check_parts(const Expr& expression, std::string_view word);
  bool check_element(const Expr& expression, const Index& index, std::string_view word);
  bool check_call(const Call& call, Place place, std::string_view word);
  bool refuse(std::string_view code, Place place, std::string_view word, std::string_view what,
              const char* help);

  ExpressionChecker& expressions_;
  ValueChecker& values_;
  Diagnostics& diagnostics_;
};

/// Settles what a WAIT waits for: a time, or a condition that reads signals. Its
/// ELSE is not looked at.
class WaitChecker {
 public:
  WaitChecker(ExpressionChecker& expressions, ValueChecker& values, Diagnostics& diagnostics)
      : expressions_(expressions), values_(values), diagnostics_(diagnostics) {}

  /// `routine`: that it belongs to; null at the top level.
  void check(Wait& wait, const Routine* routine);
  /// Where all is checked, and it is known what TASKs change: a WAIT for what nothing can change.
  void report_hopeless(const RoutineUses& uses);

 private:
  void check_time(const Wait& wait);
  struct Condition {
    const Expr* expression;
    const Routine* routine;
  };

  ExpressionChecker& expressions_;
  ValueChecker& values_;
  Diagnostics& diagnostics_;
  std::vector<Condition> hopeless_;  ///< read nothing from the world
};

}  // namespace rob::lang
