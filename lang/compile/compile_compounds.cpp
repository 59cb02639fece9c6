#include "lang/check/routine.h"
#include "lang/compile/expression_compiler.h"

/// Member functions of ExpressionCompiler that compute with values of several slots, part by part.
namespace rob::lang {
namespace {

constexpr int kParts = 3;  // of a VEC

Register part(Register first, int i) { return static_cast<Register>(first + i); }

}  // namespace

/// Into registers of its own first: a component may be computed from what lies in the target.
void ExpressionCompiler::compile(const Tuple& tuple, Register target) {
  const Register first = code_.number_registers(kParts);
  for (int i = 0; i < kParts; ++i) {
    into(*tuple.elements[static_cast<std::size_t>(i)].value, part(first, i), true);
  }
  copy_registers(target, first, kParts, tuple.elements.front().place);
}

/// VEC + VEC, VEC - VEC, number * VEC, VEC * number, VEC / number; the same of JOINTS. The number
/// is not read in place: it may be a part of the target.
void ExpressionCompiler::compile_vector(const Binary& binary, const Expr& expression,
                                        Register target) {
  const auto side = [&](const Expr& operand_expression) {
    if (!operand_expression.type.numeric()) return operand(operand_expression, false);
    const Register number = code_.number_registers();
    into(operand_expression, number, true);
    return number;
  };
  Register left = 0;
  if (calls_routine(*binary.right) && !binary.left->type.numeric()) {
    left = result_register(binary.left->type);
    into(*binary.left, left, false);
  } else {
    left = side(*binary.left);
  }
  const Register right = side(*binary.right);
  const int left_step = binary.left->type.numeric() ? 0 : 1;
  const int right_step = binary.right->type.numeric() ? 0 : 1;
  const int parts = slots_of(expression.type).numbers;
  for (int i = 0; i < parts; ++i) {
    code_.emit(real_opcode(binary.op), expression.place, part(target, i), part(left, i * left_step),
               part(right, i * right_step));
  }
}

void ExpressionCompiler::negate_vector(const Unary& unary, const Expr& expression,
                                       Register target) {
  const Register from = operand(*unary.operand, false);
  for (int i = 0; i < kParts; ++i) {
    code_.emit(Opcode::neg_real, expression.place, part(target, i), part(from, i));
  }
}

/// There is no -0 and nothing that is not a number, so values are equal where their slots are.
CodeBuilder::Jumps ExpressionCompiler::jumps_of_compounds(const Binary& binary, bool when,
                                                          Place place) {
  if (!binary.left->type.in_registers()) return jumps_of_memory(binary, when, place);
  const int count = slots_of(binary.left->type).numbers;
  Register left = 0;
  if (calls_routine(*binary.right)) {
    left = result_register(binary.left->type);
    into(*binary.left, left, false);
  } else {
    left = operand(*binary.left, false);
  }
  const Register right = operand(*binary.right, false);
  const Register truth = code_.number_registers();
  code_.emit(Opcode::equal_block, place, truth, left, right);
  code_.emit(Instruction{static_cast<std::uint32_t>(count)}, place);
  return {jump_if(truth, when == (binary.op == BinaryOp::Equal), place)};
}

void ExpressionCompiler::append_compound(const Expr& expression, Register text) {
  const auto mark = code_.mark();
  if (!expression.type.in_registers()) {
    code_.append_memory(text, refer_whole(expression), expression.type, expression.place);
    return code_.release(mark);
  }
  code_.append_value(text, operand(expression, false), expression.type, expression.place);
  code_.release(mark);
}

}  // namespace rob::lang
