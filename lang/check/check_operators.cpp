#include <algorithm>
#include <cstdlib>
#include <string>

#include <fmt/core.h>

#include "lang/check/expression_checker.h"
#include "lang/text/codes.h"

/// Member functions of ExpressionChecker for the operators, in the order of their precedence: which
/// types they take and what type results.
namespace rob::lang {
namespace {

bool unknown(const Type& type) { return type.kind == Type::Kind::Unknown; }

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

}  // namespace

std::string_view symbol_of(BinaryOp op) {
  switch (op) {
    case BinaryOp::Or:
      return "OR";
    case BinaryOp::Xor:
      return "XOR";
    case BinaryOp::And:
      return "AND";
    case BinaryOp::Equal:
      return "==";
    case BinaryOp::NotEqual:
      return "<>";
    case BinaryOp::Less:
      return "<";
    case BinaryOp::LessEqual:
      return "<=";
    case BinaryOp::Greater:
      return ">";
    case BinaryOp::GreaterEqual:
      return ">=";
    case BinaryOp::Add:
      return "+";
    case BinaryOp::Subtract:
      return "-";
    case BinaryOp::Multiply:
      return "*";
    case BinaryOp::Divide:
      return "/";
    case BinaryOp::Div:
      return "DIV";
    case BinaryOp::Mod:
      return "MOD";
    case BinaryOp::Power:
      return "^";
  }
  return {};
}

Type common_type(const Type& a, const Type& b) {
  if (unknown(a)) return b;
  if (unknown(b) || a == b) return a;
  if (a.numeric() && b.numeric() && a.dimension == b.dimension) return Type::real(a.dimension);
  return {};
}

Type ExpressionChecker::check(Binary& binary, Expr& expression) {
  if (binary.op <= BinaryOp::And) return check_logical(binary, expression);
  const Type left = check(binary.left);
  const Type right = check(binary.right);
  if (unknown(left) || unknown(right)) {
    return binary.op <= BinaryOp::GreaterEqual ? Type::boolean() : Type{};
  }
  Type type;
  switch (binary.op) {
    case BinaryOp::Add:
    case BinaryOp::Subtract:
      type = check_sum(binary, expression);
      break;
    case BinaryOp::Multiply:
      type = check_product(binary, expression);
      break;
    case BinaryOp::Divide:
    case BinaryOp::Div:
    case BinaryOp::Mod:
      type = check_division(binary, expression);
      break;
    case BinaryOp::Power:
      type = check_power(binary, expression);
      break;
    default:
      type = check_comparison(binary, expression);
  }
  expression.type = type;
  if (!unknown(type)) fold_binary(binary, expression);
  return type;
}

/// The right side of AND is not executed where the left is FALSE, that of OR where it is TRUE.
Type ExpressionChecker::check_logical(Binary& binary, Expr& expression) {
  const auto check_side = [&](const ExprPtr& side) {
    const Type type = check(side);
    if (unknown(type) || type == Type::boolean()) return true;
    diagnostics_.error(code::kTypeMismatch, side->place,
                       fmt::format("{} needs TRUE or FALSE on both sides; this is {}",
                                   symbol_of(binary.op), described(*side)),
                       type.numeric() ? "compare it, for example x > 0" : "");
    return false;
  };
  bool sound = check_side(binary.left);
  const bool* const settled = std::get_if<bool>(&binary.left->constant);
  const bool skipped =
      settled != nullptr && binary.op != BinaryOp::Xor && *settled == (binary.op == BinaryOp::Or);
  if (skipped) enter_unreached();
  sound = check_side(binary.right) && sound;
  if (skipped) leave_unreached();
  if (sound) {
    keep(fold(binary.op, binary.left->constant, binary.right->constant, Type::boolean()),
         expression);
  }
  return Type::boolean();
}

Type ExpressionChecker::check_comparison(const Binary& binary, const Expr& expression) {
  if (holds_place(binary.left->type) || holds_place(binary.right->type)) {
    diagnostics_.error(
        code::kPoseOperands, expression.place,
        fmt::format("'{}' does not compare poses, which are hardly ever equal to the "
                    "last bit",
                    symbol_of(binary.op)),
        "for example DIST(p, q) < 0.1mm AND TURN(p, q) < 0.1deg");
    return Type::boolean();
  }
  const Type common = common_type(binary.left->type, binary.right->type);
  const bool left_list = std::holds_alternative<List>(binary.left->node);
  if (unknown(common) && left_list != std::holds_alternative<List>(binary.right->node) &&
      binary.op <= BinaryOp::NotEqual) {
    const Expr& list = left_list ? *binary.left : *binary.right;
    const Expr& other = left_list ? *binary.right : *binary.left;
    accept(list, other.type, fmt::format("'{}' needs", symbol_of(binary.op)));
  } else if (unknown(common)) {
    unlike(binary, expression);
  } else if (common == Type::boolean() && binary.op > BinaryOp::NotEqual) {
    diagnostics_.error(code::kTypeMismatch, expression.place,
                       fmt::format("'{}' has no meaning for TRUE and FALSE", symbol_of(binary.op)),
                       "use ==, <>, AND, OR or NOT");
  } else if (!common.scalar() && binary.op > BinaryOp::NotEqual) {
    diagnostics_.error(code::kTypeMismatch, expression.place,
                       fmt::format("'{}' has no meaning here: left and right are {}",
                                   symbol_of(binary.op), in_words(common)),
                       "compare with == or <>, or one of their parts");
  }
  return Type::boolean();
}

Type ExpressionChecker::check_sum(const Binary& binary, const Expr& expression) {
  if (binary.left->type.is_place() || binary.right->type.is_place()) {
    return check_place_sum(binary, expression);
  }
  const Type common = common_type(binary.left->type, binary.right->type);
  if (unknown(common)) return unlike(binary, expression);
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

/// Whether one side is a number and the other a VEC.
bool ExpressionChecker::scales_vector(const Binary& binary) const {
  const auto vec = [](const Expr& side) { return side.type.is(Type::Kind::Vec); };
  return (vec(*binary.left) && binary.right->type.numeric()) ||
         (vec(*binary.right) && binary.left->type.numeric());
}

/// Whether one side is JOINTS and the other a plain number.
bool ExpressionChecker::scales_joints(const Binary& binary) {
  const auto joints = [](const Expr& side) { return side.type.is(Type::Kind::Joints); };
  const auto plain = [](const Expr& side) {
    return side.type.numeric() && side.type.dimension.none();
  };
  return (joints(*binary.left) && plain(*binary.right)) ||
         (joints(*binary.right) && plain(*binary.left));
}

Type ExpressionChecker::check_product(const Binary& binary, const Expr& expression) {
  if (binary.left->type.is_place() || binary.right->type.is_place()) {
    return check_place_product(binary, expression);
  }
  if (scales_vector(binary)) {
    const Dimension product = binary.left->type.dimension * binary.right->type.dimension;
    return bounded(product, expression).known() ? Type::vec(product) : Type{};
  }
  if (scales_joints(binary)) {
    const bool first = binary.left->type.is(Type::Kind::Joints);
    return (first ? binary.left : binary.right)->type;
  }
  if (!both_numbers(binary)) return {};
  const Type& left = binary.left->type;
  const Type& right = binary.right->type;
  if (left == Type::integer() && right == Type::integer()) return Type::integer();
  return bounded(left.dimension * right.dimension, expression);
}

/// `/` is always real; DIV counts how often the right goes into the left, MOD is what remains.
Type ExpressionChecker::check_division(const Binary& binary, const Expr& expression) {
  if (binary.op == BinaryOp::Divide && scales_vector(binary) && binary.right->type.numeric()) {
    const Dimension quotient = binary.left->type.dimension / binary.right->type.dimension;
    return bounded(quotient, expression).known() ? Type::vec(quotient) : Type{};
  }
  if (!both_numbers(binary)) return {};
  const Type& left = binary.left->type;
  const Type& right = binary.right->type;
  if (binary.op == BinaryOp::Divide) {
    return bounded(left.dimension / right.dimension, expression);
  }
  const Type common = common_type(left, right);
  if (unknown(common)) return unlike(binary, expression);
  return binary.op == BinaryOp::Div ? Type::integer() : common;
}

/// INT to a constant whole number >= 0 is INT, every other power REAL. The dimension of a quantity
/// must not hang on what happens at run time, so its exponent is a constant whole number.
Type ExpressionChecker::check_power(const Binary& binary, const Expr& expression) {
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
  // Whatever is beyond these is refused by bounded() all the same.
  constexpr std::int64_t kBeyondUse = 100;
  const auto bounded_exponent =
      static_cast<int>(std::min(std::max(*whole, -kBeyondUse), kBeyondUse));
  return bounded(power(base.dimension, bounded_exponent), expression);
}

bool ExpressionChecker::both_numbers(const Binary& binary) {
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
Type ExpressionChecker::unlike(const Binary& binary, const Expr& expression) {
  const Type& left = binary.left->type;
  const Type& right = binary.right->type;
  const bool quantities = left.numeric() && right.numeric();
  const std::string remedy = quantities ? unit_remedy(left, right) : text_remedy(left, right);
  diagnostics_.error(
      quantities ? code::kDimensionMismatch : code::kTypeMismatch, expression.place,
      fmt::format("'{}' needs two values of one kind; left is {}, right is {}",
                  symbol_of(binary.op), described(*binary.left), described(*binary.right)),
      remedy);
  return {};
}

Type ExpressionChecker::bounded(Dimension d, const Expr& expression) {
  // [choice] physics needs 4 at most; 16 leaves room for intermediate results, and products of two
  // such dimensions are still far from the range of the exponents.
  constexpr int kMostExponent = 16;
  for (const int exponent : {d.length, d.mass, d.time, d.angle, d.voltage}) {
    if (std::abs(exponent) <= kMostExponent) continue;
    diagnostics_.error(
        code::kDimensionTooHigh, expression.place,
        fmt::format("this would be {}; exponents of units end at {}", in_words(d), kMostExponent));
    return {};
  }
  return Type::real(d);
}

void ExpressionChecker::fold_binary(const Binary& binary, Expr& expression) {
  if (binary.left->type.is_place()) {
    if (expression.type.known() && binary.op >= BinaryOp::Add)
      keep(fold_places(binary), expression);
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
    keep(fold(binary.op, a, b, expression.type), expression);
  } else {
    keep(fold(binary.op, converted(a, Type::real()), converted(b, Type::real()), expression.type),
         expression);
  }
}

}  // namespace rob::lang
