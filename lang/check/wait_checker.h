#pragma once

#include <vector>

#include "lang/check/expression_checker.h"
#include "lang/check/routine_uses.h"
#include "lang/syntax/ast.h"
#include "lang/text/diagnostic.h"

namespace rob::lang {

/// Settles what a WAIT waits for: a time, or a condition that reads signals. What stands behind its
/// ELSE is not looked at.
class WaitChecker {
 public:
  WaitChecker(ExpressionChecker& expressions, Diagnostics& diagnostics)
      : expressions_(expressions), diagnostics_(diagnostics) {}

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
  void check_not_negative(const Expr& time, const char* word);

  ExpressionChecker& expressions_;
  Diagnostics& diagnostics_;
  std::vector<Condition> hopeless_;  ///< read nothing from the world
};

}  // namespace rob::lang
