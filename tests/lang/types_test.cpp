#include "lang/values/types.h"

#include <doctest/doctest.h>

using namespace rob::lang;

TEST_CASE("a speed is a length per time, and a force a mass times an acceleration") {
  CHECK(kLength / kTime == kSpeed);
  CHECK(kAngle / kTime == kAngularSpeed);
  CHECK(kMass * kAcceleration == kForce);
  CHECK(kForce * kLength == kTorque);
  CHECK(kNone / kTime == kFrequency);
}

TEST_CASE("an angle is not a plain number") { CHECK_FALSE(kAngle.none()); }

TEST_CASE("a power multiplies the exponents") {
  CHECK(power(kLength, 2) == kLength * kLength);
  CHECK(power(kSpeed, -1) == kTime / kLength);
  CHECK(power(kSpeed, 0).none());
}

TEST_CASE("exponents beyond their range stick at its end instead of wrapping around") {
  const Dimension high = power(kLength, 127);
  CHECK(high * kLength == high);
  CHECK(power(kLength, 1000000).length == 127);
  CHECK(power(kLength, -1000000).length == -128);
}

TEST_CASE("dimensions and types have names for people") {
  CHECK(in_words(kLength) == "a length");
  CHECK(in_words(kAngle) == "an angle");
  CHECK(in_words(kNone) == "a plain number");
  CHECK(in_words(kMass * kLength) == "a [kg*mm]");
  CHECK(in_words(Type::integer()) == "a whole number");
  CHECK(in_words(Type::string()) == "a text");
  CHECK(in_words(Type::boolean()) == "TRUE or FALSE");
  CHECK(in_words(Type::real(kSpeed)) == "a speed");
}
