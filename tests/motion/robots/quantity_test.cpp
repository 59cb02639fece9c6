#include "motion/robots/quantity.h"

#include <doctest/doctest.h>

#include <numbers>
#include <stdexcept>
#include <string>

using namespace rob::motion;

namespace {

/// What is said about it; empty if nothing is wrong.
std::string problem(std::string_view text, Quantity quantity) {
  try {
    parse_quantity(text, quantity);
    return "";
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

bool contains(const std::string& text, std::string_view part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("quantities are read as SI, to the nearest double") {
  CHECK(parse_quantity("400 mm", Quantity::Length) == 0.4);
  CHECK(parse_quantity("9 mm", Quantity::Length) == 0.009);
  CHECK(parse_quantity("1 um", Quantity::Length) == 1e-6);
  CHECK(parse_quantity("-2.5 m", Quantity::Length) == -2.5);
  CHECK(parse_quantity("20 mm/s", Quantity::Speed) == 0.02);
  CHECK(parse_quantity("1000 mm/s^3", Quantity::Jerk) == 1.0);
  CHECK(parse_quantity("10 ms", Quantity::Time) == 0.01);
  CHECK(parse_quantity("1.375 s", Quantity::Time) == 1.375);
  CHECK(parse_quantity("180 deg", Quantity::Angle) == doctest::Approx(std::numbers::pi));
  CHECK(parse_quantity("20 deg/s", Quantity::AngularSpeed) ==
        doctest::Approx(std::numbers::pi / 9));
  CHECK(parse_quantity("0.02 kg*m^2", Quantity::Inertia) == 0.02);
  CHECK(parse_quantity("3e2 N", Quantity::Force) == 300);
  CHECK(parse_quantity("40 rad/s", Quantity::Bandwidth) == 40);
}

TEST_CASE("a quantity without a unit is refused") {
  CHECK(contains(problem("20", Quantity::Speed), "has no unit"));
  CHECK(contains(problem("20 ", Quantity::Speed), "has no unit"));
}

TEST_CASE("a unit of another quantity is refused, and the right ones are named") {
  const std::string text = problem("20 mm", Quantity::Speed);
  CHECK(contains(text, "unit of something else"));
  CHECK(contains(text, "m/s, mm/s"));
  CHECK(contains(problem("20 mm/s", Quantity::AngularSpeed), "rad/s, deg/s"));
  CHECK(contains(problem("40 deg/s", Quantity::Bandwidth), "unit of something else"));
}

TEST_CASE("an unknown unit is refused") {
  CHECK(contains(problem("20 furlong", Quantity::Length), "unknown unit"));
  CHECK(contains(problem("20 MM", Quantity::Length), "unknown unit"));
  CHECK(contains(problem("20 mm mm", Quantity::Length), "unknown unit"));
  CHECK(contains(problem("0x10 mm", Quantity::Length), "unknown unit"));
  CHECK(contains(problem("1,5 mm", Quantity::Length), "unknown unit"));
}

TEST_CASE("what is no number is refused") {
  for (const char* text : {"", "mm", " 1 mm", "+1 mm", "-", "nan mm", "inf mm", "-inf mm", ".5 mm"})
    CHECK(contains(problem(text, Quantity::Length), "does not begin with a number"));
  CHECK(contains(problem("1e400 mm", Quantity::Length), "beyond what a number can be"));
}
