#include "drivers/contact/noise.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <initializer_list>

#include "base/split_mix.h"

namespace rob::drivers {

TEST_CASE("the numbers are those of SplitMix64 as it is published") {
  SplitMix random(1234567);
  for (const std::uint64_t number :
       {6457827717110365317U, 3203168211198807973U, 9817491932198370423U, 4593380528125082431U,
        16408922859458223821U})
    CHECK(random.next() == number);
}

TEST_CASE("noise is nearly normal: its mean, its deviation, and never beyond 6") {
  constexpr int kCount = 100'000;
  Noise noise(7);
  double sum = 0;
  double squares = 0;
  for (int i = 0; i < kCount; ++i) {
    const double value = noise.normal();
    CHECK_FALSE(std::abs(value) > 6);
    sum += value;
    squares += value * value;
  }
  // Four times the deviations of mean and variance of so many.
  CHECK(std::abs(sum / kCount) < 4 / std::sqrt(kCount));
  CHECK(std::abs(squares / kCount - 1) < 4 * std::sqrt(2.0 / kCount));
}

}  // namespace rob::drivers
