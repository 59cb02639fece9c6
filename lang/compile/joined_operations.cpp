#include "lang/compile/joined_operations.h"

#include "lang/check/fold.h"
#include "lang/check/meaning.h"
#include "lang/compile/operations.h"

namespace rob::lang {
namespace {

/// An operation with a constant, where there is one: what is on its left may stand on its right
/// where the order is no matter.
bool compile_by_constant(CodeBuilder& code, OperandCode& operands, const Binary& binary,
                         const Expr& expression, Register target) {
  const bool whole = on_whole_numbers(binary, expression.type);
  const std::optional<Opcode> op = constant_opcode(binary.op, whole);
  if (!op) return false;
  const bool exchanged = known(binary.left->constant);
  if (exchanged && binary.op != BinaryOp::Add && binary.op != BinaryOp::Multiply) return false;
  const Expr& variable = exchanged ? *binary.right : *binary.left;
  const auto constant = constant_operand(code, exchanged ? *binary.left : *binary.right, !whole);
  if (!constant) return false;
  code.emit(*op, expression.place, target, operands.operand(variable, !whole), *constant);
  return true;
}

/// The term that is added to a product on its left is read after it, so it must be there already:
/// one that could fail would have to wait for the product.
bool compile_with_product(CodeBuilder& code, const Variables& variables, OperandCode& operands,
                          const Binary& binary, const Expr& expression, Register target) {
  if (variables.watching() || (binary.op != BinaryOp::Add && binary.op != BinaryOp::Subtract))
    return false;
  const bool whole = on_whole_numbers(binary, expression.type);
  const Expr* factors = binary.right.get();
  const Binary* product = product_in(*factors, whole);
  const bool exchanged = product == nullptr;
  if (exchanged) {
    const bool whole_right = binary.right->type == Type::integer();
    factors = binary.left.get();
    product = product_in(*factors, whole);
    if (product == nullptr || binary.op != BinaryOp::Add || whole_right != whole ||
        !variables.stays_in_register(*binary.right)) {
      return false;
    }
  }
  Register term = exchanged ? 0 : operands.operand_before(*factors, *binary.left, !whole);
  const Register first = operands.operand_before(*product->right, *product->left, !whole);
  const Register second = operands.operand(*product->right, !whole);
  if (exchanged) term = operands.operand(*binary.right, !whole);
  code.emit(product_opcode(binary.op, whole), factors->place, target, term, first);
  code.emit(Instruction{second}, expression.place);
  return true;
}

/// The sum of two products, or their difference. One instruction computes the
/// right product and the sum, so computing its factors must not fail.
bool compile_of_products(CodeBuilder& code, const Variables& variables, OperandCode& operands,
                         const Binary& binary, const Expr& expression, Register target) {
  if (variables.watching() || (binary.op != BinaryOp::Add && binary.op != BinaryOp::Subtract))
    return false;
  const Binary* const left = product_in(*binary.left, false);
  const Binary* const right = product_in(*binary.right, false);
  if (left == nullptr || right == nullptr || !variables.stays_in_register(*right->left) ||
      !variables.stays_in_register(*right->right)) {
    return false;
  }
  const Register first = operands.operand_before(*left->right, *left->left, true);
  const Register second = operands.operand(*left->right, true);
  const Register third = operands.operand(*right->left, true);
  const Register fourth = operands.operand(*right->right, true);
  code.emit(binary.op == BinaryOp::Add ? Opcode::add_products_real : Opcode::sub_products_real,
            binary.left->place, target, first, second);
  code.emit(Instruction{third}, binary.right->place);
  code.emit(Instruction{fourth}, expression.place);
  return true;
}

/// a + b - c of REALs. One instruction adds all three, so computing c must not fail.
bool compile_of_three(CodeBuilder& code, const Variables& variables, OperandCode& operands,
                      const Binary& binary, const Expr& expression, Register target) {
  const auto* const left = std::get_if<Binary>(&binary.left->node);
  const auto sums = [](BinaryOp op) { return op == BinaryOp::Add || op == BinaryOp::Subtract; };
  if (variables.watching() || left == nullptr || !sums(binary.op) || !sums(left->op)) return false;
  if (known(binary.left->constant) || known(left->left->constant) || known(left->right->constant) ||
      on_whole_numbers(*left, binary.left->type) || on_whole_numbers(binary, expression.type) ||
      product_in(*left->left, false) != nullptr || product_in(*left->right, false) != nullptr ||
      binary.right->type == Type::integer() || !variables.stays_in_register(*binary.right)) {
    return false;
  }
  const Register first = operands.operand_before(*left->right, *left->left, true);
  const Register second = operands.operand(*left->right, true);
  code.emit(sum_opcode(left->op, binary.op), binary.left->place, target, first, second);
  code.emit(Instruction{operands.operand(*binary.right, true)}, expression.place);
  return true;
}

}  // namespace

bool compile_joined(CodeBuilder& code, const Variables& variables, OperandCode& operands,
                    const Binary& binary, const Expr& expression, Register target) {
  return compile_by_constant(code, operands, binary, expression, target) ||
         compile_of_products(code, variables, operands, binary, expression, target) ||
         compile_with_product(code, variables, operands, binary, expression, target) ||
         compile_of_three(code, variables, operands, binary, expression, target);
}

}  // namespace rob::lang
