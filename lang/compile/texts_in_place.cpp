#include "lang/compile/texts_in_place.h"

#include <string>

#include "lang/check/fold.h"
#include "lang/check/meaning.h"
#include "lang/compile/operations.h"

namespace rob::lang {

void append_term(CodeBuilder& code, OperandCode& operands, const Expr& term, Register sum,
                 Place place) {
  if (const auto* const text = std::get_if<std::string>(&term.constant)) {
    return code.with_text(Opcode::append_constant, sum, 0, *text, place);
  }
  const auto* const call = std::get_if<Call>(&term.node);
  const bool str = call != nullptr && call->routine == nullptr && call->record == nullptr &&
                   find_builtin(*call)->rule == BuiltinRule::AnyToText;
  if (str && call->arguments.front()->type.scalar()) {
    const Expr& value = *call->arguments.front();
    return append_register(code, operands.operand(value, false), value.type, false, sum, place);
  }
  code.emit(Opcode::join_text, place, sum, sum, operands.operand(term, false));
}

bool look_into_text(CodeBuilder& code, OperandCode& operands, const Builtin& builtin,
                    const Call& call, Register target, Place place) {
  if (builtin.rule != BuiltinRule::Texts) return false;
  const auto argument = [&](std::size_t i) -> const Expr& { return *call.arguments[i]; };
  if (builtin.name == "LEN") {
    code.emit(Opcode::text_length, place, target, operands.operand(argument(0), false));
  } else if (builtin.name == "FIND") {
    const Register text = operands.operand_before(argument(1), argument(0), false);
    code.emit(Opcode::text_find, place, target, text, operands.operand(argument(1), false));
  } else if (builtin.name == "MID") {
    const Expr& caller = calls_routine(argument(1)) ? argument(1) : argument(2);
    const Register text = operands.operand_before(caller, argument(0), false);
    const Register range = code.frame().number_registers(2);
    operands.into(argument(1), range, false);
    operands.into(argument(2), behind(range, 1), false);
    code.emit(Opcode::text_middle, place, target, text, range);
  } else {
    return false;
  }
  return true;
}

CodeBuilder::Jumps jumps_of_texts(CodeBuilder& code, OperandCode& operands, const Binary& binary,
                                  bool when, Place place) {
  if (binary.op == BinaryOp::Equal || binary.op == BinaryOp::NotEqual) {
    const bool exchanged = known(binary.left->constant);
    const Expr& constant = exchanged ? *binary.left : *binary.right;
    if (const auto* const text = std::get_if<std::string>(&constant.constant)) {
      const Register variable = operands.operand(exchanged ? *binary.right : *binary.left, false);
      return {compare_known_text(code, binary.op, variable, *text, when, place)};
    }
  }
  const Register left = operands.operand_before(*binary.right, *binary.left, false);
  const Register right = operands.operand(*binary.right, false);
  return compare_texts(code, binary.op, left, right, when, place);
}

}  // namespace rob::lang
