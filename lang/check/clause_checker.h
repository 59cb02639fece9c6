#pragma once

#include <string_view>

#include "lang/check/expression_checker.h"
#include "lang/check/value_checker.h"
#include "lang/syntax/ast.h"
#include "lang/text/diagnostic.h"

namespace rob::lang {

/// Checks the clauses after a motion.
///
/// A dimensionless AT is a share of all maxima, and the program has to show that it is meant as
/// one: `AT 50%`, or a REAL variable as in `AT slow`. An INT, or an expression of nothing but bare
/// literals, is refused, since `AT 50` is far more likely to be a speed without its unit. The same
/// holds for ZONE, but for `ZONE 0`.
class ClauseChecker {
 public:
  ClauseChecker(ExpressionChecker& expressions, ValueChecker& values, Diagnostics& diagnostics)
      : expressions_(expressions), values_(values), diagnostics_(diagnostics) {}

  /// `place`: of the motion.
  bool check(const Clauses& clauses, Place place);
  /// Clauses of WITH or DEFAULT (`word`), for motions without their own. Also the
  /// surroundings.
  void check_defaults(const Clauses& clauses, std::string_view word, Place place);
  /// WITH names a TOOL, IN a FRAME.
  bool check(const Surroundings& surroundings);
  void check_override(const ExprPtr& share);

 private:
  bool check(Clause clause, const Expr& value);
  bool check_at(const Expr& at);
  bool check_bound(const Expr& value, std::string_view word, std::string_view needed,
                   std::string_view example, bool fits);
  bool check_zone(const Expr& zone);
  bool check_fine(const Expr& distance);
  bool check_positive(const Expr& value, std::string_view word);

  ExpressionChecker& expressions_;
  ValueChecker& values_;
  Diagnostics& diagnostics_;
};

}  // namespace rob::lang
