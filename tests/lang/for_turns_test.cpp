// How often a FOR runs: counted exactly up to 2^53, refused beyond.
#include <doctest/doctest.h>

#include <cstdint>
#include <limits>

#include "lang/values/arithmetic.h"

namespace {

namespace arithmetic = rob::lang::arithmetic;
using Error = rob::lang::ArithmeticError;
using Limits = std::numeric_limits<std::int64_t>;

constexpr std::int64_t kMost = std::int64_t{1} << 53;

struct Turns {
  Error error;
  std::int64_t count;
  bool operator==(const Turns&) const = default;
};

template <typename Number>
Turns turns(Number from, Number to, Number step) {
  std::int64_t count = 0;
  const Error error = arithmetic::turns(from, to, step, count);
  return {error, error == Error::None ? count : 0};
}

const Turns kTooMany{Error::TooManyTurns, 0};

}  // namespace

TEST_CASE("a FOR over INTs runs 2^53 times and not once more") {
  const auto ints = turns<std::int64_t>;
  CHECK(ints(1, kMost, 1) == Turns{Error::None, kMost});
  CHECK(ints(0, kMost, 1) == kTooMany);
  CHECK(ints(-1, -kMost, -1) == Turns{Error::None, kMost});
  CHECK(ints(0, -kMost, -1) == kTooMany);
  // From the least to the greatest INT it is 2^64 - 1.
  CHECK(ints(Limits::min(), Limits::max(), 2048) == Turns{Error::None, kMost});
  CHECK(ints(Limits::min(), Limits::max(), 2047) == kTooMany);
  CHECK(ints(Limits::max(), Limits::min(), -2048) == Turns{Error::None, kMost});
  CHECK(ints(Limits::max(), Limits::min(), Limits::min()) == Turns{Error::None, 2});
  CHECK(ints(Limits::max(), Limits::min(), 1) == Turns{Error::None, 0});
  CHECK(ints(0, 1, 0) == Turns{Error::ZeroStep, 0});
}

TEST_CASE("a FOR over REALs runs 2^53 times and not once more") {
  const auto reals = turns<double>;
  const auto most = static_cast<double>(kMost);
  CHECK(reals(1, most, 1) == Turns{Error::None, kMost});
  CHECK(reals(0, most, 1) == kTooMany);
  CHECK(reals(-1, -most, -1) == Turns{Error::None, kMost});
  CHECK(reals(0, -most, -1) == kTooMany);
  CHECK(reals(0, 0.3, 0.1) == Turns{Error::None, 4});
  CHECK(reals(0, -0.3, -0.1) == Turns{Error::None, 4});
  CHECK(reals(0, 0.3, -0.1) == Turns{Error::None, 0});
  CHECK(reals(0, 1, 0) == Turns{Error::ZeroStep, 0});
}
