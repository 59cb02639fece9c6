#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <random>
#include <string>

#include "tests/lang/program_run.h"

/// Random expressions, computed three ways: by the Vm with variables, by constant folding, and
/// here in C++ with other means (128-bit integers, plain doubles). All must agree to the bit.
namespace {

using rob::test::ProgramRun;
using State = rob::lang::Vm::State;

/// A value, or nothing where the computation is an error.
using Whole = std::optional<std::int64_t>;
using Real = std::optional<double>;
using Truth = std::optional<bool>;

constexpr std::array<std::int64_t, 6> kWholes = {0, 1, -3, 7, 1'000'003, 9'223'372'036'854'775'807};
constexpr std::array<double, 5> kReals = {0.0, 0.5, -2.75, 1e10, 1e300};

template <typename T>
struct Sample {
  std::string text;
  std::optional<T> value;
};

class Generator {
 public:
  /// Without literals there is no constant part in a program with variables: a constant error is
  /// reported before the program runs, even where AND or OR would pass it over.
  explicit Generator(std::uint64_t seed, bool literals = true)
      : random_(seed), literals_(literals) {}

  Sample<std::int64_t> whole(int depth);
  Sample<double> real(int depth);
  Sample<bool> truth(int depth);

 private:
  // The distributions of the library differ between implementations.
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(random_() % n); }

  std::mt19937_64 random_;
  bool literals_;
};

/// Wide enough for any result of two INTs.
__extension__ using Wide = __int128;

Whole in_range(Wide value) {
  if (value > INT64_MAX || value < INT64_MIN) return std::nullopt;
  return static_cast<std::int64_t>(value);
}

Whole whole_result(char op, std::int64_t a, std::int64_t b) {
  const Wide wide_a = a;
  const Wide wide_b = b;
  if (op == '+') return in_range(wide_a + wide_b);
  if (op == '-') return in_range(wide_a - wide_b);
  if (op == '*') return in_range(wide_a * wide_b);
  if (b == 0) return std::nullopt;
  Wide remainder = wide_a % wide_b;
  if (remainder != 0 && (remainder < 0) != (wide_b < 0)) remainder += wide_b;
  if (op == 'M') return in_range(remainder);
  return in_range((wide_a - remainder) / wide_b);
}

Real finite(double value) { return std::isfinite(value) ? Real(value) : std::nullopt; }

Sample<std::int64_t> Generator::whole(int depth) {
  if (depth == 0 || below(5) == 0) {
    const std::size_t i = below(kWholes.size());
    if (!literals_ || below(2) == 0) return {"i" + std::to_string(i), kWholes[i]};
    const auto literal = static_cast<std::int64_t>(below(100));
    return {std::to_string(literal), literal};
  }
  const auto a = whole(depth - 1);
  const auto b = whole(depth - 1);
  const bool sound = a.value && b.value;
  switch (below(8)) {
    case 0:
      return {"(-" + a.text + ")", a.value ? in_range(-static_cast<Wide>(*a.value)) : Whole()};
    case 1:
      return {"MIN(" + a.text + ", " + b.text + ")",
              sound ? std::min(*a.value, *b.value) : Whole()};
    case 2:
      return {"ABS(" + a.text + ")",
              a.value ? (*a.value < 0 ? whole_result('-', 0, *a.value) : a.value) : Whole()};
    default: {
      constexpr std::array<std::string_view, 5> kOps = {"+", "-", "*", "DIV", "MOD"};
      const std::string op(kOps[below(kOps.size())]);
      return {"(" + a.text + " " + op + " " + b.text + ")",
              sound ? whole_result(op == "DIV"   ? 'D'
                                   : op == "MOD" ? 'M'
                                                 : op[0],
                                   *a.value, *b.value)
                    : Whole()};
    }
  }
}

