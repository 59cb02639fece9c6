#include "lang/values/arithmetic.h"

#include "lang/text/codes.h"

namespace rob::lang {

ArithmeticErrorText describe(ArithmeticError error) {
  switch (error) {
    case ArithmeticError::None:
      return {};
    case ArithmeticError::IntegerOverflow:
      return {code::kIntegerOverflow, "the result is too large for a whole number",
              "INT reaches from -2^63 to 2^63 - 1; compute with REAL, for example REAL(n)"};
    case ArithmeticError::DivisionByZero:
      return {code::kDivisionByZero, "division by zero", "test the divisor before dividing"};
    case ArithmeticError::NotFinite:
      return {code::kNotFinite, "the result is too large for a number",
              "numbers reach up to about 1.8e308"};
    case ArithmeticError::NegativeRoot:
      return {code::kNegativeRoot, "SQRT of a negative number", ""};
    case ArithmeticError::ArcOutOfRange:
      return {code::kArcOutOfRange, "ASIN and ACOS need a number from -1 to 1",
              "CLAMP(x, -1, 1) forgives rounding"};
    case ArithmeticError::LogarithmOfNonPositive:
      return {code::kLogarithmOfNonPositive, "the logarithm of zero or of a negative number", ""};
    case ArithmeticError::ClampReversed:
      return {code::kClampReversed, "the lower bound of CLAMP is above the upper one",
              "the order is CLAMP(value, lower, upper)"};
    case ArithmeticError::PowerUndefined:
      return {code::kPowerUndefined, "a negative number has no such power",
              "only whole exponents are possible here"};
    case ArithmeticError::ZeroStep:
      return {code::kZeroStep, "the STEP of a FOR is zero", "it would never end"};
    case ArithmeticError::TooManyTurns:
      return {code::kTooManyTurns, "this FOR would run more than 2^53 times", "take a larger STEP"};
    case ArithmeticError::DigitsOutOfRange:
      return {code::kDigitsOutOfRange, "STR writes 0 to 17 decimals", "a number has no more"};
    case ArithmeticError::NotANumber:
      return {code::kNotANumber, "NUM of a text that is no number",
              "a number is written as in a program, without unit: 12, -0.5 or 1e-3"};
    case ArithmeticError::ZeroQuaternion:
      return {code::kZeroQuaternion, "QUAT with w, i, j and k all zero is no orientation",
              "QUAT(x, y, z, 1, 0, 0, 0) is not turned"};
    case ArithmeticError::OppositePoses:
      return {code::kOppositePoses, "these poses are turned by 180deg: no way round is shortest",
              "go by way of a third pose"};
    case ArithmeticError::CollinearPlaces:
      return {code::kCollinearPlaces, "the places of FRAME3 lie on a line, so they make no plane",
              "take three places that are far from each other and not on a line"};
    case ArithmeticError::ToolNotTurned:
      return {code::kToolNotTurned,
              "the tool is turned by less than 10deg between these poses, or about one axis only",
              "touch the tip from sides that are far apart: turn the tool by 30deg or more, about"
              " two axes"};
    case ArithmeticError::RangeReversed:
      return {code::kRangeReversed, "the lower bound of RANDOM is above the upper one",
              "the order is RANDOM(lower, upper)"};
    case ArithmeticError::TextTooLong:
      return {code::kTextTooLong, "a text of more than 65536 bytes", ""};
    case ArithmeticError::NoCharacter:
      return {code::kNoCharacter, "CHR of a number that no character has",
              "characters have numbers from 1 to 1114111 (0x10FFFF)"};
    case ArithmeticError::NoText:
      return {code::kNoCharacter, "ORD of a text without a character",
              "ask before: IF s <> \"\" …"};
    case ArithmeticError::ShiftOutOfRange:
      return {code::kShiftOutOfRange, "a shift by less than 0 or more than 63 places",
              "an INT has 64 bits"};
    case ArithmeticError::ZeroVector:
      return {code::kZeroVector, "UNIT of a VEC of no length, which has no direction",
              "ask before: IF NORM(v) > …"};
  }
  return {};
}

namespace arithmetic {

Error integer_power(std::int64_t base, std::int64_t exponent, std::int64_t& result) {
  std::int64_t product = 1;
  while (true) {
    if ((exponent & 1) != 0) {
      if (multiply(product, base, product) != Error::None) return Error::IntegerOverflow;
    }
    exponent >>= 1;
    if (exponent == 0) break;
    // The square is needed for a factor still to come, so its overflow is the result's.
    if (multiply(base, base, base) != Error::None) return Error::IntegerOverflow;
  }
  result = product;
  return Error::None;
}

Error real_power(double base, double exponent, double& result) {
  if (base == 0 && exponent < 0) return Error::DivisionByZero;
  if (base < 0 && exponent != std::trunc(exponent)) return Error::PowerUndefined;
  return store_finite(std::pow(base, exponent), result);
}

namespace {

bool is_whole(double value) { return value == std::trunc(value); }

/// a = b * quotient + rest, rounded down.
struct Division {
  double cut = 0;      ///< what fmod() leaves, exactly: it rounds towards zero
  double rest = 0;     ///< 0, or between 0 and b
  int correction = 0;  ///< from the quotient rounded towards zero to the one rounded down
};

Division divide_down(double a, double b) {
  const double cut = std::fmod(a, b);
  const bool crosses = cut != 0 && (cut < 0) != (b < 0);
  const double rest = crosses ? cut + b : cut;
  const double missing = crosses ? -cut : b - cut;
  const bool within_margin = missing / b <= kMargin && !(is_whole(a) && is_whole(b));
  // The rest of two whole numbers can be so near to b that a double cannot distinguish them.
  const bool full = within_margin || rest == b;
  return {cut, full ? 0 : rest, (full ? 1 : 0) - (crosses ? 1 : 0)};
}

/// a / b, which is a whole number but for `cut`. Beyond 2^53 a double holds only the leading digits
/// of it, so it is computed in two parts.
Error quotient_without(double cut, double a, double b, std::int64_t& result) {
  const double near = a / b;
  const double part = std::trunc(near - near * 0x1p-50);
  std::int64_t first = 0;
  if (const Error error = to_integer(part, first); error != Error::None) return error;
  const double rest = std::fma(-part, b, a) - cut;
  return add(first, static_cast<std::int64_t>(std::round(rest / b)), result);
}

}  // namespace

Error floor_modulo(double a, double b, double& result) {
  if (b == 0) return Error::DivisionByZero;
  return store_finite(divide_down(a, b).rest, result);
}

Error floor_divide(double a, double b, std::int64_t& result) {
  if (b == 0) return Error::DivisionByZero;
  const Division division = divide_down(a, b);
  std::int64_t quotient = 0;
  const Error error = quotient_without(division.cut, a, b, quotient);
  return error != Error::None ? error : add(quotient, division.correction, result);
}

Error turns(double from, double to, double step, std::int64_t& result) {
  // 2^53: up to here every count is a double of its own, and from + i * step is meant exactly.
  constexpr double kMost = 9007199254740992.0;
  if (step == 0) return Error::ZeroStep;
  const double last = std::floor((to - from) / step + kMargin);
  if (!(last < kMost)) return Error::TooManyTurns;
  if (last < 0) {
    result = 0;
    return Error::None;
  }
  if (!std::isfinite(from + last * step)) return Error::NotFinite;
  result = static_cast<std::int64_t>(last) + 1;
  return Error::None;
}

Error turns(std::int64_t from, std::int64_t to, std::int64_t step, std::int64_t& result) {
  if (step == 0) return Error::ZeroStep;
  result = 0;
  if (step > 0 ? to < from : to > from) return Error::None;
  // Unsigned, since the distance of two INTs may be as large as 2^64 - 1.
  using Distance = std::uint64_t;
  const Distance distance = step > 0 ? static_cast<Distance>(to) - static_cast<Distance>(from)
                                     : static_cast<Distance>(from) - static_cast<Distance>(to);
  const Distance stride =
      step > 0 ? static_cast<Distance>(step) : Distance{0} - static_cast<Distance>(step);
  const Distance last = distance / stride;
  if (last >= Distance{1} << 53) return Error::TooManyTurns;
  result = static_cast<std::int64_t>(last) + 1;
  return Error::None;
}

}  // namespace arithmetic
}  // namespace rob::lang
