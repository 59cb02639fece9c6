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
  CHECK(si_text(0.02, kLength) == "20mm");
  CHECK(si_text(0.25, kSpeed) == "250mm/s");
  CHECK(si_text(1.5, kTime) == "1.5s");
  CHECK(si_text(kPi / 2, kAngle) == "90deg");
  CHECK(si_text(kPi / 9, kAngularSpeed) == "20deg/s");
  CHECK(si_text(7, kNone) == "7");
  CHECK(si_text(0.1, kNone) == "0.1");
  CHECK(si_text(-0.009, kLength) == "-9mm");
  CHECK(si_text(30000, {.mass = 1, .time = -2}) == "30N/mm");
  CHECK(si_text(12.5, kForce) == "12.5N");
  CHECK(si_text(0.123456, kLength) == "123.456mm");
  CHECK(si_text(1000, kLength) == "1000000mm");
}

TEST_CASE("a value from SI is written with the digits that it had in mm and deg") {
  for (int i = 1; i < 100000; i += 7) {
    const double thousandths = i / 1000.0;
    CHECK(si_text(to_si(thousandths, kLength), kLength) == number_text(thousandths, kLength));
    CHECK(si_text(to_si(thousandths, kAngle), kAngle) == number_text(thousandths, kAngle));
  }
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
  CHECK(si_text(1e-9, kLength) == "1e-6mm");
  CHECK(number_text(5e-324, kNone) == "5e-324");
  CHECK(number_text(1.7976931348623157e308, kNone) == "1.7976931348623157e308");
}

TEST_CASE("what is written is read back to the same bits, in every decimal unit") {
  std::mt19937_64 random(2010);
  std::uniform_real_distribution<double> exponent(-12, 12);
  for (const Dimension& d :
       {kNone, kLength, kAngle, kAngularSpeed, kSpeed, kAcceleration, kTime, kForce, kTorque, kMass,
        kFrequency, kVoltage, Dimension{.mass = 1, .time = -2}, Dimension{.length = 2},
        Dimension{.length = -1}}) {
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
    const double value = quantity_of(typed, *find_unit("mm")).value();
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
    const double value = quantity_of(typed, *find_unit("deg")).value();
    CHECK(number_text(value, kAngle) == typed + "deg");
  }
}
