#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <string_view>

/// The arithmetic of the language, once for the checker, which folds constants, and for the Vm:
/// both call these functions, so a constant and a computed value can never differ by a bit.
///
/// Operands are finite and no negative zero, and so is every result: anything else is an
/// error, and no result is stored then. Thus no NaN or infinity can ever reach a motion.
namespace rob::lang {

/// A slot of the Vm. It has no tag: the checker has settled what it holds. A BOOL is 0 or 1.
union Slot {
  std::int64_t integer;
  double real;
};

enum class ArithmeticError : std::uint8_t {
  None,
  IntegerOverflow,
  DivisionByZero,
  NotFinite,
  NegativeRoot,
  ArcOutOfRange,
  LogarithmOfNonPositive,
  ClampReversed,
  PowerUndefined,
  ZeroStep,
  TooManyTurns,
  DigitsOutOfRange,
  NotANumber,
  RangeReversed,
  ShiftOutOfRange,
  TextTooLong,
  NoCharacter,
  NoText,
  ZeroQuaternion,
  OppositePoses,
  CollinearPlaces,
  ToolNotTurned,
  ZeroVector
};

/// The message about an ArithmeticError.
struct ArithmeticErrorText {
  std::string_view code;
  std::string_view message;
  std::string_view help;
};
ArithmeticErrorText describe(ArithmeticError error);

namespace arithmetic {

using Error = ArithmeticError;

inline Error store_finite(double value, double& result) {
  if (!std::isfinite(value)) [[unlikely]]
    return Error::NotFinite;
  result = value + 0.0;  // turns -0 into 0
  return Error::None;
}

inline Error store_fitting(bool overflow, std::int64_t value, std::int64_t& result) {
  if (overflow) [[unlikely]]
    return Error::IntegerOverflow;
  result = value;
  return Error::None;
}
inline Error add(std::int64_t a, std::int64_t b, std::int64_t& result) {
  std::int64_t sum = 0;
  const bool overflow = __builtin_add_overflow(a, b, &sum);
  return store_fitting(overflow, sum, result);
}
inline Error subtract(std::int64_t a, std::int64_t b, std::int64_t& result) {
  std::int64_t difference = 0;
  const bool overflow = __builtin_sub_overflow(a, b, &difference);
  return store_fitting(overflow, difference, result);
}
inline Error multiply(std::int64_t a, std::int64_t b, std::int64_t& result) {
  std::int64_t product = 0;
  const bool overflow = __builtin_mul_overflow(a, b, &product);
  return store_fitting(overflow, product, result);
}
inline Error negate(std::int64_t a, std::int64_t& result) { return subtract(0, a, result); }

// A sum of numbers without negative zero never is one, so it needs no store_finite().
inline Error store_sum(double sum, double& result) {
  if (!std::isfinite(sum)) [[unlikely]]
    return Error::NotFinite;
  result = sum;
  return Error::None;
}
inline Error add(double a, double b, double& result) { return store_sum(a + b, result); }
inline Error subtract(double a, double b, double& result) { return store_sum(a - b, result); }
inline Error multiply(double a, double b, double& result) { return store_finite(a * b, result); }
inline Error divide(double a, double b, double& result) {
  if (b == 0) return Error::DivisionByZero;
  return store_finite(a / b, result);
}
/// 0 - a, not -a, which would be -0 for 0.
inline Error negate(double a, double& result) {
  result = 0 - a;
  return Error::None;
}

/// DIV and MOD round down: the remainder has the sign of the divisor.
inline Error floor_divide(std::int64_t a, std::int64_t b, std::int64_t& result) {
  if (b == 0) return Error::DivisionByZero;
  if (b == -1) return negate(a, result);
  const std::int64_t quotient = a / b;
  result = quotient - (a % b != 0 && (a < 0) != (b < 0) ? 1 : 0);
  return Error::None;
}
inline Error floor_modulo(std::int64_t a, std::int64_t b, std::int64_t& result) {
  if (b == 0) return Error::DivisionByZero;
  if (b == -1) {
    result = 0;
    return Error::None;
  }
  const std::int64_t remainder = a % b;
  result = remainder != 0 && (remainder < 0) != (b < 0) ? remainder + b : remainder;
  return Error::None;
}

inline Error bit_and(std::int64_t a, std::int64_t b, std::int64_t& result) {
  result = a & b;
  return Error::None;
}
inline Error bit_or(std::int64_t a, std::int64_t b, std::int64_t& result) {
  result = a | b;
  return Error::None;
}
inline Error bit_xor(std::int64_t a, std::int64_t b, std::int64_t& result) {
  result = a ^ b;
  return Error::None;
}
/// Bits that are shifted out are lost; 0 bits come in.
inline Error shift_left(std::int64_t a, std::int64_t b, std::int64_t& result) {
  if (b < 0 || b > 63) return Error::ShiftOutOfRange;
  result = static_cast<std::int64_t>(static_cast<std::uint64_t>(a) << b);
  return Error::None;
}
/// Keeps the sign.
inline Error shift_right(std::int64_t a, std::int64_t b, std::int64_t& result) {
  if (b < 0 || b > 63) return Error::ShiftOutOfRange;
  result = a >> b;
  return Error::None;
}

/// The whole number that a real with a whole value stands for.
inline Error to_integer(double whole, std::int64_t& result) {
  // 2^63, the first double beyond INT; -2^63 still fits.
  constexpr double kBeyond = 9223372036854775808.0;
  if (!(whole >= -kBeyond && whole < kBeyond)) return Error::IntegerOverflow;
  result = static_cast<std::int64_t>(whole);
  return Error::None;
}

/// How much of a whole number may be missing so that it still counts: 0.3 DIV 0.1 is 3, and 0 TO 1
/// STEP 0.1 reaches 1, although 0.1 is no binary fraction. [choice] far beyond the rounding errors
/// of a sum of thousands of terms, far below what anybody means by a part.
inline constexpr double kMargin = 1e-9;

/// a DIV b is floor(a / b + kMargin), and floor(a / b) where both are whole numbers. a MOD b is
/// a - b * (a DIV b), or 0 where the margin has rounded up; so it has the sign of b.
Error floor_divide(double a, double b, std::int64_t& result);
Error floor_modulo(double a, double b, double& result);

/// INT to the power of a whole exponent >= 0, by repeated squaring.
Error integer_power(std::int64_t base, std::int64_t exponent, std::int64_t& result);
Error real_power(double base, double exponent, double& result);

/// How often a FOR runs: floor((to - from) / step + kMargin) + 1, and 0 if that is negative.
Error turns(double from, double to, double step, std::int64_t& result);
/// The same for whole numbers, exactly.
Error turns(std::int64_t from, std::int64_t to, std::int64_t step, std::int64_t& result);

}  // namespace arithmetic
}  // namespace rob::lang
