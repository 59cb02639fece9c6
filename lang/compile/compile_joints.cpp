#include "lang/compile/expression_compiler.h"

/// Member functions of ExpressionCompiler for JOINTS, and for what is read of the robot.
namespace rob::lang {
namespace {

Instruction count_word(int count) { return {static_cast<std::uint32_t>(count)}; }

}  // namespace

void ExpressionCompiler::read(Reading reading, Register target, Place place) {
  if (reading == Reading::Clock) code_.depends_on_time();
  code_.emit(Opcode::read, place, target, static_cast<unsigned>(reading), latched_ ? 1 : 0);
}

/// JOINTS(q1, …, qn), into registers of its own first, as a tuple; or JOINTS of a pose.
void ExpressionCompiler::compile_joints(const Call& call, const Expr& expression, Register target) {
  const int count = slots_of(expression.type).numbers;
  const Expr& first = *call.arguments.front();
  if (first.type.is_place()) {
    const Expr& last = *call.arguments.back();
    const Register pose = operand_before(last, first, false);
    const Register near = &last == &first ? pose : operand(last, false);
    code_.emit(Opcode::inverse, expression.place, target, pose, near);
    return code_.emit(count_word(count), expression.place);
  }
  const Register values = code_.number_registers(count);
  Register next = values;
  for (const ExprPtr& value : call.arguments) into(*value, next++, true);
  copy_registers(target, values, count, expression.place);
}

void ExpressionCompiler::compile_forward(const Call& call, const Expr& expression,
                                         Register target) {
  const Expr& joints = *call.arguments.front();
  code_.emit(Opcode::forward, expression.place, target, operand(joints, false),
             static_cast<unsigned>(slots_of(joints.type).numbers));
}

}  // namespace rob::lang
