#include "lang/values/number_text.h"

#include <doctest/doctest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <random>

#include "lang/syntax/parser.h"
#include "lang/values/units.h"

using namespace rob::lang;

namespace {

const double kPi = 3.14159265358979323846;

/// What a program reads where `text` stands as a value.
double read_back(const std::string& text) {
  Diagnostics diagnostics;
  const Program program = parse("x = " + text, diagnostics);
  REQUIRE_MESSAGE(!diagnostics.has_errors(), text);
  const Expr* expr = std::get<Assign>(program.statements.at(0).node).value.get();
  double sign = 1;
  if (const auto* unary = std::get_if<Unary>(&expr->node)) {
    sign = -1;
    expr = unary->operand.get();
  }
  return sign * std::get<NumberLiteral>(expr->node).value;
}

std::size_t significant_digits(const std::string& text) {
  const std::string digits = text.substr(0, text.find_first_of("ekmdsNHV"));
  std::string only;
  for (const char c : digits) {
    if (c >= '0' && c <= '9') only += c;
  }
  const std::size_t first = only.find_first_not_of('0');
  const std::size_t last = only.find_last_not_of('0');
  return first == std::string::npos ? 0 : last - first + 1;
}

}  // namespace

TEST_CASE("numbers are written as the language reads them, in the units of the workshop") {
  CHECK(number_text(0.02, kLength) == "20mm");
  CHECK(number_text(0.25, kSpeed) == "250mm/s");
  CHECK(number_text(1.5, kTime) == "1.5s");
  CHECK(number_text(kPi / 2, kAngle) == "90deg");
  CHECK(number_text(kPi / 9, kAngularSpeed) == "20deg/s");
  CHECK(number_text(7, kNone) == "7");
  CHECK(number_text(0.1, kNone) == "0.1");
  CHECK(number_text(-0.009, kLength) == "-9mm");
  CHECK(number_text(30000, {.mass = 1, .time = -2}) == "30N/mm");
  CHECK(number_text(12.5, kForce) == "12.5N");
  CHECK(number_text(0.123456, kLength) == "123.456mm");
  CHECK(number_text(1000, kLength) == "1000000mm");
}

TEST_CASE("no fraction is written where there is none, and zero has no sign") {
  CHECK(number_text(3, kNone) == "3");
  CHECK(number_text(0, kLength) == "0mm");
  CHECK(number_text(-0.0, kLength) == "0mm");
  CHECK(number_text(-0.0, kNone) == "0");
}

TEST_CASE("exponents are written below 1e-5 and from 1e16 on only") {
  CHECK(number_text(1e-5, kNone) == "0.00001");
  CHECK(number_text(9.9e-6, kNone) == "9.9e-6");
  CHECK(number_text(1e-6, kNone) == "1e-6");
  CHECK(number_text(1e15, kNone) == "1000000000000000");
  CHECK(number_text(1e16, kNone) == "1e16");
  CHECK(number_text(1.25e20, kNone) == "1.25e20");
  CHECK(number_text(1e-9, kLength) == "1e-6mm");
  CHECK(number_text(5e-324, kNone) == "5e-324");
  CHECK(number_text(1.7976931348623157e308, kNone) == "1.7976931348623157e308");
}

TEST_CASE("what is written is read back to the same bits, in every decimal unit") {
  std::mt19937_64 random(2010);
  std::uniform_real_distribution<double> exponent(-12, 12);
  for (const Dimension& d :
       {kNone, kLength, kSpeed, kAcceleration, kTime, kForce, kTorque, kMass, kFrequency, kVoltage,
        Dimension{.mass = 1, .time = -2}, Dimension{.length = 2}, Dimension{.length = -1}}) {
    for (int i = 0; i < 2000; ++i) {
      const double value = (i % 2 == 0 ? 1 : -1) * std::pow(10.0, exponent(random));
      const std::string text = number_text(value, d);
      INFO(text);
      CHECK(std::bit_cast<std::uint64_t>(read_back(text)) == std::bit_cast<std::uint64_t>(value));
      CHECK(significant_digits(text) <= 17);
    }
  }
}

TEST_CASE("a length typed with few digits is written with those digits") {
  for (int tenths = 1; tenths < 20000; tenths += 7) {
    const std::string typed = std::to_string(tenths / 10) + "." + std::to_string(tenths % 10);
    const double value = to_si(typed, *find_unit("mm")).value();
    const std::string expected = tenths % 10 == 0 ? std::to_string(tenths / 10) : typed;
    CHECK(number_text(value, kLength) == expected + "mm");
  }
}

TEST_CASE("an angle typed with few digits is written with those digits") {
  for (int hundredths = 1; hundredths < 36000; hundredths += 13) {
    std::string typed = std::to_string(hundredths / 100);
    const int rest = hundredths % 100;
    if (rest != 0) typed += rest < 10 ? ".0" + std::to_string(rest) : "." + std::to_string(rest);
    if (rest != 0 && typed.back() == '0') typed.pop_back();
    const double value = to_si(typed, *find_unit("deg")).value();
    CHECK(number_text(value, kAngle) == typed + "deg");
  }
}

TEST_CASE("an angle is read back to the same bits, or has no decimal in degrees that does so") {
  std::mt19937_64 random(2010);
  std::uniform_real_distribution<double> angle(-2 * kPi, 2 * kPi);
  const double degree = find_unit("deg")->factor;
  int exact = 0;
  for (int i = 0; i < 5000; ++i) {
    const double value = angle(random);
    const std::string text = number_text(value, kAngle);
    const double again = read_back(text);
    CHECK(std::abs(again - value) <= 2 * std::abs(std::nextafter(value, 10) - value));
    if (again == value) {
      ++exact;
      continue;
    }
    // A second look: no number near the quotient gives the angle when it is multiplied.
    double near = value / degree;
    for (int k = 0; k < 8; ++k) near = std::nextafter(near, -1e9);
    for (int k = 0; k < 16; ++k, near = std::nextafter(near, 1e9)) CHECK(near * degree != value);
  }
  CHECK(exact > 2500);
}

TEST_CASE("an angle beyond the doubles in degrees is written in rad") {
  CHECK(number_text(1e307, kAngle) == "1e307rad");
  CHECK(number_text(-1e308, kAngularSpeed) == "-1e308rad/s");
}
