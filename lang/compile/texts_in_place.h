#pragma once

#include "lang/code/code_builder.h"
#include "lang/compile/operand_code.h"
#include "lang/syntax/ast.h"
#include "lang/values/builtins.h"

/// Code for texts that are read, or grow, where they lie.
namespace rob::lang {

/// A term of a sum of texts, added to the text in a register.
void append_term(CodeBuilder& code, OperandCode& operands, const Expr& term, Register sum,
                 Place place);
/// LEN, FIND and MID of a text. False, and no code, if it is another function.
bool look_into_text(CodeBuilder& code, OperandCode& operands, const Builtin& builtin,
                    const Call& call, Register target, Place place);
/// Jumps that are taken if a comparison of texts comes out as `when`.
CodeBuilder::Jumps jumps_of_texts(CodeBuilder& code, OperandCode& operands, const Binary& binary,
                                  bool when, Place place);

}  // namespace rob::lang
