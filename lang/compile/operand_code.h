#pragma once

#include "lang/code/frame_slots.h"
#include "lang/syntax/expression_tree.h"

namespace rob::lang {

/// Code for the parts of an expression, for those that make code of what joins them. With `as_real`
/// an INT becomes a REAL.
class OperandCode {
 public:
  /// Into a register that is given.
  virtual void into(const Expr& expression, Register target, bool as_real) = 0;
  /// The register of a variable, or a new one with the value of the expression.
  virtual Register operand(const Expr& expression, bool as_real) = 0;
  /// The same before the code of `then`, which may change that variable.
  virtual Register operand_before(const Expr& then, const Expr& expression, bool as_real) = 0;

 protected:
  ~OperandCode() = default;
};

}  // namespace rob::lang
