#include "motion/space/cycle_instant.h"

#include <cstdlib>
#include <string>

#include <doctest/doctest.h>

using rob::motion::cycle_instant;

namespace {

/// The double nearest to k·10^-3 · `milliseconds`, found by the C library's reading of the decimal.
double nearest(std::int64_t k, int milliseconds) {
  return std::strtod((std::to_string(k * milliseconds) + "e-3").c_str(), nullptr);
}

}  // namespace

TEST_CASE("a cycle begins at the double nearest to its decimal instant") {
  CHECK(1528 * 0.01 != 15.28);
  CHECK(cycle_instant(1528, 0.01) == 15.28);
  CHECK(cycle_instant(0, 0.01) == 0);
  for (const int milliseconds : {1, 2, 4, 5, 8, 10, 20, 40}) {
    const double period = milliseconds * 1e-3;
    for (std::int64_t k = 0; k < 200'000; k += 7) {
      REQUIRE(cycle_instant(k, period) == nearest(k, milliseconds));
    }
  }
}

TEST_CASE("two rates have the same instants where they meet") {
  for (std::int64_t k = 0; k < 100'000; ++k) {
    REQUIRE(cycle_instant(2 * k, 0.005) == cycle_instant(k, 0.01));
  }
}

TEST_CASE("a period that is no whole number of nanoseconds is multiplied") {
  const double period = 1.0 / 300;
  CHECK(cycle_instant(7, period) == 7 * period);
}
