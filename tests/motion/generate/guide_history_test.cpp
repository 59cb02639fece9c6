#include "motion/generate/guide_history.h"

#include <doctest/doctest.h>

using namespace rob::motion;

TEST_CASE("between two parts the guide is never beyond the place at which the second begins") {
  GuideHistory history;
  history.begin(0, 0);
  history.keep({1, 0, 0.5, 0});
  history.keep({2, 0.4, 0.5, 0});  // by rounding less than 0.5; much less here
  CHECK(history.sigma(1.5) == doctest::Approx(0.25));
  CHECK(history.sigma(1.9) == 0.4);
  CHECK(history.sigma(2.2) == doctest::Approx(0.5));  // no part follows
}