Sample<double> Generator::real(int depth) {
  if (depth == 0 || below(5) == 0) {
    const std::size_t i = below(kReals.size());
    if (below(2) == 0) return {"r" + std::to_string(i), kReals[i]};
    const std::size_t n = below(100);
    return {std::to_string(n) + ".25", static_cast<double>(n) + 0.25};
  }
  if (below(6) == 0) {
    const auto n = whole(depth - 1);
    return {"REAL(" + n.text + ")", n.value ? Real(static_cast<double>(*n.value)) : Real()};
  }
  const auto a = real(depth - 1);
  const auto b = real(depth - 1);
  const bool sound = a.value && b.value;
  switch (below(6)) {
    case 0:
      return {"(-" + a.text + ")", a.value ? Real(-*a.value) : Real()};
    case 1:
      return {"(" + a.text + " + " + b.text + ")", sound ? finite(*a.value + *b.value) : Real()};
    case 2:
      return {"(" + a.text + " - " + b.text + ")", sound ? finite(*a.value - *b.value) : Real()};
    case 3:
      return {"(" + a.text + " * " + b.text + ")", sound ? finite(*a.value * *b.value) : Real()};
    case 4:
      return {"MAX(" + a.text + ", " + b.text + ")",
              sound ? Real(std::max(*a.value, *b.value)) : Real()};
    default:
      return {"(" + a.text + " / " + b.text + ")",
              sound && *b.value != 0 ? finite(*a.value / *b.value) : Real()};
  }
}

/// AND and OR compute their right side only where it matters, so an error there may not show.
Sample<bool> Generator::truth(int depth) {
  if (depth == 0 || below(3) == 0) {
    const auto a = whole(2);
    const auto b = whole(2);
    const bool sound = a.value && b.value;
    if (below(2) == 0) {
      return {"(" + a.text + " < " + b.text + ")", sound ? Truth(*a.value < *b.value) : Truth()};
    }
    return {"(" + a.text + " <> " + b.text + ")", sound ? Truth(*a.value != *b.value) : Truth()};
  }
  const auto a = truth(depth - 1);
  const auto b = truth(depth - 1);
  switch (below(4)) {
    case 0:
      return {"(" + a.text + " AND " + b.text + ")", a.value == Truth(true) ? b.value : a.value};
    case 1:
      return {"(" + a.text + " OR " + b.text + ")", a.value == Truth(false) ? b.value : a.value};
    case 2:
      return {"(" + a.text + " XOR " + b.text + ")",
              a.value && b.value ? Truth(*a.value != *b.value) : Truth()};
    default:
      return {"(NOT " + a.text + ")", a.value ? Truth(!*a.value) : Truth()};
  }
}

std::string declarations(const std::string& word) {
  std::string text;
  for (std::size_t i = 0; i < kWholes.size(); ++i) {
    text += word + " i" + std::to_string(i) + " = " + std::to_string(kWholes[i]) + "\n";
  }
  constexpr std::array<const char*, 5> kTexts = {"0.0", "0.5", "-2.75", "1e10", "1e300"};
  for (std::size_t i = 0; i < kReals.size(); ++i) {
    text += word + " r" + std::to_string(i) + " = " + kTexts[i] + "\n";
  }
  return text;
}

/// What a program prints, or nothing if it is refused or fails.
std::optional<std::string> outcome(const std::string& source) {
  ProgramRun program(source);
  if (!program.compiled() || program.finish() == State::Failed) return std::nullopt;
  return program.printed();
}

std::string text_of(std::int64_t value) { return std::to_string(value); }
std::string text_of(bool value) { return value ? "TRUE" : "FALSE"; }

template <typename T>
void check_three_ways(const Sample<T>& sample) {
  CAPTURE(sample.text);
  const auto computed = outcome(declarations("VAR") + "PRINT " + sample.text);
  const auto folded = outcome(declarations("CONST") + "PRINT " + sample.text);
  REQUIRE(computed.has_value() == sample.value.has_value());
  REQUIRE(folded == computed);
  if (!sample.value) return;
  if constexpr (std::is_same_v<T, double>) {
    CHECK(std::strtod(computed->c_str(), nullptr) == *sample.value);
  } else {
    CHECK(*computed == text_of(*sample.value));
  }
}

}  // namespace

TEST_CASE("random whole-number expressions: Vm, folding and C++ agree") {
  Generator generator(1);
  for (int i = 0; i < 1000; ++i) check_three_ways(generator.whole(5));
}

TEST_CASE("random real expressions: Vm, folding and C++ agree to the bit") {
  Generator generator(2);
  for (int i = 0; i < 1000; ++i) check_three_ways(generator.real(5));
}

TEST_CASE("random conditions: Vm, folding and C++ agree, short circuits included") {
  Generator generator(3, false);
  for (int i = 0; i < 1000; ++i) check_three_ways(generator.truth(4));
}
