// DIV and MOD, with every sign, against exact whole numbers of 128 bits.
#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <random>
#include <sstream>
#include <string>

#include <fmt/format.h>

#include "lang/values/arithmetic.h"
#include "tests/lang/program_run.h"

namespace {

namespace arithmetic = rob::lang::arithmetic;
using rob::lang::ArithmeticError;
using rob::test::ProgramRun;

__extension__ using Wide = __int128;

/// Operands are so many of these: a power of two, so that a double and a decimal hold them exactly.
constexpr double kUnit = 1.0 / 1024;

Wide floored(Wide a, Wide b) {
  const Wide quotient = a / b;
  return quotient * b != a && (a < 0) != (b < 0) ? quotient - 1 : quotient;
}

struct Pair {
  std::int64_t a;
  std::int64_t b;
};

/// Of many sizes, and with every sign.
Pair random_pair(std::mt19937_64& random) {
  const auto below = [&](int bits) { return static_cast<std::int64_t>(random() >> (64 - bits)); };
  const auto a = below(4 + static_cast<int>(random() % 36));
  const auto b = 1 + below(1 + static_cast<int>(random() % 19));
  return {random() % 2 == 0 ? a : -a, random() % 2 == 0 ? b : -b};
}

}  // namespace

TEST_CASE("DIV and MOD of REALs round down, with every sign, computed and folded") {
  std::mt19937_64 random(1);
  for (int i = 0; i < 1000; ++i) {
    const auto [a, b] = random_pair(random);
    const auto units = [](std::int64_t n) {
      return fmt::format("{:.10f}", static_cast<double>(n) * kUnit);
    };
    const std::string computed = "PRINT a DIV b, \" \", a MOD b, \" \"";
    const std::string folded = fmt::format(", {0} DIV {1}, \" \", {0} MOD {1}", units(a), units(b));
    ProgramRun program(
        fmt::format("VAR a = {}\nVAR b = {}\n{}{}", units(a), units(b), computed, folded));
    const std::string dividend = units(a);
    const std::string divisor = units(b);
    CAPTURE(dividend);
    CAPTURE(divisor);
    REQUIRE(program.compiled());
    std::istringstream printed(program.printed());
    const Wide quotient = floored(a, b);
    const double rest = static_cast<double>(a - b * quotient) * kUnit;
    for (int way = 0; way < 2; ++way) {
      std::int64_t div = 0;
      double mod = 0;
      printed >> div >> mod;
      REQUIRE(static_cast<bool>(printed));
      CHECK(div == static_cast<std::int64_t>(quotient));
      CHECK(mod == rest);
    }
  }
}

TEST_CASE("a quotient of REALs that a double does not hold is exact all the same") {
  std::mt19937_64 random(2);
  for (int i = 0; i < 10'000; ++i) {
    // 53 bits by up to 11: a quotient between 2^42 and 2^63.
    const auto a = static_cast<std::int64_t>(random() >> 11U);
    const auto b = static_cast<std::int64_t>(1 + (random() >> 53U));
    const int shift = static_cast<int>(random() % 11);
    const Wide quotient = floored(static_cast<Wide>(-a) << shift, b);
    std::int64_t div = 0;
    const double dividend = std::ldexp(-static_cast<double>(a), shift);
    CAPTURE(dividend);
    CAPTURE(b);
    const auto error = arithmetic::floor_divide(dividend, static_cast<double>(b), div);
    if (quotient < std::numeric_limits<std::int64_t>::min()) {
      CHECK(error == ArithmeticError::IntegerOverflow);
    } else {
      REQUIRE(error == ArithmeticError::None);
      CHECK(div == static_cast<std::int64_t>(quotient));
    }
  }
}

TEST_CASE("a rest is 0 or has the sign of the divisor, and is less than it") {
  std::mt19937_64 random(3);
  const auto any = [&] {
    const double size = std::exp2(static_cast<double>(random() % 200) - 100);
    const double share = 1 + static_cast<double>(random() >> 12U) * 0x1p-52;
    return random() % 2 == 0 ? size * share : -size * share;
  };
  for (int i = 0; i < 100'000; ++i) {
    const double a = any();
    const double b = any();
    double rest = 0;
    REQUIRE(arithmetic::floor_modulo(a, b, rest) == ArithmeticError::None);
    CAPTURE(a);
    CAPTURE(b);
    CHECK((rest == 0 || (rest < 0) == (b < 0)));
    CHECK(std::abs(rest) < std::abs(b));
  }
}

TEST_CASE("what decimal fractions cannot say exactly is whole within the margin of FOR") {
  ProgramRun program(R"(
FOR n = -20000 TO 20000 DO
  ASSERT (n * 1mm) DIV 1mm == n
  ASSERT (n * 1mm) DIV -1mm == -n
  ASSERT (n * 0.1deg) DIV 0.1deg == n
  ASSERT (n * 1mm) MOD 1mm < 1e-9mm
ENDFOR
ASSERT 300mm MOD 100mm == 0mm
ASSERT -300mm MOD -100mm == 0mm
ASSERT 300.0001mm MOD -100mm < -99.9mm
ASSERT -299.9999mm MOD 100mm < 0.001mm
ASSERT 0.9999mm DIV 1mm == 0
ASSERT 1999999999.0 MOD 2000000000.0 == 1999999999.0
)");
  program.finish();
  CHECK(program.vm().error().message == "");
}
