#pragma once

#include "lang/code/code_builder.h"
#include "lang/compile/operand_code.h"
#include "lang/compile/variables.h"
#include "lang/syntax/ast.h"

namespace rob::lang {

/// An operation of numbers that is one instruction with a constant, or with an operation on one of
/// its sides. False, and no code, if there is no such instruction.
bool compile_joined(CodeBuilder& code, const Variables& variables, OperandCode& operands,
                    const Binary& binary, const Expr& expression, Register target);

}  // namespace rob::lang
