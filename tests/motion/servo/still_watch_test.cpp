#include "motion/servo/still_watch.h"

#include <doctest/doctest.h>

#include "tests/motion/servo/two_axes.h"

namespace rob::motion {
namespace {

using test::both;

}  // namespace

TEST_CASE("axes that have moved by no more than a count for a tenth of a second are still") {
  StillWatch watch(both(1e-3, 1e-2));
  watch.look(both(1, 1), 10);
  CHECK_FALSE(watch.still());
  watch.look(both(1.0009, 1.009), 10.06);
  CHECK_FALSE(watch.still());
  watch.look(both(1, 1), 10.11);
  CHECK(watch.still());
}

TEST_CASE("one axis that moves on, however slowly, is not still") {
  StillWatch watch(both(1e-3, 1e-3));
  for (int i = 0; i < 100; ++i) {
    watch.look(both(0, 2e-4 * i), 0.01 * i);  // a count in 50 ms
    CHECK_FALSE(watch.still());
  }
}

TEST_CASE("axes that stand because they were sent nowhere have not come to rest") {
  StillWatch watch(both(1e-3, 1e-3));
  watch.send(both(1, 1), 10);
  watch.look(both(1, 1), 10.01);
  watch.look(both(1, 1), 10.2);
  CHECK(watch.still());
  watch.send(both(2, 1), 10.2);
  CHECK_FALSE(watch.still());
  watch.look(both(1, 1), 10.19);  // reported before
  watch.look(both(1, 1), 10.295);
  CHECK_FALSE(watch.still());
  watch.look(both(2, 1), 10.3);
  CHECK_FALSE(watch.still());
  watch.send(both(2.0005, 1), 10.35);  // less than a count
  watch.look(both(2, 1), 10.41);
  CHECK(watch.still());
}

TEST_CASE("a report that comes again is no proof that time has passed") {
  StillWatch watch(both(1e-3, 1e-3));
  for (int i = 0; i < 100; ++i) watch.look(both(1, 1), 5);
  CHECK_FALSE(watch.still());
}

}  // namespace rob::motion
