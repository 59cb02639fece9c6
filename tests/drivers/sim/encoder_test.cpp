#include "drivers/sim/encoder.h"

#include <doctest/doctest.h>

#include <cmath>

namespace rob::drivers {

TEST_CASE("a block of samples makes of the estimate what they make of it in turn") {
  for (int count = 1; count <= Encoder::kBlock; ++count) {
    Encoder at_once(1e-6);
    Encoder in_turn(1e-6);
    at_once.settle(0.2, 0.7);
    in_turn.settle(0.2, 0.7);
    Encoder::Block places(count);
    for (int i = 0; i < count; ++i) places[i] = 0.2 + 1e-4 * (i + 1) * (1 + 0.1 * (i % 3));
    at_once.sample(places);
    for (int i = 0; i < count; ++i) in_turn.sample(places[i]);
    CHECK(at_once.velocity() == doctest::Approx(in_turn.velocity()).epsilon(1e-10));
    for (Encoder* const encoder : {&at_once, &in_turn}) encoder->sample(0.21);  // x, too
    CHECK(at_once.velocity() == doctest::Approx(in_turn.velocity()).epsilon(1e-10));
  }
}

TEST_CASE("an encoder reports the nearest whole count") {
  const Encoder encoder(0.25);
  CHECK(encoder.position(0.12) == 0);
  CHECK(encoder.position(0.13) == 0.25);
  CHECK(encoder.position(-1.1) == -1.0);
}

TEST_CASE(
    "the velocity estimate follows a ramp without error, to less than a count a millisecond") {
  Encoder encoder(1e-6);
  encoder.settle(0, 0);
  for (int k = 1; k <= 4000; ++k) {
    encoder.sample(0.02 * k * Encoder::kPeriod);
    if (k > 200) CHECK(std::abs(encoder.velocity() - 0.02) < 0.0002);
  }
}

TEST_CASE("the velocity estimate answers a step as two lags of 1/ω") {
  // ω²/(s + ω)²: 1 − (1 + ωt)·exp(−ωt). So fine an encoder has no counts to speak of.
  Encoder encoder(1e-12);
  encoder.settle(0, 0);
  for (int k = 1; k <= 100; ++k) {
    const double t = k * Encoder::kPeriod;
    encoder.sample(0.02 * t);
    const double x = Encoder::kBandwidth * t;
    const double expected = 0.02 * (1 - (1 + x) * std::exp(-x));
    CHECK(std::abs(encoder.velocity() - expected) < 0.02 * 0.05);
  }
}

TEST_CASE("at standstill the velocity estimate is zero, not nearly zero") {
  Encoder encoder(1e-6);
  encoder.settle(0.1, 0.02);
  for (int k = 0; k < 400; ++k) encoder.sample(0.1);
  CHECK(encoder.velocity() == 0);
}

TEST_CASE("a settled estimate needs no time to find its velocity") {
  Encoder encoder(1e-6);
  encoder.settle(0, 0.02);
  for (int k = 1; k <= 100; ++k) {
    encoder.sample(0.02 * k * Encoder::kPeriod);
    CHECK(std::abs(encoder.velocity() - 0.02) < 0.0002);
  }
}

}  // namespace rob::drivers
