#pragma once

#include "lang/ast.h"
#include "lang/diagnostic.h"
#include "lang/expression_checker.h"

namespace rob::lang {

/// Settles what a WAIT waits for: a time, or a condition that reads signals. What stands behind its
/// ELSE is not looked at.
class WaitChecker {
 public:
  WaitChecker(ExpressionChecker& expressions, Diagnostics& diagnostics)
      : expressions_(expressions), diagnostics_(diagnostics) {}

  void check(Wait& wait);

 private:
  void check_time(const Wait& wait);
  void check_condition(const Wait& wait);
  void check_not_negative(const Expr& time, const char* word);

  ExpressionChecker& expressions_;
  Diagnostics& diagnostics_;
};

}  // namespace rob::lang
