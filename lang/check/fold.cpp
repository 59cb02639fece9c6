#include "lang/check/fold.h"

#include <algorithm>
#include <string>
#include <vector>

#include "lang/check/symbols.h"
#include "lang/values/number_text.h"
#include "lang/values/pose_slots.h"
#include "lang/values/value_text.h"

namespace rob::lang {
namespace {

/// `value` is taken by reference, since the call that yields `error` stores it.
template <typename T>
Folded made(ArithmeticError error, const T& value) {
  if (error != ArithmeticError::None) return {error, {}};
  return {error, Constant(value)};
}

template <typename T>
std::optional<bool> compare(BinaryOp op, const T& a, const T& b) {
  switch (op) {
    case BinaryOp::Equal:
      return a == b;
    case BinaryOp::NotEqual:
      return !(a == b);
    case BinaryOp::Less:
      return a < b;
    case BinaryOp::LessEqual:
      return a <= b;
    case BinaryOp::Greater:
      return b < a;
    case BinaryOp::GreaterEqual:
      return b <= a;
    default:
      return std::nullopt;
  }
}

Folded fold_reals(BinaryOp op, double a, double b) {
  double real = 0;
  std::int64_t whole = 0;
  switch (op) {
    case BinaryOp::Add:
      return made(arithmetic::add(a, b, real), real);
    case BinaryOp::Subtract:
      return made(arithmetic::subtract(a, b, real), real);
    case BinaryOp::Multiply:
      return made(arithmetic::multiply(a, b, real), real);
    case BinaryOp::Divide:
      return made(arithmetic::divide(a, b, real), real);
    case BinaryOp::Div:
      return made(arithmetic::floor_divide(a, b, whole), whole);
    case BinaryOp::Mod:
      return made(arithmetic::floor_modulo(a, b, real), real);
    case BinaryOp::Power:
      return made(arithmetic::real_power(a, b, real), real);
    default:
      return {};
  }
}

Folded fold_integers(BinaryOp op, std::int64_t a, std::int64_t b, const Type& result) {
  std::int64_t whole = 0;
  switch (op) {
    case BinaryOp::Add:
      return made(arithmetic::add(a, b, whole), whole);
    case BinaryOp::Subtract:
      return made(arithmetic::subtract(a, b, whole), whole);
    case BinaryOp::Multiply:
      return made(arithmetic::multiply(a, b, whole), whole);
    case BinaryOp::Div:
      return made(arithmetic::floor_divide(a, b, whole), whole);
    case BinaryOp::Mod:
      return made(arithmetic::floor_modulo(a, b, whole), whole);
    case BinaryOp::BitAnd:
      return made(arithmetic::bit_and(a, b, whole), whole);
    case BinaryOp::BitOr:
      return made(arithmetic::bit_or(a, b, whole), whole);
    case BinaryOp::BitXor:
      return made(arithmetic::bit_xor(a, b, whole), whole);
    case BinaryOp::ShiftLeft:
      return made(arithmetic::shift_left(a, b, whole), whole);
    case BinaryOp::ShiftRight:
      return made(arithmetic::shift_right(a, b, whole), whole);
    case BinaryOp::Power:
      if (result.kind == Type::Kind::Int) {
        return made(arithmetic::integer_power(a, b, whole), whole);
      }
      [[fallthrough]];
    default:
      return fold_reals(op, static_cast<double>(a), static_cast<double>(b));
  }
}

/// AND and OR: one side may settle the matter, whatever the other is.
Folded fold_logical(BinaryOp op, const Constant& left, const Constant& right) {
  const bool* const a = std::get_if<bool>(&left);
  const bool* const b = std::get_if<bool>(&right);
  const bool settling = op == BinaryOp::Or;
  if (op != BinaryOp::Xor && a != nullptr && *a == settling) return {{}, settling};
  if (a == nullptr || b == nullptr) return {};
  return {{}, op == BinaryOp::Xor ? *a != *b : *b};
}

}  // namespace

Constant converted(const Constant& constant, const Type& wanted) {
  const auto* const integer = std::get_if<std::int64_t>(&constant);
  if (integer == nullptr || wanted.kind != Type::Kind::Real) return constant;
  return static_cast<double>(*integer);
}

Slot to_slot(const Constant& constant) {
  Slot slot{.integer = 0};
  if (const auto* const real = std::get_if<double>(&constant)) slot.real = *real;
  if (const auto* const integer = std::get_if<std::int64_t>(&constant)) slot.integer = *integer;
  if (const auto* const truth = std::get_if<bool>(&constant)) slot.integer = *truth ? 1 : 0;
  return slot;
}

Constant constant_of(const PoseValue& pose) {
  const auto& [p, q] = pose;
  return std::vector<double>{p.x, p.y, p.z, q.w, q.i, q.j, q.k};
}

namespace {

PoseValue pose_of(const Constant& constant) { return load_pose(to_slots(constant).data()); }

}  // namespace

Constant known_value(const Expr& expression) {
  if (!known(expression.constant)) return {};
  Constant value = expression.constant;
  if (expression.moved_from != nullptr) {
    const PoseValue frame = pose_of(expression.moved_from->value);
    value = constant_of(pose_math::compose(frame, pose_of(expression.constant)));
  }
  // A pose as a TOOL weighs nothing.
  auto* const slots = std::get_if<std::vector<double>>(&value);
  if (slots != nullptr && expression.place_slots != 0) {
    slots->resize(static_cast<std::size_t>(expression.place_slots));
  }
  return value;
}

std::vector<Slot> to_slots(const Constant& constant) {
  const auto* const compound = std::get_if<std::vector<double>>(&constant);
  if (compound == nullptr) return {to_slot(constant)};
  std::vector<Slot> slots;
  for (const double real : *compound) slots.push_back({.real = real});
  return slots;
}

std::string text_of(const Constant& constant, const Type& type) {
  if (const auto* const truth = std::get_if<bool>(&constant)) return text_of(*truth);
  if (const auto* const integer = std::get_if<std::int64_t>(&constant)) {
    return type.is(Type::Kind::Enum) ? enum_text(*type.detail, *integer) : std::to_string(*integer);
  }
  if (const auto* const real = std::get_if<double>(&constant)) {
    return number_text(*real, type.dimension);
  }
  if (std::holds_alternative<std::vector<double>>(constant)) {
    std::string text;
    append_value_text(text, type, to_slots(constant).data(), nullptr, text.max_size());
    return text;
  }
  const auto* const text = std::get_if<std::string>(&constant);
  return text == nullptr ? std::string() : *text;
}

namespace {

using Compound = std::vector<double>;

/// Part by part, as the Vm computes it.
template <typename Part>
Folded fold_parts(std::size_t count, Part part) {
  Compound result(count);
  for (std::size_t i = 0; i < count; ++i) {
    if (const ArithmeticError error = part(i, result[i]); error != ArithmeticError::None) {
      return {error, {}};
    }
  }
  return made(ArithmeticError::None, result);
}

/// A VEC and a VEC, or a VEC and a number; empty where neither is one.
Folded fold_vectors(BinaryOp op, const Constant& left, const Constant& right) {
  const auto* const a = std::get_if<Compound>(&left);
  const auto* const b = std::get_if<Compound>(&right);
  const auto* const factor = std::get_if<double>(a != nullptr ? &right : &left);
  if (a != nullptr && b != nullptr && op == BinaryOp::Add) {
    return fold_parts(a->size(),
                      [&](auto i, double& r) { return arithmetic::add((*a)[i], (*b)[i], r); });
  }
  if (a != nullptr && b != nullptr && op == BinaryOp::Subtract) {
    return fold_parts(a->size(),
                      [&](auto i, double& r) { return arithmetic::subtract((*a)[i], (*b)[i], r); });
  }
  if (factor == nullptr || (a == nullptr && b == nullptr)) return {};
  const Compound& vec = a != nullptr ? *a : *b;
  if (op == BinaryOp::Multiply) {
    return fold_parts(vec.size(),
                      [&](auto i, double& r) { return arithmetic::multiply(vec[i], *factor, r); });
  }
  return fold_parts(vec.size(),
                    [&](auto i, double& r) { return arithmetic::divide(vec[i], *factor, r); });
}

}  // namespace

Folded fold(UnaryOp op, const Constant& operand) {
  if (const auto* const truth = std::get_if<bool>(&operand)) return {{}, !*truth};
  if (op == UnaryOp::Plus) return {{}, operand};
  if (const auto* const integer = std::get_if<std::int64_t>(&operand)) {
    if (op == UnaryOp::BitNot) return {{}, ~*integer};
    std::int64_t result = 0;
    return made(arithmetic::negate(*integer, result), result);
  }
  if (const auto* const real = std::get_if<double>(&operand)) {
    double result = 0;
    return made(arithmetic::negate(*real, result), result);
  }
  if (const auto* const vec = std::get_if<Compound>(&operand)) {
    return fold_parts(vec->size(),
                      [&](auto i, double& r) { return arithmetic::negate((*vec)[i], r); });
  }
  return {};
}

Folded fold(BinaryOp op, const Constant& left, const Constant& right, const Type& result) {
  if (op == BinaryOp::And || op == BinaryOp::Or || op == BinaryOp::Xor) {
    return fold_logical(op, left, right);
  }
  if (!known(left) || !known(right)) return {};
  if (op >= BinaryOp::Add) {
    const Folded vectors = fold_vectors(op, left, right);
    if (known(vectors.value) || vectors.error != ArithmeticError::None) return vectors;
  }
  if (left.index() != right.index()) return {};
  const auto comparison = std::visit(
      [&](const auto& a) { return compare(op, a, std::get<std::decay_t<decltype(a)>>(right)); },
      left);
  if (comparison) return {{}, *comparison};
  if (const auto* const a = std::get_if<std::int64_t>(&left)) {
    return fold_integers(op, *a, std::get<std::int64_t>(right), result);
  }
  if (const auto* const a = std::get_if<double>(&left)) {
    return fold_reals(op, *a, std::get<double>(right));
  }
  return {};
}

Folded fold(BuiltinFunction function, std::span<const Constant> arguments, const Type& result) {
  std::vector<Slot> slots;
  for (const Constant& argument : arguments) {
    if (!known(argument)) return {};
    const std::vector<Slot> more = to_slots(argument);
    slots.insert(slots.end(), more.begin(), more.end());
  }
  const std::size_t given = slots.size();
  const auto count = static_cast<std::size_t>(slots_of(result).numbers);
  slots.resize(std::max(given, count), Slot{.integer = 0});
  const ArithmeticError error = function({slots.data(), given}, slots.front());
  if (result.kind == Type::Kind::Int) return made(error, slots.front().integer);
  if (result.kind == Type::Kind::Real) return made(error, slots.front().real);
  std::vector<double> compound;
  for (std::size_t i = 0; i < count; ++i) compound.push_back(slots[i].real);
  return made(error, compound);
}

}  // namespace rob::lang
