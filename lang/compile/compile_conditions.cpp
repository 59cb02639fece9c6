#include "lang/check/fold.h"
#include "lang/compile/expression_compiler.h"

/// Conditions: what becomes jumps. AND and OR decide as soon as one side settles the matter.
namespace rob::lang {
namespace {

/// A comparison reduced to ==, < or <=, with its sides exchanged and its outcome reversed as
/// needed. Reversing is sound, since no operand is a NaN.
struct Comparison {
  BinaryOp op;
  bool exchanged = false;
  bool reversed = false;
};

Comparison reduced(BinaryOp op) {
  switch (op) {
    case BinaryOp::NotEqual:
      return {.op = BinaryOp::Equal, .reversed = true};
    case BinaryOp::Greater:
      return {.op = BinaryOp::Less, .exchanged = true};
    case BinaryOp::GreaterEqual:
      return {.op = BinaryOp::LessEqual, .exchanged = true};
    default:
      return {.op = op};
  }
}

struct ComparisonOpcodes {
  Opcode whole;
  Opcode real;
  Opcode text;
};

ComparisonOpcodes opcodes_of(BinaryOp op) {
  if (op == BinaryOp::Equal) {
    return {Opcode::if_equal_int, Opcode::if_equal_real, Opcode::equal_text};
  }
  if (op == BinaryOp::Less) {
    return {Opcode::if_less_int, Opcode::if_less_real, Opcode::less_text};
  }
  return {Opcode::if_less_equal_int, Opcode::if_less_equal_real, Opcode::less_equal_text};
}

/// A comparison with a constant on its right, as ==, < or <=: x > 2 is NOT x <= 2.
struct ConstantComparison {
  BinaryOp op;
  bool reversed = false;
};

ConstantComparison with_constant_right(BinaryOp op, bool exchanged) {
  switch (op) {
    case BinaryOp::NotEqual:
      return {BinaryOp::Equal, true};
    case BinaryOp::Less:
      return exchanged ? ConstantComparison{BinaryOp::LessEqual, true}
                       : ConstantComparison{BinaryOp::Less};
    case BinaryOp::LessEqual:
      return exchanged ? ConstantComparison{BinaryOp::Less, true}
                       : ConstantComparison{BinaryOp::LessEqual};
    case BinaryOp::Greater:
      return exchanged ? ConstantComparison{BinaryOp::Less}
                       : ConstantComparison{BinaryOp::LessEqual, true};
    case BinaryOp::GreaterEqual:
      return exchanged ? ConstantComparison{BinaryOp::LessEqual}
                       : ConstantComparison{BinaryOp::Less, true};
    default:
      return {op};
  }
}

Opcode opcode_of(BinaryOp op, bool real) {
  if (op == BinaryOp::Equal) {
    return real ? Opcode::if_equal_real_constant : Opcode::if_equal_int_constant;
  }
  if (op == BinaryOp::Less) {
    return real ? Opcode::if_less_real_constant : Opcode::if_less_int_constant;
  }
  return real ? Opcode::if_less_equal_real_constant : Opcode::if_less_equal_int_constant;
}

}  // namespace

CodeBuilder::Jumps ExpressionCompiler::jumps_if(const Expr& condition, bool when) {
  begin(condition);
  return jumps(condition, when);
}

CodeBuilder::Jump ExpressionCompiler::jump_if_equal(Register selector, const Expr& value,
                                                    bool as_real) {
  begin(value);
  const auto mark = code_.mark();
  const Register other = operand(value, as_real);
  CodeBuilder::Jump result = 0;
  if (value.type.kind == Type::Kind::String) {
    const Register truth = code_.number_registers();
    code_.emit(Opcode::equal_text, value.place, truth, selector, other);
    result = jump_if(truth, true, value.place);
  } else {
    code_.emit(as_real ? Opcode::if_equal_real : Opcode::if_equal_int, value.place, selector, other,
               1);
    result = code_.jump(value.place);
  }
  code_.release(mark);
  return result;
}

std::optional<ExpressionCompiler::Compared> ExpressionCompiler::compare(const Expr& condition) {
  const auto* const binary = std::get_if<Binary>(&condition.node);
  const bool comparison =
      binary != nullptr && binary->op >= BinaryOp::Equal && binary->op <= BinaryOp::GreaterEqual;
  if (!comparison || known(condition.constant) || !binary->left->type.scalar()) {
    return std::nullopt;
  }
  begin(condition);
  const bool real =
      binary->left->type.kind == Type::Kind::Real || binary->right->type.kind == Type::Kind::Real;
  Compared compared{{}, operand_before(*binary->right, *binary->left, real), 0, real};
  compared.right = operand(*binary->right, real);
  compared.holds =
      binary->left->type.kind == Type::Kind::String
          ? compare_texts(*binary, compared.left, compared.right, true, condition.place)
          : compare_numbers(*binary, compared.left, compared.right, true, condition.place);
  return compared;
}

CodeBuilder::Jumps ExpressionCompiler::jumps(const Expr& condition, bool when) {
  if (const bool* const constant = std::get_if<bool>(&condition.constant)) {
    if (*constant == when) return {code_.jump(condition.place)};
    return {};
  }
  if (const auto* const unary = std::get_if<Unary>(&condition.node)) {
    return jumps(*unary->operand, !when);
  }
  const auto mark = code_.mark();
  CodeBuilder::Jumps result;
  const auto* const binary = std::get_if<Binary>(&condition.node);
  if (binary == nullptr) {
    result = {jump_if(operand(condition, false), when, condition.place)};
  } else if (binary->op == BinaryOp::And || binary->op == BinaryOp::Or) {
    result = jumps_of_logical(*binary, when);
  } else if (binary->left->type.kind == Type::Kind::String) {
    result = jumps_of_texts(*binary, when, condition.place);
  } else if (!binary->left->type.scalar()) {
    result = jumps_of_compounds(*binary, when, condition.place);
  } else {
    result = jumps_of_comparison(*binary, when, condition.place);
  }
  code_.release(mark);
  return result;
}

CodeBuilder::Jumps ExpressionCompiler::jumps_of_logical(const Binary& binary, bool when) {
  const bool settling = binary.op == BinaryOp::Or;
  if (when == settling) {
    CodeBuilder::Jumps taken = jumps(*binary.left, when);
    const CodeBuilder::Jumps more = jumps(*binary.right, when);
    taken.insert(taken.end(), more.begin(), more.end());
    return taken;
  }
  const CodeBuilder::Jumps settled = jumps(*binary.left, settling);
  CodeBuilder::Jumps taken = jumps(*binary.right, when);
  code_.land(settled);
  return taken;
}

CodeBuilder::Jumps ExpressionCompiler::jumps_of_comparison(const Binary& binary, bool when,
                                                           Place place) {
  const bool real =
      binary.left->type.kind == Type::Kind::Real || binary.right->type.kind == Type::Kind::Real;
  if (binary.op != BinaryOp::Xor) {
    const bool exchanged = known(binary.left->constant);
    const Expr& constant = exchanged ? *binary.left : *binary.right;
    if (const auto operand_index = constant_operand(constant, real)) {
      const ConstantComparison compared = with_constant_right(binary.op, exchanged);
      const Register variable = operand(exchanged ? *binary.right : *binary.left, real);
      code_.emit(opcode_of(compared.op, real), place, variable, *operand_index,
                 when != compared.reversed ? 1 : 0);
      return {code_.jump(place)};
    }
  }
  const Register left = operand_before(*binary.right, *binary.left, real);
  const Register right = operand(*binary.right, real);
  return compare_numbers(binary, left, right, when, place);
}

/// XOR is the inequality of two BOOLs.
CodeBuilder::Jumps ExpressionCompiler::compare_numbers(const Binary& binary, Register left,
                                                       Register right, bool when, Place place) {
  const Comparison comparison =
      reduced(binary.op == BinaryOp::Xor ? BinaryOp::NotEqual : binary.op);
  const bool real =
      binary.left->type.kind == Type::Kind::Real || binary.right->type.kind == Type::Kind::Real;
  const ComparisonOpcodes opcodes = opcodes_of(comparison.op);
  code_.emit(real ? opcodes.real : opcodes.whole, place, comparison.exchanged ? right : left,
             comparison.exchanged ? left : right, when != comparison.reversed ? 1 : 0);
  return {code_.jump(place)};
}

CodeBuilder::Jumps ExpressionCompiler::jumps_of_texts(const Binary& binary, bool when,
                                                      Place place) {
  const Register left = operand_before(*binary.right, *binary.left, false);
  const Register right = operand(*binary.right, false);
  return compare_texts(binary, left, right, when, place);
}

CodeBuilder::Jumps ExpressionCompiler::compare_texts(const Binary& binary, Register left,
                                                     Register right, bool when, Place place) {
  const Comparison comparison = reduced(binary.op);
  const auto mark = code_.mark();
  const Register truth = code_.number_registers();
  code_.emit(opcodes_of(comparison.op).text, place, truth, comparison.exchanged ? right : left,
             comparison.exchanged ? left : right);
  code_.release(mark);
  return {jump_if(truth, when != comparison.reversed, place)};
}

CodeBuilder::Jump ExpressionCompiler::jump_if(Register truth, bool when, Place place) {
  code_.emit(Opcode::if_bool, place, truth, when ? 1 : 0);
  return code_.jump(place);
}

/// The value of a condition: the target is written only after all that it depends on was read.
void ExpressionCompiler::compile_truth(const Expr& expression, Register target) {
  const CodeBuilder::Jumps otherwise = jumps(expression, false);
  code_.load_integer(target, 1, expression.place);
  const CodeBuilder::Jump done = code_.jump(expression.place);
  code_.land(otherwise);
  code_.load_integer(target, 0, expression.place);
  code_.land(done);
}

}  // namespace rob::lang
