#include <algorithm>

#include "lang/compile/expression_compiler.h"

/// Member functions of ExpressionCompiler that compute with poses.
namespace rob::lang {
namespace {

constexpr int kPlaceSlots = 3;
constexpr int kTurnSlots = 4;

Register behind(Register first, int slots) { return static_cast<Register>(first + slots); }

}  // namespace

/// A pose in a FRAME, which is a constant, where one in the world is wanted.
void ExpressionCompiler::into_world(const Expr& expression, Register target) {
  const Register frame = code_.number_registers(kPlaceSlots + kTurnSlots);
  const Register pose = code_.number_registers(kPlaceSlots + kTurnSlots);
  Register next = frame;
  for (const double part : std::get<std::vector<double>>(expression.moved_from->value)) {
    code_.load_real(next++, part, kNone, expression.place);
  }
  into_as_it_is(expression, pose, false);
  code_.emit(Opcode::pose_product, expression.place, target, frame, pose);
}

int numbers_of(const Expr& expression) {
  return expression.place_slots != 0 ? expression.place_slots : slots_of(expression.type).numbers;
}

/// A TOOL where a pose is wanted; or a pose as a TOOL, which weighs nothing.
void ExpressionCompiler::into_other_place(const Expr& expression, Register target) {
  const int own = slots_of(expression.type).numbers;
  const int wanted = expression.place_slots;
  const Register value = code_.number_registers(own);
  if (expression.moved_from != nullptr) {
    into_world(expression, value);
  } else {
    into_as_it_is(expression, value, false);
  }
  copy_registers(target, value, std::min(own, wanted), expression.place);
  for (int i = own; i < wanted; ++i) {
    code_.load_real(behind(target, i), 0, kNone, expression.place);
  }
}

/// p + v, p - v, p - q, p * q, p * v.
void ExpressionCompiler::compile_on_places(const Binary& binary, const Expr& expression,
                                           Register target) {
  const Register left = operand_before(*binary.right, *binary.left, false);
  const Register right = operand(*binary.right, false);
  if (binary.op == BinaryOp::Multiply) {
    const Opcode op = binary.right->type.is_place() ? Opcode::pose_product : Opcode::pose_transform;
    code_.emit(op, expression.place, target, left, right);
    return;
  }
  const Opcode op = binary.op == BinaryOp::Add ? Opcode::add_real : Opcode::sub_real;
  for (int i = 0; i < kPlaceSlots; ++i) {
    code_.emit(op, expression.place, behind(target, i), behind(left, i), behind(right, i));
  }
  if (binary.right->type.is_place()) return;
  copy_registers(behind(target, kPlaceSlots), behind(left, kPlaceSlots), kTurnSlots,
                 expression.place);
}

void ExpressionCompiler::compile_angle(const Member& member, Register target, Place place) {
  const Register pose = operand(*member.object, false);
  code_.emit(Opcode::pose_angle, place, target, pose,
             static_cast<unsigned>(*angle_of(member.object->type, member.field)));
}

}  // namespace rob::lang
