#include <bit>
#include <optional>
#include <string>

#include "lang/check/fold.h"
#include "lang/compile/expression_compiler.h"

/// Member functions of ExpressionCompiler for operations on numbers. They choose the instruction
/// that does most of an operation at once.
namespace rob::lang {
namespace {

Opcode whole_opcode(BinaryOp op) {
  switch (op) {
    case BinaryOp::Add:
      return Opcode::add_int;
    case BinaryOp::Subtract:
      return Opcode::sub_int;
    case BinaryOp::Multiply:
      return Opcode::mul_int;
    case BinaryOp::Div:
      return Opcode::div_int;
    case BinaryOp::Mod:
      return Opcode::mod_int;
    default:
      return Opcode::pow_int;
  }
}

/// The operation with a constant on its right, if there is one.
std::optional<Opcode> constant_opcode(BinaryOp op, bool whole) {
  switch (op) {
    case BinaryOp::Add:
      return whole ? Opcode::add_int_constant : Opcode::add_real_constant;
    case BinaryOp::Subtract:
      return whole ? Opcode::sub_int_constant : Opcode::sub_real_constant;
    case BinaryOp::Multiply:
      return whole ? Opcode::mul_int_constant : Opcode::mul_real_constant;
    case BinaryOp::Divide:
      return whole ? std::nullopt : std::optional(Opcode::quot_real_constant);
    default:
      return std::nullopt;
  }
}

/// Whether an operation works on INT slots. INT / INT is real, and so is INT ^ INT unless the
/// checker says otherwise.
bool on_whole_numbers(const Binary& binary, const Type& result) {
  if (binary.left->type != Type::integer() || binary.right->type != Type::integer()) return false;
  return result.kind == Type::Kind::Int;
}

/// A product of two values that must be computed, of INTs or of REALs.
const Binary* product_in(const Expr& expression, bool whole) {
  const auto* const product = std::get_if<Binary>(&expression.node);
  const bool found = product != nullptr && product->op == BinaryOp::Multiply &&
                     !known(expression.constant) && !known(product->left->constant) &&
                     !known(product->right->constant) &&
                     on_whole_numbers(*product, expression.type) == whole;
  return found ? product : nullptr;
}

Opcode product_opcode(BinaryOp op, bool whole) {
  if (op == BinaryOp::Add) return whole ? Opcode::add_product_int : Opcode::add_product_real;
  return whole ? Opcode::sub_product_int : Opcode::sub_product_real;
}

}  // namespace

Opcode real_opcode(BinaryOp op) {
  switch (op) {
    case BinaryOp::Add:
      return Opcode::add_real;
    case BinaryOp::Subtract:
      return Opcode::sub_real;
    case BinaryOp::Multiply:
      return Opcode::mul_real;
    case BinaryOp::Divide:
      return Opcode::quot_real;
    case BinaryOp::Div:
      return Opcode::div_real;
    case BinaryOp::Mod:
      return Opcode::mod_real;
    default:
      return Opcode::pow_real;
  }
}

void ExpressionCompiler::compile(const Unary& unary, const Expr& expression, Register target) {
  if (unary.op == UnaryOp::Plus) {
    into(*unary.operand, target, false);
    return;
  }
  if (expression.type.is(Type::Kind::Vec)) return negate_vector(unary, expression, target);
  const Opcode op = expression.type == Type::integer() ? Opcode::neg_int : Opcode::neg_real;
  code_.emit(op, expression.place, target, operand(*unary.operand, false));
}

void ExpressionCompiler::compile(const Binary& binary, const Expr& expression, Register target) {
  if (expression.type.is(Type::Kind::String)) {
    const Register left = operand_before(*binary.right, *binary.left, false);
    const Register right = operand(*binary.right, false);
    code_.emit(Opcode::join_text, expression.place, target, left, right);
    return;
  }
  if (binary.left->type.is_place()) return compile_on_places(binary, expression, target);
  if (expression.type.is(Type::Kind::Vec) || expression.type.is(Type::Kind::Joints)) {
    return compile_vector(binary, expression, target);
  }
  if (compile_by_constant(binary, expression, target)) return;
  if (compile_with_product(binary, expression, target)) return;
  // DIV of reals yields an INT from REAL operands.
  const bool whole = on_whole_numbers(binary, expression.type);
  const Register left = operand_before(*binary.right, *binary.left, !whole);
  const Register right = operand(*binary.right, !whole);
  code_.emit(whole ? whole_opcode(binary.op) : real_opcode(binary.op), expression.place, target,
             left, right);
}

std::optional<std::uint8_t> ExpressionCompiler::constant_operand(const Expr& expression,
                                                                 bool as_real) {
  const Constant constant =
      as_real ? converted(expression.constant, Type::real()) : expression.constant;
  if (const auto* const real = std::get_if<double>(&constant)) {
    return code_.constant_operand(Slot{.real = *real}, std::bit_cast<std::uint64_t>(*real),
                                  Type::real(expression.type.dimension));
  }
  if (const auto* const truth = std::get_if<bool>(&constant)) {
    return code_.constant_operand(to_slot(constant), *truth ? 1 : 0, Type::boolean());
  }
  const auto* const whole = std::get_if<std::int64_t>(&constant);
  if (whole == nullptr) return std::nullopt;
  return code_.constant_operand(Slot{.integer = *whole}, static_cast<std::uint64_t>(*whole),
                                Type::integer());
}

/// An operation with a constant, where there is one: what is on its left may stand on its right
/// where the order is no matter.
bool ExpressionCompiler::compile_by_constant(const Binary& binary, const Expr& expression,
                                             Register target) {
  const bool whole = on_whole_numbers(binary, expression.type);
  const std::optional<Opcode> op = constant_opcode(binary.op, whole);
  if (!op) return false;
  const bool exchanged = known(binary.left->constant);
  if (exchanged && binary.op != BinaryOp::Add && binary.op != BinaryOp::Multiply) return false;
  const Expr& variable = exchanged ? *binary.right : *binary.left;
  const auto constant = constant_operand(exchanged ? *binary.left : *binary.right, !whole);
  if (!constant) return false;
  code_.emit(*op, expression.place, target, operand(variable, !whole), *constant);
  return true;
}

bool ExpressionCompiler::stays_in_register(const Expr& expression) const {
  const auto* const name = std::get_if<Name>(&expression.node);
  return name != nullptr && is_variable(expression) && home(*name->symbol).numbers.in_register();
}

/// What is added to a product on its left is read behind it, so it must be there already: what
/// could fail would have to wait for the product.
bool ExpressionCompiler::compile_with_product(const Binary& binary, const Expr& expression,
                                              Register target) {
  if (watching_ || (binary.op != BinaryOp::Add && binary.op != BinaryOp::Subtract)) return false;
  const bool whole = on_whole_numbers(binary, expression.type);
  const Expr* factors = binary.right.get();
  const Binary* product = product_in(*factors, whole);
  const bool exchanged = product == nullptr;
  if (exchanged) {
    const bool whole_right = binary.right->type == Type::integer();
    factors = binary.left.get();
    product = product_in(*factors, whole);
    if (product == nullptr || binary.op != BinaryOp::Add || whole_right != whole ||
        !stays_in_register(*binary.right)) {
      return false;
    }
  }
  Register term = exchanged ? 0 : operand_before(*factors, *binary.left, !whole);
  const Register first = operand_before(*product->right, *product->left, !whole);
  const Register second = operand(*product->right, !whole);
  if (exchanged) term = operand(*binary.right, !whole);
  code_.emit(product_opcode(binary.op, whole), factors->place, target, term, first);
  code_.emit(Instruction{second}, expression.place);
  return true;
}

}  // namespace rob::lang
