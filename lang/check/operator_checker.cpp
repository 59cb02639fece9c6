#include "lang/check/operator_checker.h"

#include <algorithm>
#include <string>
#include <vector>

#include <fmt/core.h>

#include "lang/check/fold.h"
#include "lang/text/codes.h"
#include "lang/values/pose_functions.h"
#include "lang/values/pose_slots.h"

namespace rob::lang {
namespace {

/// The remedy where a number and a text meet.
std::string text_remedy(const Type& a, const Type& b) {
  return a.text() != b.text() ? "STR(x) makes a text of any value" : "";
}

/// The remedy where a bare number meets a quantity.
std::string unit_remedy(const Type& a, const Type& b) {
  if (!a.numeric() || !b.numeric() || a.dimension.none() == b.dimension.none()) return "";
  return "write the unit at the number, for example " +
         example_of(a.dimension.none() ? b.dimension : a.dimension);
}

/// Whether one side is a number and the other a VEC.
bool scales_vector(const Binary& binary) {
  const auto vec = [](const Expr& side) { return side.type.is(Type::Kind::Vec); };
  return (vec(*binary.left) && binary.right->type.numeric()) ||
         (vec(*binary.right) && binary.left->type.numeric());
}

/// Whether one side is JOINTS and the other a plain number.
bool scales_joints(const Binary& binary) {
  const auto joints = [](const Expr& side) { return side.type.is(Type::Kind::Joints); };
  const auto plain = [](const Expr& side) {
    return side.type.numeric() && side.type.dimension.none();
  };
  return (joints(*binary.left) && plain(*binary.right)) ||
         (joints(*binary.right) && plain(*binary.left));
}

using Compound = std::vector<double>;

bool is_length_vector(const Type& type) { return type == Type::vec(kLength); }

Folded made(ArithmeticError error, const std::vector<Slot>& slots, int count) {
  if (error != ArithmeticError::None) return {error, {}};
  Compound compound;
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
    compound.push_back(slots[i].real);
  return {error, compound};
}

/// p + v, p - v, p - q: the place alone, part by part as the Vm does it.
Folded fold_sum(BinaryOp op, const Compound& a, const Compound& b, bool pose) {
  Compound result = a;
  for (std::size_t i = 0; i < 3; ++i) {
    const ArithmeticError error = op == BinaryOp::Add ? arithmetic::add(a[i], b[i], result[i])
                                                      : arithmetic::subtract(a[i], b[i], result[i]);
    if (error != ArithmeticError::None) return {error, {}};
  }
  result.resize(pose ? kPoseSlots : 3);
  return {ArithmeticError::None, result};
}

Folded fold_poses(const Binary& binary) {
  const auto* const a = std::get_if<Compound>(&binary.left->constant);
  const auto* const b = std::get_if<Compound>(&binary.right->constant);
  if (a == nullptr || b == nullptr) return {};
  if (binary.op != BinaryOp::Multiply) {
    return fold_sum(binary.op, *a, *b, binary.right->type.is(Type::Kind::Vec));
  }
  const std::vector<Slot> p = to_slots(binary.left->constant);
  const std::vector<Slot> q = to_slots(binary.right->constant);
  std::vector<Slot> result(kPoseSlots);
  if (binary.right->type.is_place()) {
    return made(pose_functions::product(p.data(), q.data(), result.data()), result, kPoseSlots);
  }
  return made(pose_functions::transformed(p.data(), q.data(), result.data()), result, 3);
}

}  // namespace

Type OperatorChecker::check(const Unary& unary, Expr& expression) {
  const Type& type = unary.operand->type;
  const bool negation = unary.op == UnaryOp::Not;
  if (type.kind == Type::Kind::Unknown) return negation ? Type::boolean() : type;
  if (unary.op == UnaryOp::BitNot && type != Type::integer()) {
    diagnostics_.error(code::kTypeMismatch, unary.operand->place,
                       "BITNOT needs a whole number; this is " + described(*unary.operand));
    return Type::integer();
  }
  if (negation ? type == Type::boolean() : type.numeric() || type.is(Type::Kind::Vec)) {
    expression.type = type;
    if (known(unary.operand->constant))
      values_.keep(fold(unary.op, unary.operand->constant), expression);
    return type;
  }
  if (negation) {
    diagnostics_.error(code::kTypeMismatch, unary.operand->place,
                       "NOT needs TRUE or FALSE; this is " + described(*unary.operand));
    return Type::boolean();
  }
  diagnostics_.error(code::kTypeMismatch, unary.operand->place,
                     fmt::format("'{}' needs a number; this is {}",
                                 unary.op == UnaryOp::Plus ? '+' : '-', described(*unary.operand)));
  return {};
}

Type OperatorChecker::check(const Binary& binary, Expr& expression) {
  if (!binary.left->type.known() || !binary.right->type.known()) {
    return binary.op <= BinaryOp::GreaterEqual ? Type::boolean() : Type{};
  }
  const Type type = type_of(binary, expression);
  expression.type = type;
  if (type.known()) fold_known(binary, expression);
  return type;
}

Type OperatorChecker::type_of(const Binary& binary, const Expr& expression) {
  switch (binary.op) {
    case BinaryOp::Add:
    case BinaryOp::Subtract:
      return check_sum(binary, expression);
    case BinaryOp::Multiply:
      return check_product(binary, expression);
    case BinaryOp::Divide:
    case BinaryOp::Div:
    case BinaryOp::Mod:
      return check_division(binary, expression);
    case BinaryOp::Power:
      return check_power(binary, expression);
    case BinaryOp::BitAnd:
    case BinaryOp::BitOr:
    case BinaryOp::BitXor:
    case BinaryOp::ShiftLeft:
    case BinaryOp::ShiftRight:
      return check_bits(binary);
    default:
      return check_comparison(binary, expression);
  }
}

Type OperatorChecker::check_bits(const Binary& binary) {
  for (const Expr* const side : {binary.left.get(), binary.right.get()}) {
    if (side->type == Type::integer()) continue;
    diagnostics_.error(
        code::kTypeMismatch, side->place,
        fmt::format("{} needs whole numbers; this is {}", symbol_of(binary.op), described(*side)),
        side->type == Type::boolean() ? "AND, OR and XOR join TRUE and FALSE" : "");
    break;
  }
  return Type::integer();
}

Type OperatorChecker::check_comparison(const Binary& binary, const Expr& expression) {
  if (holds_place(binary.left->type) || holds_place(binary.right->type)) {
    diagnostics_.error(
        code::kPoseOperands, expression.place,
        fmt::format("'{}' does not compare poses, which are hardly ever equal to the "
                    "last bit",
                    symbol_of(binary.op)),
        "for example DIST(p, q) < 0.1mm AND TURN(p, q) < 0.1deg");
    return Type::boolean();
  }
  if (values_.refuse_open(*binary.left) || values_.refuse_open(*binary.right)) {
    return Type::boolean();
  }
  const Type common = common_type(binary.left->type, binary.right->type);
  const bool left_list = std::holds_alternative<List>(binary.left->node);
  if (!common.known() && left_list != std::holds_alternative<List>(binary.right->node) &&
      binary.op <= BinaryOp::NotEqual) {
    const Expr& list = left_list ? *binary.left : *binary.right;
    const Expr& other = left_list ? *binary.right : *binary.left;
    values_.accept(list, other.type, fmt::format("'{}' needs", symbol_of(binary.op)));
  } else if (!common.known()) {
    unlike(binary, expression);
  } else if (common == Type::boolean() && binary.op > BinaryOp::NotEqual) {
    diagnostics_.error(code::kTypeMismatch, expression.place,
                       fmt::format("'{}' has no meaning for TRUE and FALSE", symbol_of(binary.op)),
                       "use ==, <>, AND, OR or NOT");
  } else if (common.is(Type::Kind::Enum) && binary.op > BinaryOp::NotEqual) {
    diagnostics_.error(code::kTypeMismatch, expression.place,
                       fmt::format("'{}' has no meaning for {}: its names have no order",
                                   symbol_of(binary.op), in_words(common)),
                       "compare with == or <>, or what ORD counts");
  } else if (!common.scalar() && binary.op > BinaryOp::NotEqual) {
    diagnostics_.error(code::kTypeMismatch, expression.place,
                       fmt::format("'{}' has no meaning here: left and right are {}",
                                   symbol_of(binary.op), in_words(common)),
                       "compare with == or <>, or one of their parts");
  }
  return Type::boolean();
}

Type OperatorChecker::check_sum(const Binary& binary, const Expr& expression) {
  if (binary.left->type.is_place() || binary.right->type.is_place()) {
    return check_pose_sum(binary, expression);
  }
  const Type common = common_type(binary.left->type, binary.right->type);
  if (!common.known()) return unlike(binary, expression);
  if (common.numeric() || common.is(Type::Kind::Vec) || common.is(Type::Kind::Joints))
    return common;
  if (common.text() && binary.op == BinaryOp::Add) return common;
  std::string these = in_words(common);
  if (common.text()) these = "texts";
  diagnostics_.error(
      code::kTypeMismatch, expression.place,
      fmt::format("'{}' needs two numbers; these are {}", symbol_of(binary.op), these));
  return {};
}

Type OperatorChecker::check_pose_sum(const Binary& binary, const Expr& expression) {
  const Type& left = binary.left->type;
  const Type& right = binary.right->type;
  if (left.is_place() && is_length_vector(right)) return as_pose(left);
  if (left.is_place() && right.is_place() && binary.op == BinaryOp::Subtract) {
    return values_.common_frame(*binary.left, *binary.right, "'-'").known() ? Type::vec(kLength)
                                                                            : Type{};
  }
  const bool bare = right.is(Type::Kind::Vec) && right.dimension.none();
  std::string help = "p + (0mm, 0mm, 60mm) shifts a pose; p * q composes two";
  if (bare) help = "write the units, as in p + (0mm, 0mm, 60mm)";
  diagnostics_.error(
      code::kPoseOperands, expression.place,
      fmt::format("'{}' shifts a pose by a VEC of lengths; left is {}, right is {}",
                  symbol_of(binary.op), described(*binary.left), described(*binary.right)),
      help);
  return {};
}

Type OperatorChecker::check_product(const Binary& binary, const Expr& expression) {
  if (binary.left->type.is_place() || binary.right->type.is_place()) {
    return check_pose_product(binary, expression);
  }
  if (scales_vector(binary)) {
    const Dimension product = binary.left->type.dimension * binary.right->type.dimension;
    return values_.bounded(product, expression).known() ? Type::vec(product) : Type{};
  }
  if (scales_joints(binary)) {
    const bool first = binary.left->type.is(Type::Kind::Joints);
    return (first ? binary.left : binary.right)->type;
  }
  if (!both_numbers(binary)) return {};
  const Type& left = binary.left->type;
  const Type& right = binary.right->type;
  if (left == Type::integer() && right == Type::integer()) return Type::integer();
  return values_.bounded(left.dimension * right.dimension, expression);
}

/// The right operand is seen from the left one, so it has no frame of its own but the world,
/// which stands for none.
Type OperatorChecker::check_pose_product(const Binary& binary, const Expr& expression) {
  const Type& left = binary.left->type;
  const Type& right = binary.right->type;
  if (left.is_place() && is_length_vector(right)) return right;
  if (!left.is_place() || !right.is_place()) {
    diagnostics_.error(
        code::kPoseOperands, expression.place,
        fmt::format("'*' composes a pose with a pose or a VEC of lengths; left is {}, right is {}",
                    described(*binary.left), described(*binary.right)),
        "p + v shifts along the axes of the frame, p * v along those of the pose");
    return {};
  }
  const Type offset = as_pose(right);
  if (is_free(offset) || offset == Type::pose()) return as_pose(left);
  diagnostics_.error(
      code::kFrames, binary.right->place,
      fmt::format("'*' adds what is seen from the left pose, {}; the right one is {}",
                  frame_in_words(as_pose(left)), frame_in_words(offset)),
      "TO_FRAME(p, f) gives the same place in another frame");
  return {};
}

/// `/` is always real; DIV counts how often the right goes into the left, MOD is what remains.
Type OperatorChecker::check_division(const Binary& binary, const Expr& expression) {
  if (binary.op == BinaryOp::Divide && scales_vector(binary) && binary.right->type.numeric()) {
    const Dimension quotient = binary.left->type.dimension / binary.right->type.dimension;
    return values_.bounded(quotient, expression).known() ? Type::vec(quotient) : Type{};
  }
  if (!both_numbers(binary)) return {};
  const Type& left = binary.left->type;
  const Type& right = binary.right->type;
  if (binary.op == BinaryOp::Divide) {
    return values_.bounded(left.dimension / right.dimension, expression);
  }
  const Type common = common_type(left, right);
  if (!common.known()) return unlike(binary, expression);
  return binary.op == BinaryOp::Div ? Type::integer() : common;
}

/// INT to a constant whole number >= 0 is INT, every other power REAL. The dimension of a quantity
/// must not hang on what happens at run time, so its exponent is a constant whole number.
Type OperatorChecker::check_power(const Binary& binary, const Expr& expression) {
  if (!both_numbers(binary)) return {};
  const Type& base = binary.left->type;
  const Type& exponent = binary.right->type;
  if (!exponent.dimension.none()) {
    diagnostics_.error(code::kDimensionMismatch, binary.right->place,
                       "an exponent is a plain number; this is " + described(*binary.right));
    return {};
  }
  const auto* const whole = std::get_if<std::int64_t>(&binary.right->constant);
  if (base == Type::integer()) {
    return whole != nullptr && *whole >= 0 ? Type::integer() : Type::real();
  }
  if (base.dimension.none()) return Type::real();
  if (whole == nullptr) {
    diagnostics_.error(
        code::kExponentNotConstant, binary.right->place,
        fmt::format("{} can be raised only to a constant whole number", in_words(base)),
        "SQRT(x) takes the root of a quantity");
    return {};
  }
  // Whatever is beyond these is refused by values_.bounded() all the same.
  constexpr std::int64_t kBeyondUse = 100;
  const auto bounded_exponent =
      static_cast<int>(std::min(std::max(*whole, -kBeyondUse), kBeyondUse));
  return values_.bounded(power(base.dimension, bounded_exponent), expression);
}

bool OperatorChecker::both_numbers(const Binary& binary) {
  for (const Expr* side : {binary.left.get(), binary.right.get()}) {
    if (side->type.numeric()) continue;
    diagnostics_.error(
        code::kTypeMismatch, side->place,
        fmt::format("'{}' needs two numbers; this is {}", symbol_of(binary.op), described(*side)));
    return false;
  }
  return true;
}

/// Reports two operands that should be of one kind and are not.
Type OperatorChecker::unlike(const Binary& binary, const Expr& expression) {
  const Type& left = binary.left->type;
  const Type& right = binary.right->type;
  const bool quantities = left.numeric() && right.numeric();
  const std::string remedy = quantities ? unit_remedy(left, right) : text_remedy(left, right);
  diagnostics_.error(
      quantities ? code::kDimensionMismatch : code::kTypeMismatch, expression.place,
      fmt::format("'{}' needs two values of one kind; left is {}, right is {} ({} and {})",
                  symbol_of(binary.op), described(*binary.left), described(*binary.right),
                  as_written(left), as_written(right)),
      remedy);
  return {};
}

void OperatorChecker::fold_known(const Binary& binary, Expr& expression) {
  if (binary.left->type.is_place()) {
    if (expression.type.known() && binary.op >= BinaryOp::Add)
      values_.keep(fold_poses(binary), expression);
    return;
  }
  const Type& left = binary.left->type;
  const Type& right = binary.right->type;
  const Constant& a = binary.left->constant;
  const Constant& b = binary.right->constant;
  if (!known(a) || !known(b)) return;
  const bool whole =
      left == Type::integer() && right == Type::integer() && binary.op != BinaryOp::Divide;
  if (whole) {
    values_.keep(fold(binary.op, a, b, expression.type), expression);
  } else {
    values_.keep(
        fold(binary.op, converted(a, Type::real()), converted(b, Type::real()), expression.type),
        expression);
  }
}

}  // namespace rob::lang
