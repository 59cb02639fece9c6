#include "lang/compile/operations.h"

#include <bit>
#include <string>

#include "lang/check/fold.h"

namespace rob::lang {

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
    case BinaryOp::BitAnd:
      return Opcode::bit_and;
    case BinaryOp::BitOr:
      return Opcode::bit_or;
    case BinaryOp::BitXor:
      return Opcode::bit_xor;
    case BinaryOp::ShiftLeft:
      return Opcode::shift_left;
    case BinaryOp::ShiftRight:
      return Opcode::shift_right;
    default:
      return Opcode::pow_int;
  }
}

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
    case BinaryOp::Div:
      return whole ? std::optional(Opcode::div_int_constant) : std::nullopt;
    case BinaryOp::Mod:
      return whole ? std::optional(Opcode::mod_int_constant) : std::nullopt;
    default:
      return std::nullopt;
  }
}

Opcode product_opcode(BinaryOp op, bool whole) {
  if (op == BinaryOp::Add) return whole ? Opcode::add_product_int : Opcode::add_product_real;
  return whole ? Opcode::sub_product_int : Opcode::sub_product_real;
}

Opcode sum_opcode(BinaryOp first, BinaryOp second) {
  const bool adds = second == BinaryOp::Add;
  if (first == BinaryOp::Add) return adds ? Opcode::add_add_real : Opcode::add_sub_real;
  return adds ? Opcode::sub_add_real : Opcode::sub_sub_real;
}

bool on_whole_numbers(const Binary& binary, const Type& result) {
  if (binary.left->type != Type::integer() || binary.right->type != Type::integer()) return false;
  return result.kind == Type::Kind::Int;
}

const Binary* product_in(const Expr& expression, bool whole) {
  const auto* const product = std::get_if<Binary>(&expression.node);
  const bool found = product != nullptr && product->op == BinaryOp::Multiply &&
                     !known(expression.constant) && !known(product->left->constant) &&
                     !known(product->right->constant) &&
                     on_whole_numbers(*product, expression.type) == whole;
  return found ? product : nullptr;
}

bool compares_reals(const Binary& binary) {
  return binary.left->type.kind == Type::Kind::Real || binary.right->type.kind == Type::Kind::Real;
}

void load_known(CodeBuilder& code, const Expr& expression, Register target, bool as_real) {
  const Constant constant =
      as_real ? converted(expression.constant, Type::real()) : expression.constant;
  if (const auto* const text = std::get_if<std::string>(&constant)) {
    code.load_text(target, *text, expression.place);
  } else if (const auto* const real = std::get_if<double>(&constant)) {
    code.load_real(target, *real, expression.type.dimension, expression.place);
  } else if (const auto* const compound = std::get_if<std::vector<double>>(&constant)) {
    for (const double part : *compound) {
      code.load_real(target++, part, expression.type.dimension, expression.place);
    }
  } else {
    code.load_integer(target, to_slot(constant).integer, expression.place);
  }
}

void load_joints(CodeBuilder& code, const Symbol& point, const RobotSignature& robot,
                 Register first, Place place) {
  for (std::size_t i = 0; i < point.joints.size(); ++i) {
    code.load_real(static_cast<Register>(first + i), point.joints[i], robot.axes[i].dimension,
                   place);
  }
}

std::optional<std::uint8_t> constant_operand(CodeBuilder& code, const Expr& expression,
                                             bool as_real) {
  const Constant constant =
      as_real ? converted(expression.constant, Type::real()) : expression.constant;
  if (const auto* const real = std::get_if<double>(&constant)) {
    return code.constant_operand(Slot{.real = *real}, std::bit_cast<std::uint64_t>(*real),
                                 Type::real(expression.type.dimension));
  }
  if (const auto* const truth = std::get_if<bool>(&constant)) {
    return code.constant_operand(to_slot(constant), *truth ? 1 : 0, Type::boolean());
  }
  const auto* const whole = std::get_if<std::int64_t>(&constant);
  if (whole == nullptr) return std::nullopt;
  return code.constant_operand(Slot{.integer = *whole}, static_cast<std::uint64_t>(*whole),
                               Type::integer());
}

void append_register(CodeBuilder& code, Register value, const Type& type, bool real, Register text,
                     Place place) {
  switch (type.kind) {
    case Type::Kind::Bool:
      return code.emit(Opcode::append_bool, place, text, value);
    case Type::Kind::Int:
      if (real) return code.append_real(text, value, kNone, place);
      return code.emit(Opcode::append_int, place, text, value);
    case Type::Kind::Real:
      return code.append_real(text, value, type.dimension, place);
    case Type::Kind::Enum:
      return code.append_value(text, value, type, place);
    default:
      return code.emit(Opcode::append_text, place, text, value);
  }
}

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

CodeBuilder::Jumps compare_numbers(CodeBuilder& code, const Binary& binary, Register left,
                                   Register right, bool when, Place place) {
  const Comparison comparison =
      reduced(binary.op == BinaryOp::Xor ? BinaryOp::NotEqual : binary.op);
  const bool real = compares_reals(binary);
  const ComparisonOpcodes opcodes = opcodes_of(comparison.op);
  code.emit(real ? opcodes.real : opcodes.whole, place, comparison.exchanged ? right : left,
            comparison.exchanged ? left : right, when != comparison.reversed ? 1 : 0);
  return {code.jump(place)};
}

CodeBuilder::Jumps compare_texts(CodeBuilder& code, BinaryOp op, Register left, Register right,
                                 bool when, Place place) {
  const Comparison comparison = reduced(op);
  const auto mark = code.frame().mark();
  const Register truth = code.frame().number_registers();
  code.emit(opcodes_of(comparison.op).text, place, truth, comparison.exchanged ? right : left,
            comparison.exchanged ? left : right);
  code.frame().release(mark);
  return {jump_if(code, truth, when != comparison.reversed, place)};
}

CodeBuilder::Jump compare_known_text(CodeBuilder& code, BinaryOp op, Register text,
                                     const std::string& other, bool when, Place place) {
  const auto mark = code.frame().mark();
  const Register truth = code.frame().number_registers();
  code.with_text(Opcode::equal_text_constant, truth, text, other, place);
  code.frame().release(mark);
  return jump_if(code, truth, when == (op == BinaryOp::Equal), place);
}

CodeBuilder::Jumps compare_constant(CodeBuilder& code, const Binary& binary, Register variable,
                                    std::uint8_t constant, bool exchanged, bool when, Place place) {
  const ConstantComparison compared = with_constant_right(binary.op, exchanged);
  code.emit(opcode_of(compared.op, compares_reals(binary)), place, variable, constant,
            when != compared.reversed ? 1 : 0);
  return {code.jump(place)};
}

CodeBuilder::Jump jump_if(CodeBuilder& code, Register truth, bool when, Place place) {
  code.emit(Opcode::if_bool, place, truth, when ? 1 : 0);
  return code.jump(place);
}

}  // namespace rob::lang
