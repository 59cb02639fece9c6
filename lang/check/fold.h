#pragma once

#include <span>
#include <string>
#include <vector>

#include "lang/syntax/ast.h"
#include "lang/values/arithmetic.h"
#include "lang/values/builtins.h"
#include "lang/values/value_text.h"

/// Values that are known before the program runs. The functions compute with those of
/// arithmetic.h, as the Vm does; types have been checked before. Texts are not joined here: a
/// short program could make the compiler hold gigabytes of them.
namespace rob::lang {

struct Folded {
  ArithmeticError error = ArithmeticError::None;
  Constant value;  ///< empty if there was an error, or if the value must be computed at run time
};

inline bool known(const Constant& constant) { return constant.index() != 0; }

/// INT to REAL where a REAL is wanted; anything else as it is.
Constant converted(const Constant& constant, const Type& wanted);
/// The slot that holds a constant BOOL, INT or REAL.
Slot to_slot(const Constant& constant);
/// All number slots of a constant that is no text.
std::vector<Slot> to_slots(const Constant& constant);
Constant constant_of(const PoseValue& pose);
/// The value of a constant as its place wants it: of a pose that was moved, in the world.
Constant known_value(const Expr& expression);
/// A value as PRINT writes it. `type` gives the dimension.
std::string text_of(const Constant& constant, const Type& type);

Folded fold(UnaryOp op, const Constant& operand);
/// Both operands are of one type: BOOL, INT, REAL or STRING; those of AND and OR may be unknown.
/// `result` is the type that the checker gave the operation: it distinguishes INT `^` from REAL
/// `^`.
Folded fold(BinaryOp op, const Constant& left, const Constant& right, const Type& result);
/// All arguments are INT, or all are REAL or made of REALs, as `function` wants them.
Folded fold(BuiltinFunction function, std::span<const Constant> arguments, const Type& result);

}  // namespace rob::lang
