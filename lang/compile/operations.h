#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "lang/check/symbols.h"
#include "lang/code/code_builder.h"
#include "lang/machine/robot_signature.h"
#include "lang/syntax/ast.h"

/// Code for operations on values that lie in registers, and on constants: which instructions they
/// take.
namespace rob::lang {

/// The operation on two REALs.
Opcode real_opcode(BinaryOp op);
/// The same on two INTs.
Opcode whole_opcode(BinaryOp op);
/// The operation with a constant on its right, if there is one.
std::optional<Opcode> constant_opcode(BinaryOp op, bool whole);
/// A sum or a difference whose right side is a product.
Opcode product_opcode(BinaryOp op, bool whole);

/// The sum of a sum and a third REAL.
Opcode sum_opcode(BinaryOp first, BinaryOp second);

/// Whether an operation works on INT slots. INT / INT is real, and so is INT ^ INT unless the
/// checker says otherwise.
bool on_whole_numbers(const Binary& binary, const Type& result);
/// A product of two values that must be computed, of INTs or of REALs; null if it is none.
const Binary* product_in(const Expr& expression, bool whole);
/// Whether a comparison is one of REALs.
bool compares_reals(const Binary& binary);

/// The value of a constant expression, into registers. With `as_real` an INT becomes a REAL.
void load_known(CodeBuilder& code, const Expr& expression, Register target, bool as_real);
/// The joints that the points file gives a point.
void load_joints(CodeBuilder& code, const Symbol& point, const RobotSignature& robot,
                 Register first, Place place);
/// A number that is known, as an operand of 8 bits; none if it is not, or there is no room.
std::optional<std::uint8_t> constant_operand(CodeBuilder& code, const Expr& expression,
                                             bool as_real);
/// Appends the value of a register, as PRINT writes it, to a text register. `real`: an INT that has
/// become a REAL.
void append_register(CodeBuilder& code, Register value, const Type& type, bool real, Register text,
                     Place place);

/// Jumps that are taken if a comparison of two registers comes out as `when`. XOR is the inequality
/// of two BOOLs.
CodeBuilder::Jumps compare_numbers(CodeBuilder& code, const Binary& binary, Register left,
                                   Register right, bool when, Place place);
CodeBuilder::Jumps compare_texts(CodeBuilder& code, BinaryOp op, Register left, Register right,
                                 bool when, Place place);
/// The same, == or <>, with a text that is known.
CodeBuilder::Jump compare_known_text(CodeBuilder& code, BinaryOp op, Register text,
                                     const std::string& other, bool when, Place place);
/// The same of a register and a constant operand; `exchanged`: the constant stood on the left.
CodeBuilder::Jumps compare_constant(CodeBuilder& code, const Binary& binary, Register variable,
                                    std::uint8_t constant, bool exchanged, bool when, Place place);
/// A jump that is taken if a BOOL is as `when`.
CodeBuilder::Jump jump_if(CodeBuilder& code, Register truth, bool when, Place place);

}  // namespace rob::lang
