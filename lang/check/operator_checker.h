#pragma once

#include "lang/check/value_checker.h"
#include "lang/syntax/ast.h"
#include "lang/text/diagnostic.h"

namespace rob::lang {

/// Settles what operators make of operands that have been checked: which types they take, what
/// type results, and its value where those of the operands are known.
class OperatorChecker {
 public:
  OperatorChecker(ValueChecker& values, Diagnostics& diagnostics)
      : values_(values), diagnostics_(diagnostics) {}

  Type check(const Unary& unary, Expr& expression);
  /// All but AND, OR and XOR.
  Type check(const Binary& binary, Expr& expression);

 private:
  Type type_of(const Binary& binary, const Expr& expression);
  Type check_comparison(const Binary& binary, const Expr& expression);
  Type check_sum(const Binary& binary, const Expr& expression);
  Type check_product(const Binary& binary, const Expr& expression);
  Type check_bits(const Binary& binary);
  Type check_division(const Binary& binary, const Expr& expression);
  Type check_power(const Binary& binary, const Expr& expression);
  Type check_pose_sum(const Binary& binary, const Expr& expression);
  Type check_pose_product(const Binary& binary, const Expr& expression);
  bool both_numbers(const Binary& binary);
  Type unlike(const Binary& binary, const Expr& expression);
  void fold_known(const Binary& binary, Expr& expression);

  ValueChecker& values_;
  Diagnostics& diagnostics_;
};

}  // namespace rob::lang
